// antialias/sample_rows.h - larger triangles, sample by sample: rows of sixteen pixels first, of which those
// that the triangle wholly covers and that show one surface are decided at once; samples where that is not
// enough.
#pragma once

#include "antialias/sample_patch.h"

namespace blysk::BLYSK_ISA {

// A bound on rounding: what is farther apart than this part of its size keeps its order.
inline constexpr float kSlack = 0x1p-20f;

/// A triangle ready for its rows in one tile; at the centre of its first pixel.
struct RowSurface {
  std::int64_t edge[3];  ///< exact
  std::int32_t dx[3], dy[3];
  float x, y;  ///< from vertex 0, subpixels
  float nearness, slope_x, slope_y;
  float lowest, highest;                  ///< of the vertices
  float ceiling;                          ///< above all depths, whatever was rounded
  std::int32_t left, top, right, bottom;  ///< in the tile, inclusive
  std::int32_t id;

  BLYSK_INLINE Box box() const { return {left, top, right, bottom}; }
};

BLYSK_INLINE float ceiling_of(const RowSurface& s, float slope_error) {
  const auto size = [](float v) { return v < 0 ? -v : v; };
  const float far = size(s.x) + size(s.y) + 2.0f * kTileSize * kSubpixels;
  return s.highest + (1.0f + slope_error * far) * kSlack;
}

BLYSK_INLINE RowSurface row_surface(const SmallBlock& b, int i) {
  RowSurface s;
  for (int k = 0; k < 3; ++k) {
    s.edge[k] = b.edge[k][i];
    s.dx[k] = static_cast<std::int32_t>(b.dx[k][i]);
    s.dy[k] = static_cast<std::int32_t>(b.dy[k][i]);
  }
  s.x = b.x[i];
  s.y = b.y[i];
  s.nearness = b.nearness[i];
  s.slope_x = b.slope_x[i];
  s.slope_y = b.slope_y[i];
  s.lowest = b.lowest[i];
  s.highest = b.highest[i];
  s.left = b.left[i];
  s.top = b.top[i];
  s.right = b.right[i];
  s.bottom = b.bottom[i];
  s.id = b.id[i];
  s.ceiling = ceiling_of(s, b.slope_error[i]);
  return s;
}

inline RowSurface row_surface(const TileJob& job, const LargeEntry& t) {
  RowSurface s;
  const auto first = [](std::int32_t v) { return (v + kSubpixels / 2 - 1 - kSampleReach) >> kSubpixelBits; };
  const auto last = [](std::int32_t v) { return (v - kSubpixels / 2 + kSampleReach) >> kSubpixelBits; };
  s.left = max(first(min(min(t.x[0], t.x[1]), t.x[2])) - job.x, 0);
  s.top = max(first(min(min(t.y[0], t.y[1]), t.y[2])) - job.y, 0);
  s.right = min(last(max(max(t.x[0], t.x[1]), t.x[2])) - job.x, job.width - 1);
  s.bottom = min(last(max(max(t.y[0], t.y[1]), t.y[2])) - job.y, job.height - 1);
  s.id = static_cast<std::int32_t>(t.id);

  const std::int64_t px = std::int64_t{job.x + s.left} * kSubpixels + kSubpixels / 2;
  const std::int64_t py = std::int64_t{job.y + s.top} * kSubpixels + kSubpixels / 2;
  for (int k = 0; k < 3; ++k) {
    const int a = (k + 1) % 3, b = (k + 2) % 3;
    s.dx[k] = t.x[b] - t.x[a];
    s.dy[k] = t.y[b] - t.y[a];
    const bool owns = s.dy[k] < 0 || (s.dy[k] == 0 && s.dx[k] > 0);
    s.edge[k] = s.dx[k] * (py - t.y[a]) - s.dy[k] * (px - t.x[a]) + (owns ? 0 : -1);
  }

  const double dx1 = t.x[1] - t.x[0], dy1 = t.y[1] - t.y[0], dx2 = t.x[2] - t.x[0], dy2 = t.y[2] - t.y[0];
  const double inverse = 1.0 / (dx1 * dy2 - dx2 * dy1);
  const double dz1 = double{t.nearness[1]} - double{t.nearness[0]},
               dz2 = double{t.nearness[2]} - double{t.nearness[0]};
  s.slope_x = static_cast<float>((dz1 * dy2 - dz2 * dy1) * inverse);
  s.slope_y = static_cast<float>((dz2 * dx1 - dz1 * dx2) * inverse);
  s.x = static_cast<float>(px - t.x[0]);
  s.y = static_cast<float>(py - t.y[0]);
  s.nearness = t.nearness[0];
  s.lowest = min(min(t.nearness[0], t.nearness[1]), t.nearness[2]);
  s.highest = max(max(t.nearness[0], t.nearness[1]), t.nearness[2]);
  const auto size = [](double v) { return v < 0 ? -v : v; };
  s.ceiling = ceiling_of(s, static_cast<float>(size(inverse) * (size(dz1) + size(dz2)) *
                                               (size(dx1) + size(dx2) + size(dy1) + size(dy2))));
  return s;
}

/// The edge functions of a RowSurface, counted in pixels: for integers e and s, e + 256 k s >= 0 exactly if
/// (e >> 8) + k s >= 0. Inside a tile they change by less than 64 * 2 * 2^23 = 2^30; what is farther off is
/// clamped, as only its sign matters.
struct RowEdges {
  std::int32_t value[3], step_x[3], step_y[3];
  std::int32_t none[3];  ///< a pixel whose value is below this has no sample inside
  std::int32_t all[3];   ///< a pixel whose value is not below this has all of them inside
  BLYSK_INLINE explicit RowEdges(const RowSurface& s) {
    constexpr std::int64_t kFar = std::int64_t{1} << 30;
    for (int k = 0; k < 3; ++k) {
      const std::int64_t dx = s.dx[k], dy = s.dy[k];
      const std::int64_t reach = ((dx < 0 ? -dx : dx) + (dy < 0 ? -dy : dy)) * kSampleReach;
      value[k] = static_cast<std::int32_t>(clamp(s.edge[k] >> kSubpixelBits, -kFar, kFar));
      step_x[k] = -s.dy[k];
      step_y[k] = s.dx[k];
      none[k] = -static_cast<std::int32_t>(reach >> kSubpixelBits) - 1;
      all[k] = static_cast<std::int32_t>(reach >> kSubpixelBits) + 1;
    }
  }
};

/// The samples of a pixel that the triangle does not cover. `at_samples` is what they add to its edge
/// functions, in units of 32 subpixels; `column` and `row` count from the first pixel.
BLYSK_INLINE Mask samples_out(const RowSurface& s, const I32 at_samples[3], int column, int row) {
  // Samples change an edge function by less than 2^27: what is farther from 0 than 2^30 keeps its sign.
  constexpr std::int64_t kFar = std::int64_t{1} << 30;
  I32 signs(0);
  for (int k = 0; k < 3; ++k) {
    const std::int64_t center =
        s.edge[k] + (std::int64_t{row} * s.dx[k] - std::int64_t{column} * s.dy[k]) * kSubpixels;
    signs = signs | (at_samples[k] + I32(static_cast<std::int32_t>(clamp(center >> 5, -kFar, kFar))));
  }
  return signs < I32(0);
}

/// Draws one triangle's rows.
class RowPainter {
 public:
  BLYSK_INLINE RowPainter(const RowSurface& s, SampleTile& tile)
      : s_(s), edges_(s), tile_(tile), slopes_(tile.grid, s.slope_x, s.slope_y) {
    for (int k = 0; k < 3; ++k) {
      at_samples_[k] = I32(s.dx[k]) * tile.grid.down - I32(s.dy[k]) * tile.grid.across;
    }
  }

