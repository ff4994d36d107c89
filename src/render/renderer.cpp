// The frame: vertices, triangles, tiles, each a parallel loop.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <new>

#include "blysk/render.h"
#include "core/threads.h"
#include "render/fragment_memory.h"
#include "render/frame.h"
#include "render/kernels.h"
#include "render/list_tile.h"
#include "render/planes.h"
#include "render/sample_memory.h"
#include "render/subpixels.h"

namespace blysk {
namespace {

using Clock = std::chrono::steady_clock;

double ms_between(Clock::time_point a, Clock::time_point b) {
  return std::chrono::duration<double, std::milli>(b - a).count();
}

// Work is cut where it no longer matters for balance, but still fits a second-level cache.
constexpr std::size_t kChunkVertices = 16384, kChunkTriangles = 8192;

Error out_of_memory(const RenderOptions& options) {
  return {ErrorCode::limit,
          "the frame needs more memory than there is or than the limit of " +
              std::to_string(options.limits.max_memory) +
              " bytes allows; raise --max-memory or choose a smaller --size",
          {},
          0};
}

struct Chunk {
  std::uint32_t draw;
  std::size_t first, count;
};

// What one thread owns.
struct Worker {
  ThreadBins bins;
  std::unique_ptr<TileBuffers> tile = std::make_unique<TileBuffers>();
  SampleMemory samples;
  SubpixelTile parts;
  ListTile lists;
  std::vector<std::uint32_t> rest;
  std::vector<float> normals;
  std::vector<std::uint8_t> seen_draws;
  std::unique_ptr<TileCounts> counts;  ///< if wanted
  std::vector<GlassEntry> counted_entries;
  FragmentCounter generated, live, most_live;
  bool blank = false;  ///< `tile` is clear: the last tile had nothing in it
  std::uint64_t culled = 0, drawn = 0, covered = 0;
};

}  // namespace

struct Renderer::State {
  explicit State(const RendererOptions& options)
      : table(kernels(options.isa)), pool(options.threads), workers(static_cast<std::size_t>(pool.size())) {}

  const Kernels& table;
  ThreadPool pool;
  std::vector<Worker> workers;
  std::vector<const Bin*> bin_lists;
  FramePlan plan;
  ShadeFunction shade = nullptr;  ///< of the plan's shading method
  std::vector<Chunk> chunks;
  Array<ScreenVertex> vertices;

  Status render(const Scene& scene, const RenderOptions& options, Frame& frame);

