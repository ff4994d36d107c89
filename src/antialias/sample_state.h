// antialias/sample_state.h - the pixels of a tile while surfaces are drawn into them: simple, or sample by
// sample.
//
// What a surface's depth is at a sample depends on the surface and the sample alone, so the order of drawing
// cannot show: (z + a * slope_x) + b * slope_y, z at the pixel's centre. A surface that is drawn in rows has
// nothing clamped but z where it covers all samples; else depths keep to the range of its vertices, so that a
// sliver's slope does not carry a sample beyond them.
#pragma once

#include "antialias/sample_tile.h"
#include "simd/lanes.h"

namespace blysk::BLYSK_ISA {

inline constexpr unsigned kAllSamples = 0xffff;

/// Lanes as places of a square of four by four, samples or pixels.
struct Square {
  I32 column = iota(0) & I32(3), row = shift_right<2>(iota(0));
};

/// Lanes are samples: from the centre, in units of 32 subpixels, -3 -1 1 3.
struct SampleGrid {
  I32 across, down;
  F32 x, y;    ///< the same
  F32 dx, dy;  ///< in subpixels
  BLYSK_INLINE SampleGrid() {
    const Square square;
    across = shift_left<1>(square.column) - I32(3);
    down = shift_left<1>(square.row) - I32(3);
    x = to_float(across);
    y = to_float(down);
    dx = x * F32(32.0f);
    dy = y * F32(32.0f);
  }
};

/// A surface's slopes at all samples.
struct SampleSlopes {
  F32 along_x, along_y;
  BLYSK_INLINE SampleSlopes(const SampleGrid& grid, float slope_x, float slope_y)
      : along_x(grid.dx * F32(slope_x)), along_y(grid.dy * F32(slope_y)) {}
  BLYSK_INLINE F32 depths(float center) const { return (F32(center) + along_x) + along_y; }
};

struct SampleTile {
  TileBuffers& pixels;
  SampleBuffers& samples;
  const SampleGrid grid;
  bool any_open = false;

  BLYSK_INLINE bool is_open(int at) const { return pixels.id[at] == kManySurfaces; }

  /// A simple pixel becomes sixteen samples.
  __attribute__((noinline)) void open(int at) {
    const std::uint32_t owner = pixels.id[at];
    if (owner == kNoTriangle) {
      store(F32(kNothingNear), samples.nearness + at * kSamples);
      store(I32(kNoSurface), samples.id + at * kSamples);
    } else {
      const SampleSlopes slopes(grid, samples.slope_x[at], samples.slope_y[at]);
      store(slopes.depths(pixels.nearness[at]), samples.nearness + at * kSamples);
      store(I32(static_cast<std::int32_t>(owner)), samples.id + at * kSamples);
    }
    pixels.id[at] = kManySurfaces;
    any_open = true;
  }

  /// Samples of an open pixel are taken over where they are nearer; which they were.
  BLYSK_INLINE Mask take(int at, Mask covered, F32 depths, std::int32_t id) {
    float* const nearness_at = samples.nearness + at * kSamples;
    std::int32_t* const id_at = samples.id + at * kSamples;
    const F32 old = load(nearness_at);
    const I32 owner = load(id_at);
    const Mask wins = covered & ((depths > old) | ((depths == old) & (owner > I32(id))));
    // Whole registers: the next triangle often meets the same pixel, and a masked store cannot be read back
    // at once.
    store(select(wins, depths, old), nearness_at);
    store(select(wins, I32(id), owner), id_at);
    return wins;
  }
};

}  // namespace blysk::BLYSK_ISA
