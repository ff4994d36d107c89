// blysk/fragments.h - how many fragments the pixels of a frame had, and what memory they take.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "blysk/image.h"
#include "blysk/result.h"

namespace blysk {

/// How many pixels have how many fragments. A fragment is what one triangle contributes to one pixel.
struct FragmentHistogram {
  struct Bin {
    std::uint32_t fragments = 0;
    std::uint64_t pixels = 0;  ///< never 0
    friend bool operator==(const Bin&, const Bin&) = default;
  };
  std::vector<Bin> bins;  ///< in ascending order, for all pixels of the picture; empty: not counted

  [[nodiscard]] std::uint64_t pixels() const;
  [[nodiscard]] std::uint64_t total() const;  ///< fragments
  [[nodiscard]] double mean() const;          ///< of a pixel, empty ones too
  [[nodiscard]] std::uint32_t p99() const;    ///< 99 % of the pixels have at most so many
  [[nodiscard]] std::uint32_t most() const;   ///< of one pixel
  friend bool operator==(const FragmentHistogram&, const FragmentHistogram&) = default;
};

/// The depth complexity of a frame. With one sample a pixel a fragment is a covered pixel centre, else any
/// covered sample; triangles that are culled or wholly clear make none, each piece of a clipped one makes its
/// own.
struct DepthComplexity {
  FragmentHistogram generated;  ///< hidden ones too
  FragmentHistogram live;       ///< left when all triangles are drawn
  FragmentHistogram most_live;  ///< at any time; abuffer-*: of what has lists, else empty
  std::uint64_t hidden = 0;     ///< of the generated: what others hide wholly, on arrival or later
};

/// Main and common buffer of the variants that keep lists of fragments (abuffer-*), as if they held the whole
/// picture at once; in fact each thread holds one tile. All 0 for other methods. The main buffer has places
/// for the fragments of each pixel alone, with abuffer-pool addresses of further ones too, which lie in the
/// common buffer; abuffer-unlimited takes as many places as the fullest pixel needs.
struct FragmentMemory {
  std::uint64_t paper_main_bits = 0;  ///< in the paper's layout: of a fragment the mask, three colours of 8
                                      ///< bits, a depth and two slopes of 24; 0 for abuffer-carpenter
  std::uint64_t paper_common_bits = 0;
  std::uint64_t main_bytes = 0, common_bytes = 0;  ///< of this implementation
  std::uint64_t pools = 0, pool_slots = 0;         ///< one pool for each tile, of so many fragments
  std::uint64_t pool_peak = 0;          ///< used at most, of all pools together, each at its own time
  std::uint64_t fullest_pool_peak = 0;  ///< used at most of one pool: none would fill with so many slots
};

/// Counts, row by row, in false colours: 0 black, 1 blue, 2 green, 3 yellow, 4 orange, 5 and more red. The
/// picture stands at the top left, pixel for pixel, a labelled key to its right. ErrorCode::limit where the
/// key would exceed kMaxPictureSide; ErrorCode::usage where counts are no rows of `width`.
[[nodiscard]] Result<Image> fragment_picture(std::span<const std::uint32_t> counts, int width);
/// The widest that fragment_picture() takes.
[[nodiscard]] int widest_fragment_picture();

/// Shares of 0..1 as gray, 0 black and 1 white, linearly between.
[[nodiscard]] Image coverage_picture(const FloatImage& coverage);

}  // namespace blysk
