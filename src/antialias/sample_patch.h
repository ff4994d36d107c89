// antialias/sample_patch.h - small triangles, sample by sample: sixteen are set up at once, then sixteen
// pixels of one are sorted out at once, then sixteen samples of one pixel.
//
// All edge functions of these triangles, in units of 32 subpixels, are whole numbers that a float holds.
#pragma once

#include "antialias/sample_state.h"

namespace blysk::BLYSK_ISA {

/// Triangles under this extent each way are drawn in patches, others in rows: 12 pixels.
inline constexpr std::int32_t kPatchExtent = 12 * kSubpixels;

/// Sixteen small triangles as columns. Edge functions and depths at the centre of the first pixel of the box.
struct SmallBlock {
  std::int32_t edge[3][kLanes];  ///< exact
  float patch_edge[3][kLanes];   ///< in units of 32 subpixels, rounded down; of patches only
  float dx[3][kLanes], dy[3][kLanes];
  float x[kLanes], y[kLanes], nearness[kLanes], slope_x[kLanes], slope_y[kLanes], lowest[kLanes],
      highest[kLanes], slope_error[kLanes];
  std::int32_t left[kLanes], top[kLanes], right[kLanes], bottom[kLanes];  ///< in the tile, inclusive
  unsigned patches;  ///< bits of the triangles to be drawn in patches

  BLYSK_INLINE Box box(int i) const { return {left[i], top[i], right[i], bottom[i]}; }
};

/// Where the pixels of a patch lie in SampleBuffers::open, from its first on.
inline constexpr std::int16_t kPatchPlaces[kLanes] = {0,   1,   2,   3,   65,  66,  67,  68,
                                                      130, 131, 132, 133, 195, 196, 197, 198};
static_assert(SampleBuffers::place_of(kTileSize) == 65);

BLYSK_INLINE void set_up_edge(const I32* x, const I32* y, int a, int b, I32 px, I32 py, SmallBlock& out,
                              int k) {
  const I32 dx = x[b] - x[a], dy = y[b] - y[a];
  const Mask owns = (dy < I32(0)) | ((dy == I32(0)) & (dx > I32(0)));  // top or left
  const I32 value = dx * (py - y[a]) - dy * (px - x[a]) + select(owns, I32(0), I32(-1));
  store(value, out.edge[k]);
  store(to_float(shift_right<5>(value)), out.patch_edge[k]);
  store(to_float(dx), out.dx[k]);
  store(to_float(dy), out.dy[k]);
}

BLYSK_INLINE F32 magnitude(F32 v) { return float_of_bits(bits_of(v) & I32(0x7fffffff)); }

BLYSK_INLINE void set_up_small(const TileJob& job, const SmallEntry* entries, SmallBlock& out) {
  I32 x[3], y[3];
  F32 z[3], entry[4];
  gather_rows<4>(reinterpret_cast<const float*>(entries), iota(0), entry);
  for (int k = 0; k < 3; ++k) {
    F32 vertex[4];
    gather_rows<4>(reinterpret_cast<const float*>(job.vertices), bits_of(entry[k + 1]), vertex);
    x[k] = bits_of(vertex[0]) - I32(job.x * kSubpixels);
    y[k] = bits_of(vertex[1]) - I32(job.y * kSubpixels);
    z[k] = vertex[2];
  }
  const I32 x_min = min(min(x[0], x[1]), x[2]), x_max = max(max(x[0], x[1]), x[2]);
  const I32 y_min = min(min(y[0], y[1]), y[2]), y_max = max(max(y[0], y[1]), y[2]);
  const auto first = [](I32 v) {
    return shift_right<kSubpixelBits>(v + I32(kSubpixels / 2 - 1 - kSampleReach));
  };
  const auto last = [](I32 v) { return shift_right<kSubpixelBits>(v - I32(kSubpixels / 2 - kSampleReach)); };
  const I32 left = max(first(x_min), I32(0)), top = max(first(y_min), I32(0));
  store(left, out.left);
  store(top, out.top);
  store(min(last(x_max), I32(job.width - 1)), out.right);
  store(min(last(y_max), I32(job.height - 1)), out.bottom);
  out.patches = to_bits((x_max - x_min < I32(kPatchExtent)) & (y_max - y_min < I32(kPatchExtent)));

  const I32 px = shift_left<kSubpixelBits>(left) + I32(kSubpixels / 2);
  const I32 py = shift_left<kSubpixelBits>(top) + I32(kSubpixels / 2);
  set_up_edge(x, y, 1, 2, px, py, out, 0);
  set_up_edge(x, y, 2, 0, px, py, out, 1);
  set_up_edge(x, y, 0, 1, px, py, out, 2);

  const F32 dx1 = to_float(x[1] - x[0]), dy1 = to_float(y[1] - y[0]);
  const F32 dx2 = to_float(x[2] - x[0]), dy2 = to_float(y[2] - y[0]);
  const F32 inverse = F32(1.0f) / to_float((x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]));
  const F32 dz1 = z[1] - z[0], dz2 = z[2] - z[0];
  store((dz1 * dy2 - dz2 * dy1) * inverse, out.slope_x);
  store((dz2 * dx1 - dz1 * dx2) * inverse, out.slope_y);
  store(to_float(px - x[0]), out.x);
  store(to_float(py - y[0]), out.y);
  store(z[0], out.nearness);
  store(min(min(z[0], z[1]), z[2]), out.lowest);
  store(max(max(z[0], z[1]), z[2]), out.highest);
  // How steep the plane could be if the products above did not cancel each other.
  store(magnitude(inverse) * (magnitude(dz1) + magnitude(dz2)) *
            (magnitude(dx1) + magnitude(dx2) + magnitude(dy1) + magnitude(dy2)),
        out.slope_error);
}

