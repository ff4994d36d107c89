// geometry/screen_vertex.h - a vertex as the rasteriser sees it.
#pragma once

#include <cstdint>
#include <limits>

namespace blysk {

inline constexpr int kSubpixelBits = 8;
inline constexpr int kSubpixels = 1 << kSubpixelBits;  // positions snap to 1/256 pixel

/// Where a pixel is looked at: its centre, or sixteen samples, of which the outermost lie kSampleReach from
/// the centre each way.
enum class Sampling { centers, samples };
inline constexpr int kSampleReach = 96;  // subpixels
constexpr int reach_of(Sampling sampling) { return sampling == Sampling::samples ? kSampleReach : 0; }

/// The first and the last pixel with a place to look at not left of v and not right of it, subpixels.
constexpr std::int32_t first_pixel(std::int32_t v, int reach) {
  return (v + kSubpixels / 2 - 1 - reach) >> kSubpixelBits;
}
constexpr std::int32_t last_pixel(std::int32_t v, int reach) {
  return (v - kSubpixels / 2 + reach) >> kSubpixelBits;
}

/// Largest |x|, |y| of a snapped vertex: differences stay below 2^23, so that an edge function inside a tile,
/// counted in pixels, fits 32 bits (raster/tile_kernel.cpp).
inline constexpr std::int32_t kGuardBand = 1 << 22;

/// x of a vertex that has no place on the screen: behind the near plane, beyond the far plane or the guard
/// band.
inline constexpr std::int32_t kUnplaced = std::numeric_limits<std::int32_t>::min();

struct ScreenVertex {
  std::int32_t x, y;  ///< 1/256 pixel, row 0 at the top; x is kUnplaced if the vertex has to be clipped
  float
      nearness;  ///< 1 at the near plane, 0 at the far plane: floats are dense near 0, where depth is coarse
  float q;       ///< 1 / w, w = 1 at the far plane (orthographic: 1 everywhere)
};
static_assert(sizeof(ScreenVertex) == 16);

/// Rows that carry a mesh position to homogeneous screen coordinates: x and y in subpixels, nearness, w.
struct Projection {
  float row[4][4];
};

}  // namespace blysk