  BLYSK_INLINE void draw() {
    const I32 lane = iota(0);
    const F32 lane_x = to_float(shift_left<kSubpixelBits>(lane));
    I32 ramp[3];
    for (int k = 0; k < 3; ++k) ramp[k] = lane * I32(edges_.step_x[k]);
    for (int left = s_.left; left <= s_.right; left += kLanes) {
      const int skipped = left - s_.left;
      const Mask inside = lanes_below(s_.right - left + 1);
      I32 e[3];
      for (int k = 0; k < 3; ++k) e[k] = ramp[k] + I32(edges_.value[k] + skipped * edges_.step_x[k]);
      const F32 along = (F32(s_.x + static_cast<float>(skipped * kSubpixels)) + lane_x) * F32(s_.slope_x);
      float dy = s_.y;
      for (int y = s_.top; y <= s_.bottom; ++y) {
        const Mask reached = inside & (e[0] >= I32(edges_.none[0])) & (e[1] >= I32(edges_.none[1])) &
                             (e[2] >= I32(edges_.none[2]));
        if (any(reached)) {
          const Mask whole = reached & (e[0] >= I32(edges_.all[0])) & (e[1] >= I32(edges_.all[1])) &
                             (e[2] >= I32(edges_.all[2]));
          draw_block(left, y, reached, whole, F32(s_.nearness + dy * s_.slope_y) + along);
        }
        for (int k = 0; k < 3; ++k) e[k] = e[k] + I32(edges_.step_y[k]);
        dy += static_cast<float>(kSubpixels);
      }
    }
  }

  /// Whether the triangle covers all samples of a whole tile.
  BLYSK_INLINE bool covers_tile() const {
    constexpr int kLast = kTileSize - 1;
    if (s_.left != 0 || s_.top != 0 || s_.right != kLast || s_.bottom != kLast) return false;
    for (int k = 0; k < 3; ++k) {
      if (edges_.value[k] + kLast * (min(edges_.step_x[k], 0) + min(edges_.step_y[k], 0)) < edges_.all[k]) {
        return false;
      }
    }
    return true;
  }

