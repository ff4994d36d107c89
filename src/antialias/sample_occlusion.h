// antialias/sample_occlusion.h - the farthest depth of each block of 16 x 16 pixels: what lies behind it
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

  /// Of a box in the tile, inclusive, and above all its depths.
  BLYSK_INLINE bool hides(int left, int top, int right, int bottom, float highest) const {
    for (int y = top / kBlock; y <= bottom / kBlock; ++y) {
      for (int x = left / kBlock; x <= right / kBlock; ++x) {
        if (highest >= farthest_[y * kAcross + x]) return false;
      }
    }
    return true;
  }

  /// `cost` in triangles of some pixels.
  BLYSK_INLINE void drawn(int left, int top, int right, int bottom, int cost, const SampleTile& tile) {
    const unsigned columns = (2u << (right / kBlock)) - (1u << (left / kBlock));
    for (int y = top / kBlock; y <= bottom / kBlock; ++y) stale_ |= columns << (y * kAcross);
    waited_ += cost;
    if (waited_ >= kWait) refresh(tile);
  }

 private:
  static constexpr int kBlock = kLanes, kAcross = kTileSize / kBlock;
  static constexpr int kWait = 128;

  __attribute__((noinline)) void refresh(const SampleTile& tile) {
    waited_ = 0;
    for (; stale_ != 0; stale_ &= stale_ - 1) {
      const int block = __builtin_ctz(stale_);
      farthest_[block] = farthest_of(tile, block / kAcross * kBlock * kTileSize + block % kAcross * kBlock);
    }
  }

  static BLYSK_INLINE float farthest_of(const SampleTile& tile, int at) {
    for (int row = 0; row < kBlock; ++row) {
      const I32 owner = load(tile.pixels.id + at + row * kTileSize);
      if (any(owner == I32(static_cast<std::int32_t>(kNoTriangle)))) return kNothingNear;
    }
    F32 least(1e30f);
    for (int row = 0; row < kBlock; ++row, at += kTileSize) {
      const I32 owner = load(tile.pixels.id + at);
      const F32 nearness = load(tile.pixels.nearness + at);
      const F32 half =
          (magnitude(load(tile.samples.slope_x + at)) + magnitude(load(tile.samples.slope_y + at))) *
          F32(kSampleReach);
      const F32 slack = (magnitude(nearness) + half) * F32(kSlack);
      least = select(owner >= I32(0), min(least, nearness - half - slack), least);
      for (unsigned open = to_bits(owner < I32(0)); open != 0; open &= open - 1) {
        least = min(least, load(tile.samples.nearness + (at + __builtin_ctz(open)) * kSamples));
      }
    }
    float lanes[kLanes];
    store(least, lanes);
    float farthest = lanes[0];
    for (int i = 1; i < kLanes; ++i) farthest = min(farthest, lanes[i]);
    return farthest;
  }

  float farthest_[kAcross * kAcross];
  unsigned stale_ = 0;
  int waited_ = 0;
};

}  // namespace blysk::BLYSK_ISA
