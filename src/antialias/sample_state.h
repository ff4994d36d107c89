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

/// Blocks of 8 x 8 pixels, numbered row by row.
inline constexpr int kBlockBits = 3, kBlockSide = 1 << kBlockBits;
inline constexpr int kBlocksAcross = kTileSize / kBlockSide;
static_assert(kBlocksAcross * kBlocksAcross == 64);

constexpr int first_pixel_of(int block) {
  return (block / kBlocksAcross * kTileSize + block % kBlocksAcross) * kBlockSide;
}

/// Pixels of the tile, inclusive.
struct Box {
  int left, top, right, bottom;
  /// Bits of the blocks that it meets.
  BLYSK_INLINE std::uint64_t blocks() const {
    const std::uint64_t columns = (2u << (right >> kBlockBits)) - (1u << (left >> kBlockBits));
    const int first = top >> kBlockBits, last = bottom >> kBlockBits;
    return columns * (0x0101010101010101u >> 8 * (kBlocksAcross - 1 - (last - first)) << 8 * first);
  }
};

struct SampleTile {
  TileBuffers& pixels;
  SampleBuffers& samples;
  const SampleGrid grid;
  std::uint64_t open_blocks = 0;  ///< all of whose pixels are open
  bool any_open = false;

  BLYSK_INLINE bool is_open(int at) const { return pixels.id[at] == kManySurfaces; }
  BLYSK_INLINE PixelSamples& samples_of(int at) const { return samples.open[at + (at >> kTileBits)]; }

  /// A simple pixel becomes sixteen samples.
  BLYSK_INLINE void open(int at) {
    PixelSamples& pixel = samples_of(at);
    const std::uint32_t owner = pixels.id[at];
    if (owner == kNoTriangle) {
      store(F32(kNothingNear), pixel.nearness);
      store(I32(kNoSurface), pixel.id);
    } else {
      const SampleSlopes slopes(grid, samples.slope_x[at], samples.slope_y[at]);
      store(slopes.depths(pixels.nearness[at]), pixel.nearness);
      store(I32(static_cast<std::int32_t>(owner)), pixel.id);
    }
    pixels.id[at] = kManySurfaces;
    any_open = true;
  }
  __attribute__((noinline)) void open_one(int at) { open(at); }

  /// Opens what is not open of some blocks.
  BLYSK_INLINE void open_all(std::uint64_t blocks) {
    if (__builtin_expect((blocks & ~open_blocks) != 0, 0)) open_missing(blocks & ~open_blocks);
  }
  __attribute__((noinline)) void open_missing(std::uint64_t blocks) {
    any_open = true;
    open_blocks |= blocks;
    for (; blocks != 0; blocks &= blocks - 1) {
      const int first = first_pixel_of(__builtin_ctzll(blocks));
      for (int row = 0; row < kBlockSide; ++row) open_row(first + row * kTileSize);
    }
  }
  /// A block's row; most are empty yet.
  BLYSK_INLINE void open_row(int at) {
    const Mask inside = lanes_below(kBlockSide);
    if (any(inside & (load(pixels.id + at) != I32(static_cast<std::int32_t>(kNoTriangle))))) {
      for (int i = 0; i < kBlockSide; ++i) {
        if (!is_open(at + i)) open(at + i);
      }
      return;
    }
    PixelSamples* const row = &samples_of(at);
    for (int i = 0; i < kBlockSide; ++i) {
      store(F32(kNothingNear), row[i].nearness);
      store(I32(kNoSurface), row[i].id);
    }
    store_masked(inside, I32(static_cast<std::int32_t>(kManySurfaces)), pixels.id + at);
  }

  /// An open pixel shows one surface from now on.
  BLYSK_INLINE void close(int at, float nearness, float slope_x, float slope_y, std::int32_t id) {
    pixels.nearness[at] = nearness;
    pixels.id[at] = static_cast<std::uint32_t>(id);
    samples.slope_x[at] = slope_x;
    samples.slope_y[at] = slope_y;
    const int block =
        (at >> (kTileBits + kBlockBits) << (kTileBits - kBlockBits)) + ((at & (kTileSize - 1)) >> kBlockBits);
    open_blocks &= ~(std::uint64_t{1} << block);
  }
};

/// Samples of an open pixel are taken over where they are nearer, but for those that are not covered; which
/// they were.
BLYSK_INLINE Mask take(PixelSamples& pixel, Mask uncovered, F32 depths, I32 id) {
  const F32 old = load(pixel.nearness);
  const I32 owner = load(pixel.id);
  const Mask wins = and_not(uncovered, (depths > old) | ((depths == old) & (owner > id)));
  // Whole registers: the next triangle often meets the same pixel, and a masked store cannot be read back at
  // once.
  store(select(wins, depths, old), pixel.nearness);
  store(select(wins, id, owner), pixel.id);
  return wins;
}

}  // namespace blysk::BLYSK_ISA