  /// What draw() leaves of a triangle that covers a clear tile, without clearing or asking first.
  BLYSK_INLINE void fill_tile() {
    const F32 lane_x = to_float(shift_left<kSubpixelBits>(iota(0)));
    float dy = s_.y;
    for (int y = 0; y < kTileSize; ++y, dy += static_cast<float>(kSubpixels)) {
      const F32 start(s_.nearness + dy * s_.slope_y);
      for (int x = 0; x < kTileSize; x += kLanes) {
        const F32 along = (F32(s_.x + static_cast<float>(x * kSubpixels)) + lane_x) * F32(s_.slope_x);
        const int at = y * kTileSize + x;
        store(in_range(start + along), tile_.pixels.nearness + at);
        store(I32(s_.id), tile_.pixels.id + at);
        store(F32(s_.slope_x), tile_.samples.slope_x + at);
        store(F32(s_.slope_y), tile_.samples.slope_y + at);
      }
    }
  }

 private:
  BLYSK_INLINE F32 in_range(F32 nearness) const {
    return min(max(nearness, F32(s_.lowest)), F32(s_.highest));
  }

  // How much a plane's depth differs inside a pixel from that at its centre.
  BLYSK_INLINE static F32 half_range(F32 slope_x, F32 slope_y) {
    return (magnitude(slope_x) + magnitude(slope_y)) * F32(kSampleReach);
  }

  // Sixteen pixels of a row.
  BLYSK_INLINE void draw_block(int left, int y, Mask reached, Mask whole, F32 plane) {
    const int at = y * kTileSize + left;
    const F32 nearness = in_range(plane), old = load(tile_.pixels.nearness + at);
    const I32 owner = load(tile_.pixels.id + at);
    const F32 own_half = half_range(F32(s_.slope_x), F32(s_.slope_y));
    const F32 old_half = half_range(load(tile_.samples.slope_x + at), load(tile_.samples.slope_y + at));
    const F32 slack = (magnitude(nearness) + magnitude(old) + own_half + old_half) * F32(kSlack);
    const Mask nothing = owner == I32(static_cast<std::int32_t>(kNoTriangle));
    const Mask simple = owner >= I32(0);
    const F32 margin = old_half + slack;
    const Mask nearer = whole & (nothing | (simple & (nearness - old > own_half + margin)));
    const F32 nearest = select(whole, nearness + own_half, F32(s_.highest));
    const Mask hidden = simple & (old - nearest > margin);
    settle(at, nearer, nearness);

    const unsigned undecided = to_bits(and_not(nearer | hidden, reached));
    if (undecided == 0) return;
    const unsigned whole_bits = to_bits(whole);
    float planes[kLanes], in_ranges[kLanes];
    store(plane, planes);
    store(nearness, in_ranges);
    for (unsigned rest = undecided; rest != 0; rest &= rest - 1) {
      const int i = __builtin_ctz(rest);
      if ((whole_bits >> i & 1) != 0) {
        draw_whole(at + i, in_ranges[i]);
      } else {
        draw_part(at + i, left + i - s_.left, y - s_.top, planes[i], in_ranges[i]);
      }
    }
  }

  BLYSK_INLINE void settle(int at, Mask where, F32 nearness) {
    store_masked(where, nearness, tile_.pixels.nearness + at);
    store_masked(where, I32(s_.id), tile_.pixels.id + at);
    store_masked(where, F32(s_.slope_x), tile_.samples.slope_x + at);
    store_masked(where, F32(s_.slope_y), tile_.samples.slope_y + at);
  }

  BLYSK_INLINE void draw_whole(int at, float nearness) {
    if (!tile_.is_open(at)) tile_.open_one(at);
    const Mask none = I32(0) != I32(0);
    const Mask wins = take(tile_.samples_of(at), none, slopes_.depths(nearness), I32(s_.id));
    if (to_bits(wins) == kAllSamples) tile_.close(at, nearness, s_.slope_x, s_.slope_y, s_.id);
  }

  // `column` and `row` from the first pixel.
  BLYSK_INLINE void draw_part(int at, int column, int row, float plane, float nearness) {
    const Mask uncovered = samples_out(s_, at_samples_, column, row);
    if (to_bits(uncovered) == kAllSamples) return;
    if (!tile_.is_open(at)) tile_.open_one(at);
    if (any(take(tile_.samples_of(at), uncovered, in_range(slopes_.depths(plane)), I32(s_.id)))) {
      // Where the pieces of a clipped triangle come to cover all samples any of them will do.
      tile_.pixels.nearness[at] = nearness;
    }
  }

  const RowSurface& s_;
  const RowEdges edges_;
  SampleTile& tile_;
  const SampleSlopes slopes_;
  I32 at_samples_[3];  // in units of 32 subpixels
};

}  // namespace blysk::BLYSK_ISA
