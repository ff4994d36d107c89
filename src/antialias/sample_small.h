// antialias/sample_small.h - small triangles, sixteen at a time: what is hidden goes, what is not waits until
// it fills sixteen lanes again and is set up.
//
// All edge functions of patches, in units of 32 subpixels, are whole numbers that a float holds.
#pragma once

#include "antialias/sample_state.h"

namespace blysk::BLYSK_ISA {

/// Triangles under this extent each way are drawn in patches, others in rows: 12 pixels.
inline constexpr std::int32_t kPatchExtent = 12 * kSubpixels;

/// Sixteen small triangles, subpixels in the tile.
struct SmallTriangles {
  I32 id, x[3], y[3];
  F32 z[3];
};

BLYSK_INLINE SmallTriangles fetch_small(const TileJob& job, const SmallEntry* entries) {
  SmallTriangles t;
  F32 entry[4];
  gather_rows<4>(reinterpret_cast<const float*>(entries), iota(0), entry);
  t.id = bits_of(entry[0]);
  for (int k = 0; k < 3; ++k) {
    F32 vertex[4];
    gather_rows<4>(reinterpret_cast<const float*>(job.vertices), bits_of(entry[k + 1]), vertex);
    t.x[k] = bits_of(vertex[0]) - I32(job.x * kSubpixels);
    t.y[k] = bits_of(vertex[1]) - I32(job.y * kSubpixels);
    t.z[k] = vertex[2];
  }
  return t;
}

/// Pixels of the tile with a sample in the box of each, inclusive.
struct SmallBoxes {
  I32 left, top, right, bottom;
  F32 lowest, highest;
  Mask patches;
};

BLYSK_INLINE SmallBoxes boxes_of(const TileJob& job, const SmallTriangles& t) {
  const I32 x_min = min(min(t.x[0], t.x[1]), t.x[2]), x_max = max(max(t.x[0], t.x[1]), t.x[2]);
  const I32 y_min = min(min(t.y[0], t.y[1]), t.y[2]), y_max = max(max(t.y[0], t.y[1]), t.y[2]);
  const auto first = [](I32 v) {
    return shift_right<kSubpixelBits>(v + I32(kSubpixels / 2 - 1 - kSampleReach));
  };
  const auto last = [](I32 v) { return shift_right<kSubpixelBits>(v - I32(kSubpixels / 2 - kSampleReach)); };
  return {max(first(x_min), I32(0)),
          max(first(y_min), I32(0)),
          min(last(x_max), I32(job.width - 1)),
          min(last(y_max), I32(job.height - 1)),
          min(min(t.z[0], t.z[1]), t.z[2]),
          max(max(t.z[0], t.z[1]), t.z[2]),
          (x_max - x_min < I32(kPatchExtent)) & (y_max - y_min < I32(kPatchExtent))};
}

/// Those that wait to be drawn.
class SmallQueue {
 public:
  BLYSK_INLINE int count() const { return count_; }

  BLYSK_INLINE void add(Mask which, const SmallTriangles& t) {
    int added = store_compressed(which, t.id, column_[0] + count_);
    for (int k = 0; k < 3; ++k) {
      store_compressed(which, t.x[k], column_[1 + k] + count_);
      store_compressed(which, t.y[k], column_[4 + k] + count_);
      store_compressed(which, bits_of(t.z[k]), column_[7 + k] + count_);
    }
    count_ += added;
  }

  /// The first sixteen; less are what count() says, and others after them.
  BLYSK_INLINE SmallTriangles take() {
    SmallTriangles t;
    t.id = load(column_[0]);
    for (int k = 0; k < 3; ++k) {
      t.x[k] = load(column_[1 + k]);
      t.y[k] = load(column_[4 + k]);
      t.z[k] = float_of_bits(load(column_[7 + k]));
    }
    for (auto& column : column_) store(load(column + kLanes), column);
    count_ = max(count_ - kLanes, 0);
    return t;
  }

 private:
  std::int32_t column_[10][3 * kLanes] = {};
  int count_ = 0;
};

/// Bits of some blocks beside and below the first, for `across | down << 2` more of them.
struct BlockSpans {
  std::uint64_t of[16];
  constexpr BlockSpans() : of() {
    for (unsigned i = 0; i < 16; ++i) {
      for (unsigned row = 0; row <= i >> 2; ++row) of[i] |= ((2ull << (i & 3)) - 1) << kBlocksAcross * row;
    }
  }
};
inline constexpr BlockSpans kBlockSpans;

/// Sixteen small triangles as columns. Edge functions and depths at the centre of the first pixel of the box.
struct SmallBlock {
  std::int32_t id[kLanes];
  std::int32_t edge[3][kLanes];  ///< exact
  float patch_edge[3][kLanes];   ///< in units of 32 subpixels, rounded down; of patches only
  float dx[3][kLanes], dy[3][kLanes];
  float x[kLanes], y[kLanes], nearness[kLanes], slope_x[kLanes], slope_y[kLanes], lowest[kLanes],
      highest[kLanes], slope_error[kLanes];
  std::int32_t left[kLanes], top[kLanes], right[kLanes], bottom[kLanes];  ///< in the tile, inclusive
  unsigned patches;                                       ///< bits of the triangles to be drawn in patches
  std::int32_t first_block[kLanes], more_blocks[kLanes];  ///< across | down << 2; of patches only

  /// Bits of the blocks that a patch meets.
  BLYSK_INLINE std::uint64_t blocks(int i) const { return kBlockSpans.of[more_blocks[i]] << first_block[i]; }
};
static_assert((kPatchExtent / kSubpixels + kBlockSide - 1) / kBlockSide < 4);

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

BLYSK_INLINE void set_up_small(const TileJob& job, const SmallTriangles& t, SmallBlock& out) {
  const I32 *x = t.x, *y = t.y;
  const F32* z = t.z;
  const SmallBoxes box = boxes_of(job, t);
  store(t.id, out.id);
  store(box.left, out.left);
  store(box.top, out.top);
  store(box.right, out.right);
  store(box.bottom, out.bottom);
  store(box.lowest, out.lowest);
  store(box.highest, out.highest);
  out.patches = to_bits(box.patches);
  const I32 across = shift_right<kBlockBits>(box.left), down = shift_right<kBlockBits>(box.top);
  store((shift_left<kBlockBits>(down) + across) & I32(63), out.first_block);
  store(((shift_right<kBlockBits>(box.right) - across) +
         shift_left<2>(shift_right<kBlockBits>(box.bottom) - down)) &
            I32(15),
        out.more_blocks);

  const I32 px = shift_left<kSubpixelBits>(box.left) + I32(kSubpixels / 2);
  const I32 py = shift_left<kSubpixelBits>(box.top) + I32(kSubpixels / 2);
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
  // How steep the plane could be if the products above did not cancel each other.
  store(magnitude(inverse) * (magnitude(dz1) + magnitude(dz2)) *
            (magnitude(dx1) + magnitude(dx2) + magnitude(dy1) + magnitude(dy2)),
        out.slope_error);
}

}  // namespace blysk::BLYSK_ISA
