// antialias/glass_compose.h - what each layer, and what lies behind, makes up of a pixel.
#pragma once

#include "antialias/fragment_words.h"
#include "antialias/glass.h"

namespace blysk::BLYSK_ISA {

/// The layers of one pixel. Lanes are samples.
class GlassPixel {
 public:
  BLYSK_INLINE GlassPixel(const GlassBuffers& g, int at, const SampleGrid& grid) {
    for (std::int32_t i = g.first[at]; i >= 0; i = g.layer[i].next) insert(&g.layer[i]);
    for (int i = 0; i < count_; ++i) place(i, grid);
    pass_light();
  }

  /// Layer by layer in an order that does not depend on that of submission.
  template <class Visit>
  BLYSK_INLINE void for_each(Visit visit) const {
    for (int i = 0; i < count_; ++i) visit(*layer_[i], load(depth_[i]), sum_of(load(weight_[i])));
  }

  /// How much of what lies behind is seen at each sample.
  BLYSK_INLINE F32 through() const { return load(through_); }

 private:
  static constexpr float kAway = 2 * kNothingNear;  // depth where a layer is not

  static BLYSK_INLINE bool before(const GlassLayer& a, const GlassLayer& b) {
    if (a.center != b.center) return a.center > b.center;
    if (a.slope_x != b.slope_x) return a.slope_x < b.slope_x;
    if (a.slope_y != b.slope_y) return a.slope_y < b.slope_y;
    return a.id < b.id;
  }

  BLYSK_INLINE void insert(const GlassLayer* layer) {
    int i = count_++;
    for (; i > 0 && before(*layer, *layer_[i - 1]); --i) layer_[i] = layer_[i - 1];
    layer_[i] = layer;
  }

  // Sorts layer `i` into those before it, sample by sample. Mostly it comes last at all of them.
  BLYSK_INLINE void place(int i, const SampleGrid& grid) {
    const GlassLayer& l = *layer_[i];
    const SampleSlopes slopes(grid, l.slope_x, l.slope_y);
    const F32 depths = min(max(slopes.depths(l.center), F32(l.lowest)), F32(l.highest));
    opacity_[i] = l.opacity;
    store(depths, depth_[i]);
    store(F32(0.0f), weight_[i]);
    F32 z = select(lanes_of(l.mask), depths, F32(kAway));
    I32 id(l.id), who(i);
    int k = i;
    for (; k > 0; --k) {
      const F32 other = load(sorted_depth_[k - 1]);
      const I32 other_id = load(sorted_id_[k - 1]);
      const Mask swaps = (z > other) | ((z == other) & (id < other_id));
      if (!any(swaps)) break;
      const I32 other_who = load(sorted_who_[k - 1]);
      store(select(swaps, other, z), sorted_depth_[k]);
      store(select(swaps, other_id, id), sorted_id_[k]);
      store(select(swaps, other_who, who), sorted_who_[k]);
      z = select(swaps, z, other);
      id = select(swaps, id, other_id);
      who = select(swaps, who, other_who);
    }
    store(z, sorted_depth_[k]);
    store(id, sorted_id_[k]);
    store(who, sorted_who_[k]);
  }

  // Front to back.
  BLYSK_INLINE void pass_light() {
    F32 through(1.0f);
    for (int k = 0; k < count_; ++k) {
      const Mask there = load(sorted_depth_[k]) > F32(kNothingNear);
      const I32 who = load(sorted_who_[k]);
      const F32 opacity = gather(opacity_, who);
      float weight[kSamples];
      store(through * opacity, weight);
      through = select(there, through * (F32(1.0f) - opacity), through);
      for (unsigned rest = to_bits(there); rest != 0; rest &= rest - 1) {
        const int s = __builtin_ctz(rest);
        weight_[sorted_who_[k][s]][s] = weight[s];
      }
    }
    store(through, through_);
  }

  int count_ = 0;
  const GlassLayer* layer_[kMostLayers];
  float opacity_[kMostLayers];
  float depth_[kMostLayers][kSamples], weight_[kMostLayers][kSamples];
  float sorted_depth_[kMostLayers][kSamples];
  std::int32_t sorted_id_[kMostLayers][kSamples], sorted_who_[kMostLayers][kSamples];
  float through_[kSamples];
};

struct WeighedFragment {
  std::int32_t id;
  unsigned mask;
  float nearness, weight;
};

BLYSK_INLINE void write_weighed(SampleBuffers& s, int at, const WeighedFragment& f) {
  s.fragment_id[s.fragments] = f.id;
  s.fragment_place[s.fragments] = fragment_word(at, f.mask);
  s.fragment_nearness[s.fragments] = f.nearness;
  s.fragment_weight[s.fragments] = f.weight;
  ++s.fragments;
}

/// A layer that several have become, part by part.
BLYSK_INLINE void write_parts(SampleBuffers& s, int at, const FullPixel& full, float nearness, float weight) {
  float sum = 0;
  for (int i = 0; i < full.parts; ++i) sum = sum + full.part[i].weight;
  for (int i = 0; i < full.parts; ++i) {
    const GlassPart& p = full.part[i];
    write_weighed(s, at, {p.id, p.mask, nearness, weight * (p.weight / sum)});
  }
}

/// Lists the fragments of pixels with transparent layers, after those of all others.
template <bool kCenters>
inline void compose_glass(const SampleJob& job, const SampleTile& tile) {
  SampleBuffers& s = *job.samples;
  const GlassBuffers& g = *job.glass;
  for (int i = 0; i < s.fragments; i += kLanes) {
    const I32 samples = shift_right<kFragmentSamplesShift>(load(s.fragment_place + i)) & I32(31);
    store(to_float(samples), s.fragment_weight + i);
  }
  for (int i = 0; i < g.pixels; ++i) {
    const int at = g.pixel[i];
    const GlassPixel glass(g, at, tile.grid);
    const FullPixel& full = g.full[at];
    const GlassLayer* const merged = g.merged[at] != 0 ? g.layer + full.layer[full.last] : nullptr;
    glass.for_each([&](const GlassLayer& l, F32 depths, float weight) {
      if (weight == 0) return;  // behind layers that let nothing through
      const float nearness = kCenters ? mean_nearness(depths, l.mask) : 0.0f;
      if (&l == merged) {
        write_parts(s, at, full, nearness, weight);
      } else {
        write_weighed(s, at, {l.id, l.mask, nearness, weight});
      }
    });
    const PixelSamples& pixel = tile.samples_of(at);
    const I32 ids = load(pixel.id);
    float background = 0;
    for (unsigned rest = kAllSamples; rest != 0;) {
      const std::int32_t id = pixel.id[__builtin_ctz(rest)];
      const Mask same = ids == I32(id);
      const unsigned mask = to_bits(same);
      const float weight = sum_of(select(same, glass.through(), F32(0.0f)));
      if (id == kNoSurface) {
        background = weight;
      } else {
        write_weighed(s, at, {id, mask, kCenters ? mean_nearness(load(pixel.nearness), mask) : 0.0f, weight});
      }
      rest &= ~mask;
    }
    for (int k = 0; k < 4; ++k) s.sum[4 * at + k] = job.background[k] * background;
    job.tile.buffers->id[at] = kManySurfaces;
    s.pixel[s.pixels++] = at;
  }
}

}  // namespace blysk::BLYSK_ISA
