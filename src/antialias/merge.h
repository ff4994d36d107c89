// antialias/merge.h - two fragments made one, for lists that are full.
#pragma once

#include "antialias/fragment.h"

namespace blysk::antialias {

/// Depth and slopes of the merged fragment.
enum class MergedPlane {
  printed,        ///< the paper as printed: weights out of all samples of the pixel, colour too
  corrected,      ///< depth by coverage, of each slope the smaller
  larger,         ///< depth by coverage, slopes of the fragment with more samples
  least_squares,  ///< the plane that fits the depths of both at their samples best
};

/// A plane over a pixel: z = z + zx * a + zy * b.
struct PixelPlane {
  double z = 0, zx = 0, zy = 0;
};

/// `a` must not be farther than `b` at the pixel's centre. Keeps the pixel's colour (but for `printed`) where
/// what lies in front of the two and behind them is the same at all their samples. Both must be lit.
[[nodiscard]] Fragment merge(const Fragment& a, const Fragment& b, MergedPlane plane,
                             const SamplePattern& pattern);

[[nodiscard]] PixelPlane least_squares_plane(const Fragment& a, const Fragment& b,
                                             const SamplePattern& pattern);

/// How much depth the merged fragment would lose: Ward's criterion, the rise of the squared error.
/// Based on: J. Ward. Hierarchical grouping to optimize an objective function. 1963.
[[nodiscard]] double ward_cost(const Fragment& a, const Fragment& b, const SamplePattern& pattern);

}  // namespace blysk::antialias
