// render/tile_counts.h - how many fragments the pixels of a tile have, for those who ask: pictures and
// statistics beside the frame.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "antialias/glass.h"
#include "blysk/fragments.h"
#include "render/frame.h"

namespace blysk {

struct TileCounts {
  std::uint32_t generated[kTilePixels];  ///< if statistics are wanted
  std::uint32_t live[kTilePixels];
  std::uint32_t most_live[kTilePixels];  ///< of lists only
  std::uint32_t covered[kTilePixels];    ///< samples that any surface covers, as bits; joined: how many

  void clear();
  /// Counts of parts become sums of their pixels. Lists count pixels from the start: for them `parts` is {}.
  void join(const Subpixels& parts);
};

/// Pixels by their number of fragments. What it holds does not depend on the order in which tiles come.
class FragmentCounter {
 public:
  void clear() { pixels_.clear(); }
  /// The part of a tile that lies in the picture.
  void add(const std::uint32_t* tile, int width, int height);
  void add(const FragmentCounter& other);
  [[nodiscard]] FragmentHistogram histogram() const;

 private:
  std::map<std::uint32_t, std::uint64_t> pixels_;
};

/// Fragments of all triangles of a tile, drawn with one sample at the centre or sixteen: of one pass that
/// looks at nothing else, so that drawing need not count. `entries` is memory to work in.
void count_generated(const FramePlan& plan, const TileJob& job, std::vector<GlassEntry>& entries,
                     TileCounts& counts);

/// What one sample a pixel leaves.
void count_centers(const TileBuffers& pixels, TileCounts& counts);

}  // namespace blysk
