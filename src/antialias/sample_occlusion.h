// antialias/sample_occlusion.h - the farthest depth of each block of 8 x 8 pixels: what lies behind it
// everywhere is hidden, and goes before any work per pixel. It only ever rejects what all samples would.
//
// Based on: N. Greene, M. Kass, G. Miller. Hierarchical Z-buffer visibility. 1993. Differs in: one level,
// brought up to date now and then.
#pragma once

#include "antialias/sample_rows.h"

namespace blysk::BLYSK_ISA {

class SampleOcclusion {
 public:
  BLYSK_INLINE SampleOcclusion() {
    for (float& f : farthest_) f = kNothingNear;
  }

  /// Of what lies in a box, no nearer than `highest`.
  BLYSK_INLINE bool hides(const Box& box, float highest) const {
    for (int y = box.top >> kBlockBits; y <= box.bottom >> kBlockBits; ++y) {
      for (int x = box.left >> kBlockBits; x <= box.right >> kBlockBits; ++x) {
        if (highest >= farthest_[y * kBlocksAcross + x]) return false;
      }
    }
    return true;
  }

  /// Of sixteen small triangles, those that are hidden and will be drawn in patches: these keep to the range
  /// of their vertices.
  BLYSK_INLINE Mask hidden(const SmallBoxes& b) const {
    const I32 left = shift_right<kBlockBits>(b.left), top = shift_right<kBlockBits>(b.top);
    const I32 width = shift_right<kBlockBits>(b.right) - left;
    const I32 height = shift_right<kBlockBits>(b.bottom) - top;
    const Mask few = (width < I32(2)) & (height < I32(2));
    const I32 table = (width + shift_left<1>(height)) & I32(3);
    // Lanes past the last triangle may lie anywhere.
    const I32 block = (shift_left<kBlockBits>(top) + left) & I32(kBlocks - 1);
    return b.patches & few & (b.highest < gather(farthest_, block + table * I32(kTable)));
  }

  BLYSK_INLINE void drawn(std::uint64_t blocks, int cost, const SampleTile& tile) {
    stale_ |= blocks;
    waited_ += cost;
    if (__builtin_expect(waited_ >= kWait, 0)) refresh(tile);
  }

  __attribute__((noinline)) void refresh(const SampleTile& tile) {
    waited_ = 0;
    for (; stale_ != 0; stale_ &= stale_ - 1) {
      const int block = __builtin_ctzll(stale_);
      const int at = first_pixel_of(block);
      const F32 least = (tile.open_blocks >> block & 1) != 0 ? least_of_open(tile, at) : least_of(tile, at);
      float lanes[kLanes];
      store(least, lanes);
      float farthest = lanes[0];
      for (int i = 1; i < kLanes; ++i) farthest = min(farthest, lanes[i]);
      farthest_[block] = farthest;
    }
    // Past the last column and row stands what no box asks for.
    for (int i = 0; i < kBlocks; i += kLanes) {
      const float* here = farthest_ + i;
      const F32 beside = min(load(here), load(here + 1));
      const F32 below = min(load(here + kBlocksAcross), load(here + kBlocksAcross + 1));
      store(beside, farthest_ + kTable + i);
      store(min(load(here), load(here + kBlocksAcross)), farthest_ + 2 * kTable + i);
      store(min(beside, below), farthest_ + 3 * kTable + i);
    }
  }

 private:
  static constexpr int kWait = 512;  // small triangles: a refresh costs as much as a few of them

  static BLYSK_INLINE F32 least_of_open(const SampleTile& tile, int at) {
    F32 even(1e30f), odd(1e30f);  // two chains at once
    for (int row = 0; row < kBlockSide; ++row, at += kTileSize) {
      const PixelSamples* pixels = &tile.samples_of(at);
      for (int i = 0; i < kBlockSide; i += 2) {
        even = min(even, load(pixels[i].nearness));
        odd = min(odd, load(pixels[i + 1].nearness));
      }
    }
    return min(even, odd);
  }

  static BLYSK_INLINE F32 least_of(const SampleTile& tile, int at) {
    F32 least(1e30f);
    const Mask inside = lanes_below(kBlockSide);
    for (int row = 0; row < kBlockSide; ++row, at += kTileSize) {
      const I32 owner = load(tile.pixels.id + at);
      if (any(inside & (owner == I32(static_cast<std::int32_t>(kNoTriangle))))) return F32(kNothingNear);
      const F32 nearness = load(tile.pixels.nearness + at);
      const F32 half =
          (magnitude(load(tile.samples.slope_x + at)) + magnitude(load(tile.samples.slope_y + at))) *
          F32(kSampleReach);
      const F32 slack = (magnitude(nearness) + half) * F32(kSlack);
      least = select(inside & (owner >= I32(0)), min(least, nearness - half - slack), least);
      for (unsigned open = to_bits(inside & (owner < I32(0))); open != 0; open &= open - 1) {
        least = min(least, load(tile.samples_of(at + __builtin_ctz(open)).nearness));
      }
    }
    return least;
  }

  static constexpr int kBlocks = kBlocksAcross * kBlocksAcross, kTable = kBlocks + kLanes;
  // Of blocks; of two beside each other, two below each other, and four, from the first one on.
  float farthest_[4 * kTable];
  std::uint64_t stale_ = 0;
  int waited_ = 0;
};

}  // namespace blysk::BLYSK_ISA
