// render/list_tile.h - a tile drawn with lists of fragments: the variants of the A-buffer that stand beside
// the default to be compared with it.
//
// Every fragment is shaded before it enters a list, seen or not, as merging wants colours: these variants are
// for study, not for speed. Their tiles share nothing, pools included.
//
// With 32 samples a pixel is two of the tile's (render/subpixels.h), as triangles are sorted out by where
// samples lie; its fragments are the whole pixel's.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "antialias/fragment_tile.h"
#include "antialias/glass.h"
#include "antialias/sample_tile.h"
#include "render/frame.h"
#include "render/tile_counts.h"

namespace blysk {

class ListTile {
 public:
  /// Shades SampleBuffers' fragments: colours times samples go into its sums.
  using Shade = std::function<void()>;

  /// Drawing throws std::bad_alloc beyond `max_bytes`.
  void prepare(const FramePlan& plan, std::size_t max_bytes);
  /// Leaves the pixels' colours as SampleBuffers::sum, to be resolved, in the first columns where pixels are
  /// two of the tile's, and the nearest surface of each in TileBuffers, in both columns. Returns how many
  /// pixels are covered.
  int draw(const FramePlan& plan, const TileJob& job, SampleBuffers& samples, const Shade& shade);
  /// Where draw() counts from now on, pixels in the first columns; null: nowhere.
  void count_in(TileCounts* counts) { counts_ = counts; }

  /// Of all tiles since prepare().
  [[nodiscard]] const antialias::ListStatistics& statistics() const { return statistics_; }
  [[nodiscard]] std::uint64_t fullest_pool() const { return fullest_pool_; }
  [[nodiscard]] std::size_t bytes() const;

 private:
  void add(const GlassEntry& entry, const TileJob& job, std::uint32_t number, std::uint32_t object);
  void add(std::uint32_t triangle, std::uint32_t pixel, const antialias::Fragment& fragment);
  int compose(const FramePlan& plan, TileBuffers& buffers, SampleBuffers& samples);
  void flush(SampleBuffers& samples, const Shade& shade);
  void shade_round(std::size_t first, std::size_t end, SampleBuffers& samples, const Shade& shade);

  struct Waiting {
    std::uint32_t triangle, pixel;
    antialias::Fragment fragment;
  };

  std::unique_ptr<antialias::FragmentTile> tile_;
  std::vector<GlassEntry> entries_;
  std::vector<Waiting> waiting_;
  std::vector<std::uint32_t> order_;  ///< of waiting_: first all pixels' first fragments, then their second
  std::vector<std::uint32_t> nearest_id_;
  std::vector<float> nearest_z_;  ///< of any sample
  antialias::ListStatistics statistics_;
  std::uint64_t fullest_pool_ = 0;  ///< most slots in use in one tile
  TileCounts* counts_ = nullptr;
  const antialias::SamplePattern* pattern_ = nullptr;
  int across_ = 1;  ///< of the tile's pixels for one
  std::size_t max_bytes_ = 0;
};

}  // namespace blysk
