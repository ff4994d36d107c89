#include "render/tile_counts.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "antialias/coverage_mask.h"
#include "render/tile_entries.h"

namespace blysk {
namespace {

constexpr std::uint32_t kWhole = 0xffff;

struct Span {
  int first, last;
};

// Pixels of the tile that three coordinates, in subpixels, reach.
Span reached(const std::int32_t (&v)[3], int start, int count) {
  const auto [low, high] = std::minmax({v[0], v[1], v[2]});
  return {std::max((low >> kSubpixelBits) - start, 0), std::min((high >> kSubpixelBits) - start, count - 1)};
}

void count(const GlassEntry& entry, const TileJob& job, const antialias::SamplePattern& pattern,
           std::uint32_t* counts) {
  const LargeEntry& t = entry.triangle;
  const antialias::TriangleCoverage coverage({{{t.x[0], t.y[0]}, {t.x[1], t.y[1]}, {t.x[2], t.y[2]}}},
                                             pattern);
  if (coverage.empty()) return;
  TriangleOpacity varying;
  if (entry.varying != nullptr) varying = triangle_opacity(*entry.varying, job.vertices, t.id);
  const Span rows = reached(t.y, job.y, job.height), columns = reached(t.x, job.x, job.width);
  for (int y = rows.first; y <= rows.last; ++y) {
    for (int x = columns.first; x <= columns.last; ++x) {
      const antialias::Mask mask = coverage.mask(job.x + x, job.y + y);
      const bool clear =
          mask == 0 || (entry.varying != nullptr && opacity_at(varying, job.x + x, job.y + y, mask) == 0);
      counts[y * kTileSize + x] += clear ? 0 : 1;
    }
  }
}

}  // namespace

void TileCounts::clear() {
  std::memset(generated, 0, sizeof generated);
  std::memset(live, 0, sizeof live);
  std::memset(most_live, 0, sizeof most_live);
  std::memset(covered, 0, sizeof covered);
}

void TileCounts::join(const Subpixels& parts) {
  for (std::uint32_t& c : covered) c = static_cast<std::uint32_t>(std::popcount(c));
  if (parts.count() == 1) return;
  for (std::uint32_t* counts : {generated, live, most_live, covered}) join_counts(parts, counts);
}

void FragmentCounter::add(const std::uint32_t* tile, int width, int height) {
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) ++pixels_[tile[row * kTileSize + column]];
  }
}

void FragmentCounter::add(const FragmentCounter& other) {
  for (const auto& [fragments, pixels] : other.pixels_) pixels_[fragments] += pixels;
}

FragmentHistogram FragmentCounter::histogram() const {
  FragmentHistogram histogram;
  for (const auto& [fragments, pixels] : pixels_) histogram.bins.push_back({fragments, pixels});
  return histogram;
}

void count_generated(const FramePlan& plan, const TileJob& job, std::vector<GlassEntry>& entries,
                     TileCounts& counts) {
  constexpr Stream kAll[] = {Stream::small, Stream::small_away, Stream::large, Stream::glass_small,
                             Stream::glass_large};
  const antialias::SamplePattern& pattern =
      plan.sampling == Sampling::samples ? antialias::kGrid16 : antialias::kCentre;
  gather_entries(plan, job, kAll, entries);
  for (const GlassEntry& e : entries) count(e, job, pattern, counts.generated);
  count_dots(job, counts.generated);
}

void count_centers(const TileBuffers& pixels, TileCounts& counts) {
  for (int i = 0; i < kTilePixels; ++i) {
    const bool is = pixels.id[i] != kNoTriangle;
    counts.live[i] = is ? 1 : 0;
    counts.covered[i] = is ? kWhole : 0;
  }
}

}  // namespace blysk
