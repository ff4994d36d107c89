#include "render/list_tile.h"

#include <algorithm>
#include <array>
#include <new>

#include "antialias/carpenter.h"
#include "antialias/coverage_mask.h"
#include "antialias/fragment_lists.h"
#include "antialias/fragment_pool.h"
#include "render/tile_entries.h"

namespace blysk {
namespace {

using antialias::Fragment;
using antialias::Mask;
using antialias::SamplePattern;
using antialias::Subpixel;
using antialias::Tie;

constexpr std::size_t kBatch = 1 << 15;  // fragments that are shaded together
constexpr float kFar = 2;                // beyond every depth

std::unique_ptr<antialias::FragmentTile> make_lists(const ListPlan& plan) {
  switch (plan.kind) {
    case ListPlan::Kind::pool:
      return std::make_unique<antialias::FragmentPool>(
          antialias::FragmentPoolOptions{.pattern = plan.pattern,
                                         .main = plan.main,
                                         .extra = plan.extra,
                                         .pool = plan.pool,
                                         .overflow = plan.overflow,
                                         .tie = Tie::lower_id});
    case ListPlan::Kind::carpenter:
      return std::make_unique<antialias::CarpenterLists>(*plan.pattern);
    default:
      return std::make_unique<antialias::FragmentLists>(antialias::FragmentListOptions{
          .pattern = plan.pattern, .overflow = plan.overflow, .most = plan.most, .tie = Tie::lower_id});
  }
}

// A fragment as the shading methods take it: pixel of the tile, number of samples, and where they lie on
// average, which of many samples is rounded to 1/64 of their distance.
std::uint32_t place_of(std::uint32_t pixel, Mask mask, int across) {
  constexpr std::uint32_t kMost = 16;
  const auto width = static_cast<std::uint32_t>(4 * across);
  std::uint32_t columns = 0, rows = 0;
  for (Mask left = mask; left != 0; left &= left - 1) {
    const auto s = static_cast<std::uint32_t>(std::countr_zero(left));
    columns += 2 * (s % width);
    rows += 2 * (s / width);
  }
  auto count = static_cast<std::uint32_t>(antialias::samples_in(mask));
  if (columns >= 8 * count) {  // the right half
    ++pixel;
    columns -= 8 * count;
  }
  if (count > kMost) {
    columns = std::min((2 * kMost * columns / count + 1) / 2, 127u);
    rows = (2 * kMost * rows / count + 1) / 2;
    count = kMost;
  }
  return pixel | count << kFragmentSamplesShift | columns << kFragmentColumnsShift |
         rows << kFragmentRowsShift;
}

float mean_depth(const Fragment& f, const SamplePattern& pattern) {
  float sum = 0;
  for (Mask left = f.mask; left != 0; left &= left - 1) {
    sum += antialias::depth_at(f, pattern, static_cast<std::size_t>(std::countr_zero(left)));
  }
  return sum / static_cast<float>(antialias::samples_in(f.mask));
}

// Where a fragment is shaded, in subpixels of the tile's pixels, of which `across` are one of the fragment's.
Vec2<double> place_in(int column, int row, Mask mask, const SamplePattern& pattern, int across) {
  double x = 0, y = 0;
  for (Mask left = mask == pattern.full() ? 0 : mask; left != 0; left &= left - 1) {
    const auto s = static_cast<std::size_t>(std::countr_zero(left));
    x += pattern.x[s];
    y += pattern.y[s];
  }
  const double count = antialias::samples_in(mask);
  return {((column + 0.5) * kSubpixels + x / count) * across, (row + 0.5) * kSubpixels + y / count};
}

float least_depth(const Fragment& f, const SamplePattern& pattern) {
  float least = kFar;
  for (Mask left = f.mask; left != 0; left &= left - 1) {
    least =
        std::min(least, antialias::depth_at(f, pattern, static_cast<std::size_t>(std::countr_zero(left))));
  }
  return least;
}

}  // namespace

void ListTile::prepare(const FramePlan& plan, std::size_t max_bytes) {
  max_bytes_ = max_bytes;
  tile_ = make_lists(plan.lists);
  pattern_ = plan.lists.pattern;
  across_ = plan.subpixels.across;
  statistics_ = {};
  fullest_pool_ = 0;
  nearest_id_.resize(kTilePixels);
  nearest_z_.resize(kTilePixels);
}

// Pieces of a clipped triangle have one triangle but numbers of their own.
void ListTile::add(const GlassEntry& entry, const TileJob& job, std::uint32_t number, std::uint32_t object) {
  const LargeEntry& t = entry.triangle;
  const int unit = kSubpixels * across_;
  std::array<Subpixel, 3> c;
  std::array<double, 3> z;
  for (std::size_t k = 0; k < 3; ++k) {
    c[k] = {t.x[k], std::int64_t{t.y[k]} * across_};
    z[k] = 1 - double{t.nearness[k]};
  }
  const antialias::TriangleCoverage coverage(c, *pattern_, unit);
  if (coverage.empty()) return;
  const antialias::DepthPlane plane = antialias::depth_plane(c, z, unit);
  Fragment f = {.rgb = {},
                .zx = static_cast<float>(plane.zx),
                .zy = static_cast<float>(plane.zy),
                .alpha = entry.opacity,
                .id = number,
                .object = object};
  TriangleOpacity varying;
  if (entry.varying != nullptr) varying = triangle_opacity(*entry.varying, job.vertices, t.id);
  const auto first = [unit](std::int64_t low, int start) {
    return std::max(static_cast<int>(low / unit - (low < 0 ? 1 : 0)) - start, 0);
  };
  const auto last = [unit](std::int64_t high, int start, int count) {
    return std::min(static_cast<int>(high / unit) - start, count - 1);
  };
  const auto [left, right] = std::minmax({c[0].x, c[1].x, c[2].x});
  const auto [top, bottom] = std::minmax({c[0].y, c[1].y, c[2].y});
  const int tile_x = job.x / across_, width = job.width / across_;
  for (int y = first(top, job.y); y <= last(bottom, job.y, job.height); ++y) {
    for (int x = first(left, tile_x); x <= last(right, tile_x, width); ++x) {
      f.mask = coverage.mask(tile_x + x, job.y + y);
      if (f.mask == 0) continue;
      if (entry.varying != nullptr) {
        f.alpha = opacity_at(varying, place_in(tile_x + x, job.y + y, f.mask, *pattern_, across_));
      }
      if (f.alpha == 0) continue;
      f.z = static_cast<float>(plane.at(tile_x + x, job.y + y));
      add(t.id, static_cast<std::uint32_t>(y * kTileSize + x), f);
    }
  }
}

void ListTile::add(std::uint32_t triangle, std::uint32_t pixel, const Fragment& fragment) {
  waiting_.push_back({triangle, pixel, fragment});
  if (counts_ != nullptr) {
    ++counts_->generated[pixel];
    counts_->covered[pixel] |= fragment.mask;
  }
  const float z = least_depth(fragment, *pattern_);
  if (z >= nearest_z_[pixel]) return;
  nearest_z_[pixel] = z;
  nearest_id_[pixel] = triangle;
}

void ListTile::shade_round(std::size_t first, std::size_t end, SampleBuffers& samples, const Shade& shade) {
  samples.fragments = 0;
  for (std::size_t i = first; i < end; ++i) {
    const Waiting& w = waiting_[order_[i]];
    const std::uint32_t column = w.pixel % kTileSize;
    const std::uint32_t place =
        place_of(w.pixel - column + column * static_cast<std::uint32_t>(across_), w.fragment.mask, across_);
    samples.fragment_id[samples.fragments] = static_cast<std::int32_t>(w.triangle);
    samples.fragment_place[samples.fragments] = static_cast<std::int32_t>(place);
    samples.fragment_nearness[samples.fragments] = 1 - mean_depth(w.fragment, *pattern_);
    ++samples.fragments;
    std::fill_n(samples.sum + 4 * (place % kTilePixels), 4, 0.0f);
  }
  shade();
  for (std::size_t i = first; i < end; ++i) {
    const auto place = static_cast<std::uint32_t>(samples.fragment_place[i - first]);
    const float* sum = samples.sum + 4 * (place % kTilePixels);
    const float share = 1 / static_cast<float>(place >> kFragmentSamplesShift & 31);
    waiting_[order_[i]].fragment.rgb = {sum[0] * share, sum[1] * share, sum[2] * share};
  }
}

// A pixel's sums hold one fragment at a time: first all pixels' first ones are shaded, then their second.
void ListTile::flush(SampleBuffers& samples, const Shade& shade) {
  std::array<std::uint32_t, kTilePixels> of_pixel{};
  std::vector<std::uint32_t> round(waiting_.size());
  std::vector<std::size_t> first(1, 0);  // of each round, in order_
  for (std::size_t i = 0; i < waiting_.size(); ++i) {
    round[i] = of_pixel[waiting_[i].pixel]++;
    if (round[i] + 1 == first.size()) first.push_back(0);
    ++first[round[i] + 1];
  }
  for (std::size_t r = 1; r < first.size(); ++r) first[r] += first[r - 1];
  std::vector<std::size_t> next(first);
  order_.resize(waiting_.size());
  for (std::size_t i = 0; i < waiting_.size(); ++i) order_[next[round[i]]++] = static_cast<std::uint32_t>(i);
  for (std::size_t r = 0; r + 1 < first.size(); ++r) shade_round(first[r], first[r + 1], samples, shade);
  for (const Waiting& w : waiting_) {
    tile_->insert(w.pixel, w.fragment);
    if (counts_ == nullptr) continue;
    std::uint32_t& most = counts_->most_live[w.pixel];
    most = std::max(most, static_cast<std::uint32_t>(tile_->live(w.pixel)));
  }
  waiting_.clear();
  if (bytes() > max_bytes_) throw std::bad_alloc();
}

int ListTile::draw(const FramePlan& plan, const TileJob& job, SampleBuffers& samples, const Shade& shade) {
  constexpr Stream kAll[] = {Stream::small, Stream::small_away, Stream::large, Stream::glass_small,
                             Stream::glass_large};
  TileBuffers& buffers = *job.buffers;
  std::fill_n(buffers.id, kTilePixels, kNoTriangle);  // nothing is shaded by rows
  std::fill_n(buffers.nearness, kTilePixels, 0.0f);
  std::fill_n(buffers.color, kTilePixels, job.background);
  std::fill(nearest_z_.begin(), nearest_z_.end(), kFar);
  samples.weighted = false;
  tile_->clear(kTilePixels);
  gather_entries(plan, job, kAll, entries_);
  std::uint32_t draw_of = 0;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    const std::uint32_t id = entries_[i].triangle.id;
    while (id - plan.draws[draw_of].draw.id_base >= plan.draws[draw_of].draw.id_count) ++draw_of;
    add(entries_[i], job, static_cast<std::uint32_t>(i), draw_of);
    if (waiting_.size() >= kBatch) flush(samples, shade);
  }
  flush(samples, shade);