 private:
  void cut(std::size_t DrawPlan::*count, std::size_t size);
  void transform();
  void assemble(const RenderOptions& options, int tiles_x, std::size_t tiles);
  void draw_tiles(const RenderOptions& options, int tiles_x, std::size_t tiles, Frame& frame);
  [[nodiscard]] TileJob job_of(std::size_t tile, int tiles_x) const;
  [[nodiscard]] TileArea area_of(const TileJob& job) const;
  [[nodiscard]] bool is_empty(std::size_t tile) const;
  void draw_tile(Worker& worker, const RenderOptions& options, TileJob job, Frame& frame);
  void shade_draws(Worker& worker, ShadeJob& job, ShadeFunction function);
  void count_fragments(Worker& worker, const RenderOptions& options, const TileJob& job);
  void add_up(Worker& worker, const TileArea& area) const;
  void shade_tile(Worker& worker, const RenderOptions& options, const TileJob& job, ShadeJob& shading);
  void sum_up(const RenderOptions& options, FrameStatistics& statistics);
  [[nodiscard]] std::uint64_t memory_of_vertices() const { return plan.vertices * sizeof(ScreenVertex); }
  [[nodiscard]] std::uint64_t memory() const;
};

void Renderer::State::cut(std::size_t DrawPlan::*count, std::size_t size) {
  chunks.clear();
  for (std::uint32_t d = 0; d < plan.draws.size(); ++d) {
    const std::size_t total = plan.draws[d].*count;
    for (std::size_t first = 0; first < total; first += size)
      chunks.push_back({d, first, std::min(size, total - first)});
  }
}

void Renderer::State::transform() {
  cut(&DrawPlan::vertices, kChunkVertices);
  pool.for_each(chunks.size(), [&](int, std::size_t i) {
    const Chunk& c = chunks[i];
    const Draw& d = plan.draws[c.draw].draw;
    table.transform(
        {d.positions + c.first, c.count, d.projection, vertices.data() + d.vertex_base + c.first});
  });
}

void Renderer::State::assemble(const RenderOptions& options, int tiles_x, std::size_t tiles) {
  const std::size_t room = (options.limits.max_memory - memory_of_vertices()) / workers.size();
  for (Worker& w : workers) {
    w.bins.reset(tiles, room);
    w.rest.resize(kChunkTriangles + 16);
    w.culled = w.drawn = w.covered = 0;
    if (plan.sampling == Sampling::samples) w.samples.prepare(plan.glass);
    if (plan.lists.kind != ListPlan::Kind::none) w.lists.prepare(plan, room);
    if (!wants_counts(options)) {
      w.counts.reset();
    } else if (!w.counts) {
      w.counts = std::make_unique_for_overwrite<TileCounts>();
    }
    w.lists.count_in(w.counts.get());
    for (FragmentCounter* c : {&w.generated, &w.live, &w.most_live}) c->clear();
    w.blank = false;  // the background may have changed
  }
  cut(&DrawPlan::triangles, kChunkTriangles);
  pool.for_each(chunks.size(), [&](int worker, std::size_t i) {
    const Chunk& c = chunks[i];
    const DrawPlan& p = plan.draws[c.draw];
    Worker& w = workers[static_cast<std::size_t>(worker)];
    AssembleJob job{};
    job.vertices = vertices.data();
    job.indices = p.draw.indices;
    job.first = c.first;
    job.count = c.count;
    job.vertex_base = p.draw.vertex_base;
    job.id_base = p.draw.id_base;
    job.width = plan.width;
    job.height = plan.height;
    job.tiles_x = tiles_x;
    job.drop = p.drop;
    job.sampling = plan.sampling;
    job.transparent = p.transparent();
    job.owner = &w.bins;
    job.bins = w.bins.bins();
    job.rest = w.rest.data();
    table.assemble(job);
    assemble_rest(job, p.draw.positions, p.draw.projection);
    w.culled += job.culled;
    w.drawn += job.drawn;
  });
}

// Runs `function` for every draw that has a pixel in the tile.
void Renderer::State::shade_draws(Worker& worker, ShadeJob& job, ShadeFunction function) {
  if (plan.draws.size() == 1) {
    job.draw = &plan.draws[0].draw;
    function(job);
    return;
  }
  worker.seen_draws.assign(plan.draws.size(), 0);
  std::uint32_t last = kNoTriangle;
  const auto see = [&](std::uint32_t id) {
    if (id == last || id >= kManySurfaces) return;
    last = id;
    const auto after =
        std::upper_bound(plan.draws.begin(), plan.draws.end(), id,
                         [](std::uint32_t v, const DrawPlan& p) { return v < p.draw.id_base; });
    worker.seen_draws[static_cast<std::size_t>(after - plan.draws.begin()) - 1] = 1;
  };
  for (int row = 0; row < job.height; ++row) {
    for (int column = 0; column < job.width; ++column) see(job.buffers->id[row * kTileSize + column]);
  }
  for (int i = 0; job.samples != nullptr && i < job.samples->fragments; ++i) {
    see(static_cast<std::uint32_t>(job.samples->fragment_id[i]));
  }
  for (std::size_t d = 0; d < plan.draws.size(); ++d) {
    if (worker.seen_draws[d] == 0) continue;
    job.draw = &plan.draws[d].draw;
    function(job);
  }
}

// Of a tile without lists, which count themselves.
void Renderer::State::count_fragments(Worker& worker, const RenderOptions& options, const TileJob& job) {
  if (plan.sampling == Sampling::samples) {
    worker.samples.count(*job.buffers, *worker.counts);
  } else {
    count_centers(*job.buffers, *worker.counts);
  }
  if (options.want_complexity) count_generated(plan, job, worker.counted_entries, *worker.counts);
}

// Of a tile that is counted.
void Renderer::State::add_up(Worker& worker, const TileArea& area) const {
  const TileCounts& counts = *worker.counts;
  worker.generated.add(counts.generated, area.width, area.height);
  worker.live.add(counts.live, area.width, area.height);
  if (plan.lists.kind != ListPlan::Kind::none) {
    worker.most_live.add(counts.most_live, area.width, area.height);
  }
}

TileJob Renderer::State::job_of(std::size_t tile, int tiles_x) const {
  const int x = static_cast<int>(tile % static_cast<std::size_t>(tiles_x)) * kTileSize;
  const int y = static_cast<int>(tile / static_cast<std::size_t>(tiles_x)) * kTileSize;
  return {x,
          y,
          std::min(kTileSize, plan.width - x),
          std::min(kTileSize, plan.height - y),
          tile,
          vertices.data(),
          bin_lists.data(),
          static_cast<int>(bin_lists.size()),
          plan.background,
          nullptr};
}

TileArea Renderer::State::area_of(const TileJob& job) const {
  const auto& [across, down, centered] = plan.subpixels;
  return {job.x / across, job.y / down, job.width / across, job.height / down};
}

bool Renderer::State::is_empty(std::size_t tile) const {
  return std::all_of(bin_lists.begin(), bin_lists.end(), [&](const Bin* lists) {
    const Bin* of_tile = lists + bin_index(tile, Stream::dot);
    return std::all_of(of_tile, of_tile + kStreams, [](const Bin& bin) { return bin.first == nullptr; });
  });
}

// Of a tile whose surfaces are known: colours, or sums of them where pixels show several.
void Renderer::State::shade_tile(Worker& worker, const RenderOptions& options, const TileJob& job,
                                 ShadeJob& shading) {
  const bool cut = plan.subpixels.count() > 1;
  if (cut) worker.parts.list_simple(plan.subpixels, job, plan.linear_background, *shading.samples);
  shade_draws(worker, shading, shade);
  if (wants_surface(options) && shading.samples != nullptr) worker.samples.show_nearest(*job.buffers);
  if (!cut) return;
  worker.parts.restore(*job.buffers);
  worker.parts.join_sums(plan.subpixels, job, *shading.samples);
}

void Renderer::State::draw_tile(Worker& worker, const RenderOptions& options, TileJob job, Frame& frame) {
  TileBuffers& buffers = *worker.tile;
  job.buffers = &buffers;
  const bool empty = is_empty(job.tile), work = !empty || !worker.blank, counts = wants_counts(options);
  const bool sampled = plan.sampling == Sampling::samples, listed = plan.lists.kind != ListPlan::Kind::none;
  const bool cut = plan.subpixels.count() > 1;
  const TileArea area = area_of(job);
  int covered = 0;
  if (counts) worker.counts->clear();
  if (work && !listed) {
    covered = sampled ? worker.samples.rasterize(table, plan, job) : table.rasterize(job);
    if (counts) count_fragments(worker, options, job);
  }

  ShadeJob shading{job.x,
                   job.y,
                   job.width,
                   job.height,
                   &buffers,
                   sampled ? worker.samples.buffers() : nullptr,
                   nullptr,
                   vertices.data(),
                   nullptr,
                   &plan.view.rays,
                   options.interpolation == Interpolation::screen,
                   options.transfer,
                   plan.shading.values.data(),
                   options.max_error};
  if (work && listed) {
    covered = worker.lists.draw(plan, job, *shading.samples, [&] { shade_draws(worker, shading, shade); });
  }
  worker.blank = empty;
  if (counts) worker.counts->join(listed ? Subpixels{} : plan.subpixels);
  if (options.want_complexity) add_up(worker, area);
  if (covered > 0 && !listed) {
    shade_tile(worker, options, job, shading);
    if (cut) covered = shading.samples->pixels;
  }
  worker.covered += static_cast<std::uint64_t>(covered);
  if (covered > 0 && sampled) {
    if (shading.samples->pixels > 0) table.resolve_samples({&buffers, shading.samples, options.transfer});
    shading.samples = nullptr;
  }
  if (options.want_normal) {
    worker.normals.assign(3 * kTilePixels, 0.0f);
    shading.normals = worker.normals.data();
    if (covered > 0) shade_draws(worker, shading, table.write_normals);
  }
  if (cut && wants_surface(options)) join_surfaces(plan.subpixels, buffers, shading.normals);
  const auto width = static_cast<std::size_t>(options.width);
  table.store_tile(
      buffers, area.width, area.height,
      frame.image.pixels.data() + static_cast<std::size_t>(area.y) * width + static_cast<std::size_t>(area.x),
      width);
  store_planes(
      options,
      {area, &buffers, worker.normals.data(), worker.counts.get(), kSamples * plan.subpixels.count()}, frame);
}

void Renderer::State::draw_tiles(const RenderOptions& options, int tiles_x, std::size_t tiles, Frame& frame) {
  bin_lists.clear();
  for (Worker& w : workers) bin_lists.push_back(w.bins.bins());
  for (int i = 0; i < table.shadings_count; ++i) {
    if (table.shadings[i].name == plan.shading.method->name) shade = table.shadings[i].shade;
  }
  pool.for_each(tiles, [&](int worker, std::size_t tile) {
    draw_tile(workers[static_cast<std::size_t>(worker)], options, job_of(tile, tiles_x), frame);
  });
}

std::uint64_t Renderer::State::memory() const {
  std::uint64_t n = vertices.capacity() * sizeof(ScreenVertex) + chunks.capacity() * sizeof(Chunk) +
                    plan.draws.capacity() * sizeof(DrawPlan);
  for (const Worker& w : workers) {
    n += w.bins.memory() + sizeof(TileBuffers) + w.samples.bytes() + w.parts.bytes() + w.lists.bytes() +
         w.rest.capacity() * sizeof(std::uint32_t) + w.normals.capacity() * sizeof(float) +
         w.counted_entries.capacity() * sizeof(GlassEntry) + (w.counts ? sizeof(TileCounts) : 0);
  }
  return n;
}

void Renderer::State::sum_up(const RenderOptions& options, FrameStatistics& s) {
  s = {};
  s.triangles_in = plan.triangles;
  antialias::ListStatistics lists;
  std::uint64_t fullest_pool = 0;
  FragmentCounter generated, live, most_live;
  for (Worker& w : workers) {
    s.triangles_culled += w.culled;
    s.triangles_drawn += w.drawn;
    s.pixels_covered += w.covered;
    generated.add(w.generated);
    live.add(w.live);
    most_live.add(w.most_live);
    if (plan.sampling == Sampling::centers) continue;
    const SampleCounts& c = w.samples.counts();
    s.fragments_shaded += c.fragments;
    s.pixels_shared += c.shared_pixels;
    s.layers_generated += c.layers;
    s.layers_merged += c.merged_layers;
    s.pixels_merged += c.merged_pixels;
    if (plan.lists.kind == ListPlan::Kind::none) continue;
    lists += w.lists.statistics();
    fullest_pool = std::max(fullest_pool, w.lists.fullest_pool());
  }
  s.fragments_shaded += lists.generated;
  s.fragments_lost = lists.overflowed;
  s.fragments_hidden_on_arrival = lists.hidden_on_arrival;
  s.fragments_removed_later = lists.removed_later;
  s.fragments_most_live = lists.most_live;
  s.fragment_memory = fragment_memory(plan.lists, {options.width, options.height}, lists, fullest_pool);
  if (!options.want_complexity) return;
  DepthComplexity& d = s.complexity;
  d = {generated.histogram(), live.histogram(), most_live.histogram(), 0};
  d.hidden = d.generated.total() - d.live.total() - s.layers_merged - s.fragments_lost;
}

Status Renderer::State::render(const Scene& scene, const RenderOptions& options, Frame& frame) {
  const Clock::time_point start = Clock::now();
  if (const Status s = plan_frame(scene, options, plan); !s) return s.error();
  if (memory_of_vertices() + std::uint64_t{4} * static_cast<std::uint64_t>(options.width) *
                                 static_cast<std::uint64_t>(options.height) >
      options.limits.max_memory) {
    return out_of_memory(options);
  }
  frame.image.resize(options.width, options.height);
  size_planes(options, frame);
  vertices.resize(plan.vertices);

  const int tiles_x = (plan.width + kTileSize - 1) / kTileSize;
  const std::size_t tiles =
      static_cast<std::size_t>(tiles_x) * static_cast<std::size_t>((plan.height + kTileSize - 1) / kTileSize);
  transform();
  assemble(options, tiles_x, tiles);
  const Clock::time_point assembled = Clock::now();
  draw_tiles(options, tiles_x, tiles, frame);
  const Clock::time_point end = Clock::now();

  FrameStatistics& s = frame.statistics;
  sum_up(options, s);
  s.memory_bytes = memory();
  s.geometry_ms = ms_between(start, assembled);
  s.tiles_ms = ms_between(assembled, end);
  s.frame_ms = ms_between(start, end);
  return Done{};
}

Renderer::Renderer(const RendererOptions& options) : state_(std::make_unique<State>(options)) {}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

Status Renderer::render(const Scene& scene, const RenderOptions& options, Frame& frame) {
  try {
    return state_->render(scene, options, frame);
  } catch (const std::bad_alloc&) {
    return out_of_memory(options);
  }
}

Result<Frame> Renderer::render(const Scene& scene, const RenderOptions& options) {
  Frame frame;
  if (const Status s = render(scene, options, frame); !s) return s.error();
  return frame;
}

Isa Renderer::isa() const { return state_->table.isa; }
int Renderer::threads() const { return state_->pool.size(); }

}  // namespace blysk
