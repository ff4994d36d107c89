// antialias/sample_patch.h - small triangles, sample by sample: sixteen are set up at once, then the first
// pixels of their boxes are looked at at once, then the second ones and so on; then the sixteen samples of
// each pixel that one may reach.
#pragma once

#include "antialias/sample_small.h"

namespace blysk::BLYSK_ISA {

/// Draws patches into open pixels. What sixteen triangles may reach is listed first: one long loop is
/// foreseeable, many short ones are not.
class PatchPainter {
 public:
  explicit BLYSK_INLINE PatchPainter(SampleTile& tile) : tile_(tile) {}

  /// Triangles `which` of a block. kCenters: of pixels that one takes wholly nearness is kept.
  template <bool kCenters>
  BLYSK_INLINE void draw(const SmallBlock& b, Mask which) {
    set_up_samples(b);
    F32 row_edge[3], step_x[3], step_y[3], least[3];
    for (int k = 0; k < 3; ++k) {
      const F32 dx = load(b.dx[k]), dy = load(b.dy[k]);
      row_edge[k] = load(b.patch_edge[k]);
      step_x[k] = F32(-8.0f) * dy;
      step_y[k] = F32(8.0f) * dx;
      // How far below 0 the centre of a pixel may be whose samples are not all out.
      least[k] = F32(-3.0f) * (magnitude(dx) + magnitude(dy));
    }
    const I32 left = load(b.left), top = load(b.top);
    const I32 width = load(b.right) - left + I32(1), height = load(b.bottom) - top + I32(1);
    const F32 x = load(b.x), slope_x = load(b.slope_x);
    I32 corner = (shift_left<kTileBits>(top) + left) | shift_left<2 * kTileBits>(iota(0));
    for (int j = 0;; ++j, corner = corner + I32(kTileSize)) {
      const Mask in_row = which & (I32(j) < height);
      if (!any(in_row)) break;
      const F32 down = load(b.y) + F32(static_cast<float>(j * kSubpixels));
      const F32 start = load(b.nearness) + down * load(b.slope_y);
      F32 edge[3] = {row_edge[0], row_edge[1], row_edge[2]};
      for (int i = 0;; ++i) {
        const Mask inside = in_row & (I32(i) < width);
        if (!any(inside)) break;
        const Mask reached = inside & (edge[0] >= least[0]) & (edge[1] >= least[1]) & (edge[2] >= least[2]);
        if (any(reached)) {
          if (rows_ == kRows) take_all<kCenters>(b);
          const F32 across = x + F32(static_cast<float>(i * kSubpixels));
          add(reached, edge, start + across * slope_x, corner + I32(i));
        }
        for (int k = 0; k < 3; ++k) edge[k] = edge[k] + step_x[k];
      }
      for (int k = 0; k < 3; ++k) row_edge[k] = row_edge[k] + step_y[k];
    }
    take_all<kCenters>(b);
  }

 private:
  static constexpr int kRows = 32;

  /// What the samples of a pixel add to edge functions and depth at its centre.
  struct Samples {
    alignas(64) float edge[3][kSamples], along_x[kSamples], along_y[kSamples];
  };

  BLYSK_INLINE void set_up_samples(const SmallBlock& b) {
    const SampleGrid& grid = tile_.grid;
    for (int i = 0; i < kLanes; ++i) {
      for (int k = 0; k < 3; ++k) {
        store(F32(b.dx[k][i]) * grid.y - F32(b.dy[k][i]) * grid.x, samples_[i].edge[k]);
      }
      const SampleSlopes slopes(grid, b.slope_x[i], b.slope_y[i]);
      store(slopes.along_x, samples_[i].along_x);
      store(slopes.along_y, samples_[i].along_y);
    }
  }

  // Lanes are triangles.
  BLYSK_INLINE void add(Mask reached, const F32 edge[3], F32 center, I32 pixel) {
    const int first = rows_ * kLanes;
    for (int k = 0; k < 3; ++k) store(edge[k], edge_[k] + first);
    store(center, center_ + first);
    count_ += store_compressed(reached, pixel + I32(first << 2 * kTileBits), list_ + count_);
    ++rows_;
  }

  template <bool kCenters>
  BLYSK_INLINE void take_all(const SmallBlock& b) {
    PixelSamples* const open = tile_.samples.open;
    const int count = count_;
    for (int n = 0; n < count; ++n) {
      const int at = list_[n] & (kTilePixels - 1), cell = list_[n] >> 2 * kTileBits;
      const int i = cell & (kLanes - 1);
      const Samples& s = samples_[i];
      const I32 signs = bits_of(load(s.edge[0]) + F32(edge_[0][cell])) |
                        bits_of(load(s.edge[1]) + F32(edge_[1][cell])) |
                        bits_of(load(s.edge[2]) + F32(edge_[2][cell]));  // a sum of floats is never -0 here
      const F32 plane = (F32(center_[cell]) + load(s.along_x)) + load(s.along_y);
      const F32 depths = min(max(plane, F32(b.lowest[i])), F32(b.highest[i]));
      const Mask wins = take(open[SampleBuffers::place_of(at)], signs < I32(0), depths, I32(b.id[i]));
      if constexpr (kCenters) {
        if (to_bits(wins) != kAllSamples) continue;
        tile_.pixels.nearness[at] = min(max(center_[cell], b.lowest[i]), b.highest[i]);
      }
    }
    count_ = rows_ = 0;
  }

  SampleTile& tile_;
  Samples samples_[kLanes];
  // Pixels, a row for each place in the boxes.
  alignas(64) float edge_[3][kRows * kLanes], center_[kRows * kLanes];
  std::int32_t
      list_[kRows * kLanes + kLanes];  ///< pixel | triangle << 12 | row << 16: those that are reached
  int count_ = 0, rows_ = 0;
};

}  // namespace blysk::BLYSK_ISA