  statistics_ += tile_->statistics();
  fullest_pool_ = std::max(fullest_pool_, tile_->statistics().pool_peak);
  if (counts_ != nullptr) {
    for (std::size_t i = 0; i < kTilePixels; ++i)
      counts_->live[i] = static_cast<std::uint32_t>(tile_->live(i));
  }
  return compose(plan, buffers, samples);
}

int ListTile::compose(const FramePlan& plan, TileBuffers& buffers, SampleBuffers& samples) {
  const Vec4f& background = plan.linear_background;
  samples.fragments = samples.pixels = 0;
  for (std::uint32_t pixel = 0; pixel < kTilePixels; ++pixel) {
    if (tile_->live(pixel) == 0) continue;
    const antialias::Composed c = tile_->compose(pixel);
    const Vec3d rgb = c.over({double{background.x}, double{background.y}, double{background.z}});
    float* sum = samples.sum + 4 * pixel;
    const double parts[] = {rgb.x, rgb.y, rgb.z, 1 - c.background + c.background * double{background.w}};
    for (int k = 0; k < 4; ++k) sum[k] = static_cast<float>(kSamples * parts[k]);
    samples.pixel[samples.pixels++] = static_cast<std::int32_t>(pixel);
    const auto across = static_cast<std::uint32_t>(across_);
    const std::uint32_t column = pixel % kTileSize, at = pixel - column + column * across;
    std::fill_n(buffers.id + at, across, nearest_id_[pixel]);
    std::fill_n(buffers.nearness + at, across, std::clamp(1 - nearest_z_[pixel], 0.0f, 1.0f));
  }
  return samples.pixels;
}

std::size_t ListTile::bytes() const {
  return (tile_ ? tile_->bytes() : 0) + entries_.capacity() * sizeof(GlassEntry) +
         waiting_.capacity() * sizeof(Waiting) + order_.capacity() * sizeof(std::uint32_t) +
         nearest_z_.capacity() * (sizeof(float) + sizeof(std::uint32_t));
}

}  // namespace blysk
