#include "study/pipeline.h"

#include <algorithm>
#include <cstdlib>

namespace blysk::study {
namespace {

constexpr std::size_t kChunkTriangles = 8192;  // as in a frame

}  // namespace

Pipeline::Pipeline(const Scene& scene, const RenderOptions& options, Isa isa)
    : options_(options), table_(kernels(isa)) {
  if (!plan_frame(scene, options_, plan_) || plan_.draws.size() != 1) std::abort();
  const int width = options_.width, height = options_.height;
  tiles_x_ = (width + kTileSize - 1) / kTileSize;
  tiles_ =
      static_cast<std::size_t>(tiles_x_) * static_cast<std::size_t>((height + kTileSize - 1) / kTileSize);
  vertices_.resize(plan_.vertices);
  rest_.resize(kChunkTriangles + 16);
  transform();
  assemble();
}

void Pipeline::transform() {
  const Draw& draw = plan_.draws[0].draw;
  table_.transform({draw.positions, plan_.vertices, draw.projection, vertices_.data()});
}

void Pipeline::assemble() {
  const DrawPlan& plan = plan_.draws[0];
  bins_.reset(tiles_, options_.limits.max_memory);
  AssembleJob job{};
  job.vertices = vertices_.data();
  job.indices = plan.draw.indices;
  job.width = options_.width;
  job.height = options_.height;
  job.tiles_x = tiles_x_;
  job.drop = plan.drop;
  job.owner = &bins_;
  job.bins = bins_.bins();
  job.rest = rest_.data();
  for (job.first = 0; job.first < plan.triangles; job.first += kChunkTriangles) {
    job.count = std::min(kChunkTriangles, plan.triangles - job.first);
    job.rest_count = 0;
    table_.assemble(job);
    assemble_rest(job, plan.draw.positions, plan.draw.projection);
  }
}

int Pipeline::rasterize_tile(std::size_t tile, TileBuffers& buffers) {
  const Bin* lists = bins_.bins();
  TileJob job{};
  job.x = static_cast<int>(tile) % tiles_x_ * kTileSize;
  job.y = static_cast<int>(tile) / tiles_x_ * kTileSize;
  job.width = std::min(kTileSize, options_.width - job.x);
  job.height = std::min(kTileSize, options_.height - job.y);
  job.tile = tile;
  job.vertices = vertices_.data();
  job.bins = &lists;
  job.bins_count = 1;
  job.background = plan_.background;
  job.buffers = &buffers;
  return table_.rasterize(job);
}

std::uint64_t Pipeline::rasterize() {
  std::uint64_t covered = 0;
  for (std::size_t i = 0; i < tiles_; ++i) covered += static_cast<std::uint64_t>(rasterize_tile(i, *reused_));
  return covered;
}

std::uint64_t Pipeline::keep_tiles() {
  kept_.resize(tiles_);
  std::uint64_t covered = 0;
  for (std::size_t i = 0; i < tiles_; ++i) covered += static_cast<std::uint64_t>(rasterize_tile(i, kept_[i]));
  return covered;
}

void Pipeline::shade(const MethodChoice& method) {
  const auto* found = std::find_if(table_.shadings, table_.shadings + table_.shadings_count,
                                   [&](const ShadingKernel& k) { return k.name == method.method->name; });
  ShadeJob job{};
  job.vertices = vertices_.data();
  job.draw = &plan_.draws[0].draw;
  job.rays = &plan_.view.rays;
  job.screen_linear = options_.interpolation == Interpolation::screen;
  job.transfer = options_.transfer;
  job.settings = method.values.data();
  for (std::size_t i = 0; i < kept_.size(); ++i) {
    job.x = static_cast<int>(i) % tiles_x_ * kTileSize;
    job.y = static_cast<int>(i) / tiles_x_ * kTileSize;
    job.width = std::min(kTileSize, options_.width - job.x);
    job.height = std::min(kTileSize, options_.height - job.y);
    job.buffers = &kept_[i];
    found->shade(job);
  }
}

}  // namespace blysk::study
