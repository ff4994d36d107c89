#include "study/flat_raster.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "antialias/carpenter.h"
#include "antialias/coverage_mask.h"
#include "antialias/fragment_lists.h"
#include "antialias/fragment_pool.h"
#include "core/random.h"

namespace blysk::study {
namespace {

using antialias::Fragment;
using antialias::Subpixel;

std::int64_t snapped(double pixels) { return static_cast<std::int64_t>(std::floor(pixels * 256 + 0.5)); }

// Columns or rows of a range of subpixels that lie in start .. start + count.
std::pair<int, int> covered(std::int64_t low, std::int64_t high, int start, int count) {
  const std::int64_t first = std::max<std::int64_t>(low >> 8, start),
                     last = std::min<std::int64_t>(high >> 8, start + count - 1);
  return {static_cast<int>(first), static_cast<int>(last)};
}

double depth_of(const FlatTriangle& t) { return t.corners[0].z + t.corners[1].z + t.corners[2].z; }

void rasterise_one(const FlatTriangle& t, std::uint32_t id, const Region& region,
                   const antialias::SamplePattern& pattern, FragmentStream& stream) {
  std::array<Subpixel, 3> c;
  for (std::size_t k = 0; k < 3; ++k) c[k] = {snapped(t.corners[k].x), snapped(t.corners[k].y)};
  const auto [low_x, high_x] = std::minmax({c[0].x, c[1].x, c[2].x});
  const auto [low_y, high_y] = std::minmax({c[0].y, c[1].y, c[2].y});
  const auto [left, right] = covered(low_x, high_x, region.left, region.width);
  const auto [top, bottom] = covered(low_y, high_y, region.top, region.height);
  if (left > right || top > bottom || antialias::doubled_area(c) == 0) return;

  const antialias::TriangleCoverage coverage(c, pattern);
  const antialias::DepthPlane plane =
      antialias::depth_plane(c, {t.corners[0].z, t.corners[1].z, t.corners[2].z});
  Fragment f = {.rgb = t.rgb,
                .zx = static_cast<float>(plane.zx),
                .zy = static_cast<float>(plane.zy),
                .alpha = t.alpha,
                .id = id,
                .object = t.object};
  for (int y = top; y <= bottom; ++y) {
    for (int x = left; x <= right; ++x) {
      f.mask = coverage.mask(x, y);
      if (f.mask == 0) continue;
      f.z = static_cast<float>(plane.at(x, y));
      stream.fragments.push_back(f);
      stream.pixels.push_back(static_cast<std::uint32_t>((y - region.top) * region.width + x - region.left));
    }
  }
}

}  // namespace

std::string_view order_name(Order order) {
  switch (order) {
    case Order::random:
      return "random";
    case Order::front_to_back:
      return "front to back";
    case Order::back_to_front:
      return "back to front";
    case Order::given:
      break;
  }
  return "as given";
}

std::vector<std::uint32_t> submission_order(std::span<const FlatTriangle> triangles, Order order,
                                            std::uint64_t seed) {
  std::vector<std::uint32_t> indices(triangles.size());
  std::iota(indices.begin(), indices.end(), 0u);
  if (order == Order::random) {
    Random random(seed);
    for (std::size_t i = indices.size(); i > 1; --i) std::swap(indices[i - 1], indices[random.next() % i]);
  } else if (order != Order::given) {
    std::stable_sort(indices.begin(), indices.end(), [&](std::uint32_t one, std::uint32_t other) {
      const double a = depth_of(triangles[one]), b = depth_of(triangles[other]);
      return order == Order::front_to_back ? a < b : b < a;
    });
  }
  return indices;
}

void FragmentStream::sort_by_pixel(std::size_t pixel_count) {
  std::vector<std::size_t> next(pixel_count + 1);
  for (const std::uint32_t pixel : pixels) ++next[pixel + 1];
  std::partial_sum(next.begin(), next.end(), next.begin());
  std::vector<Fragment> sorted(fragments.size());
  for (std::size_t i = 0; i < fragments.size(); ++i) sorted[next[pixels[i]]++] = fragments[i];
  fragments = std::move(sorted);
  std::sort(pixels.begin(), pixels.end());
}

void FragmentStream::insert_into(antialias::FragmentTile& tile) const {
  for (std::size_t i = 0; i < fragments.size(); ++i) tile.insert(pixels[i], fragments[i]);
}

void rasterise(std::span<const FlatTriangle> triangles, std::span<const std::uint32_t> order,
               const Region& region, const antialias::SamplePattern& pattern, FragmentStream& stream) {
  for (std::size_t i = 0; i < order.size(); ++i) {
    rasterise_one(triangles[order[i]], static_cast<std::uint32_t>(i), region, pattern, stream);
  }
}

const antialias::SamplePattern& samples_of(const Variant& variant, const antialias::SamplePattern& pattern) {
  return variant.kind == Variant::Kind::zbuffer ? antialias::kCentre : pattern;
}

std::unique_ptr<antialias::FragmentTile> make_tile(const Variant& v, const antialias::SamplePattern& pattern,
                                                   std::size_t tile_pixels, std::size_t picture_pixels) {
  switch (v.kind) {
    case Variant::Kind::pool:
      return std::make_unique<antialias::FragmentPool>(
          antialias::FragmentPoolOptions{.pattern = &pattern,
                                         .main = v.main,
                                         .extra = v.extra,
                                         .pool = v.pool * tile_pixels / picture_pixels,
                                         .overflow = v.overflow,
                                         .tie = v.tie});
    case Variant::Kind::carpenter:
      return std::make_unique<antialias::CarpenterLists>(pattern);
    case Variant::Kind::zbuffer:
      return std::make_unique<antialias::FragmentLists>(
          antialias::FragmentListOptions{.pattern = &antialias::kCentre, .tie = v.tie});
    case Variant::Kind::lists:
      break;
  }
  return std::make_unique<antialias::FragmentLists>(antialias::FragmentListOptions{
      .pattern = &pattern, .overflow = v.overflow, .most = v.most, .tie = v.tie});
}

Drawing draw(std::span<const FlatTriangle> triangles, const DrawOptions& options, ThreadPool& threads) {
  const auto tiles_of = [&](int side) { return (side + options.tile - 1) / options.tile; };
  const auto columns = static_cast<std::size_t>(tiles_of(options.width)),
             rows = static_cast<std::size_t>(tiles_of(options.height));
  const auto width = static_cast<std::size_t>(options.width);
  const std::size_t picture_pixels = width * static_cast<std::size_t>(options.height);
  const std::vector<std::uint32_t> order = submission_order(triangles, options.order, options.seed);
  const antialias::SamplePattern& pattern = samples_of(options.variant, *options.pattern);

  Drawing drawing;
  drawing.pixels.resize(picture_pixels);
  drawing.live.resize(picture_pixels);
  std::vector<antialias::ListStatistics> of_tile(columns * rows);
  std::vector<FragmentStream> streams(static_cast<std::size_t>(threads.size()));
  threads.for_each(columns * rows, [&](int worker, std::size_t item) {
    const int left = static_cast<int>(item % columns) * options.tile,
              top = static_cast<int>(item / columns) * options.tile;
    const Region region = {left, top, std::min(options.tile, options.width - left),
                           std::min(options.tile, options.height - top)};
    FragmentStream& stream = streams[static_cast<std::size_t>(worker)];
    stream.clear();
    rasterise(triangles, order, region, pattern, stream);
    const auto tile = make_tile(options.variant, pattern, region.pixels(), picture_pixels);
    tile->clear(region.pixels());
    stream.insert_into(*tile);
    for (std::size_t p = 0; p < region.pixels(); ++p) {
      const std::size_t y = static_cast<std::size_t>(top) + p / static_cast<std::size_t>(region.width),
                        x = static_cast<std::size_t>(left) + p % static_cast<std::size_t>(region.width);
      drawing.live[y * width + x] = static_cast<std::uint32_t>(tile->live(p));
      drawing.pixels[y * width + x] = tile->resolve(p, options.background);
    }
    of_tile[item] = tile->statistics();
  });
  for (const auto& statistics : of_tile) drawing.statistics += statistics;
  return drawing;
}

}  // namespace blysk::study