/// Draws triangle `i` of a block into open pixels. kCenters: of pixels that it takes wholly nearness is kept.
template <bool kCenters>
BLYSK_INLINE void draw_patches(const SmallBlock& b, int i, I32 id, SampleTile& tile) {
  const SampleGrid& grid = tile.grid;
  const Square square;
  const F32 column = to_float(square.column), row = to_float(square.row);
  F32 at_pixels[3], at_samples[3];
  float step_x[3], step_y[3];
  for (int k = 0; k < 3; ++k) {
    const float dx = b.dx[k][i], dy = b.dy[k][i];
    step_x[k] = -8.0f * dy;
    step_y[k] = 8.0f * dx;
    at_pixels[k] = F32(b.patch_edge[k][i]) + (column * F32(step_x[k]) + row * F32(step_y[k]));
    at_samples[k] = F32(dx) * grid.y - F32(dy) * grid.x;
  }
  F32 reach[3];  // how far below 0 the centre of a pixel may be whose samples are not all out
  for (int k = 0; k < 3; ++k) {
    reach[k] = F32(-3.0f) * (magnitude(F32(b.dx[k][i])) + magnitude(F32(b.dy[k][i])));
  }
  const SampleSlopes slopes(grid, b.slope_x[i], b.slope_y[i]);
  const F32 lowest(b.lowest[i]), highest(b.highest[i]);
  const int left = b.left[i], top = b.top[i], right = b.right[i], bottom = b.bottom[i];

  for (int y = top; y <= bottom; y += 4) {
    const F32 down = F32(b.y[i]) + (row + F32(static_cast<float>(y - top))) * F32(kSubpixels);
    const F32 start = F32(b.nearness[i]) + down * F32(b.slope_y[i]);
    for (int x = left; x <= right; x += 4) {
      float edge[3][kLanes], center[kLanes];
      Mask reached = (square.column <= I32(right - x)) & (square.row <= I32(bottom - y));
      for (int k = 0; k < 3; ++k) {
        const F32 e = at_pixels[k] +
                      F32(step_x[k] * static_cast<float>(x - left) + step_y[k] * static_cast<float>(y - top));
        reached = reached & (e >= reach[k]);
        store(e, edge[k]);
      }
      const F32 across = F32(b.x[i]) + (column + F32(static_cast<float>(x - left))) * F32(kSubpixels);
      store(start + across * F32(b.slope_x[i]), center);
      const int corner = y * kTileSize + x;
      PixelSamples* const first = &tile.samples_of(corner);
      for (unsigned rest = to_bits(reached); rest != 0; rest &= rest - 1) {
        const int p = __builtin_ctz(rest);
        const I32 signs = bits_of(at_samples[0] + F32(edge[0][p])) |
                          bits_of(at_samples[1] + F32(edge[1][p])) |
                          bits_of(at_samples[2] + F32(edge[2][p]));  // a sum of floats is never -0 here
        const F32 depths = min(max(slopes.depths(center[p]), lowest), highest);
        const Mask wins = take(first[kPatchPlaces[p]], signs < I32(0), depths, id);
        if constexpr (kCenters) {
          if (to_bits(wins) != kAllSamples) continue;
          tile.pixels.nearness[corner + (p >> 2) * kTileSize + (p & 3)] =
              min(max(center[p], b.lowest[i]), b.highest[i]);
        }
      }
    }
  }
}

}  // namespace blysk::BLYSK_ISA
