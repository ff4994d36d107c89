// antialias/fragment_words.h - how a fragment is written down for shading.
#pragma once

#include "antialias/sample_state.h"

namespace blysk::BLYSK_ISA {

/// What the samples of half a mask add to a fragment's word.
struct MaskWords {
  std::uint32_t word[2][256];
  constexpr MaskWords() : word() {
    for (unsigned half = 0; half < 2; ++half) {
      for (unsigned bits = 0; bits < 256; ++bits) {
        for (unsigned s = 0; s < 8; ++s) {
          if ((bits >> s & 1) == 0) continue;
          const unsigned row = half * 2 + s / 4, column = s % 4;
          word[half][bits] += (1u << kFragmentSamplesShift) + (2 * column << kFragmentColumnsShift) +
                              (2 * row << kFragmentRowsShift);
        }
      }
    }
  }
};
inline constexpr MaskWords kMaskWords;

BLYSK_INLINE std::int32_t fragment_word(int at, unsigned mask) {
  return static_cast<std::int32_t>(static_cast<unsigned>(at) + kMaskWords.word[0][mask & 255] +
                                   kMaskWords.word[1][mask >> 8]);
}

/// Over sixteen samples, in an order that does not depend on the instruction set.
BLYSK_INLINE float sum_of(F32 values) {
  float v[kSamples];
  store(values, v);
  for (int half = kSamples / 2; half > 0; half /= 2) {
    for (int i = 0; i < half; ++i) v[i] = v[i] + v[i + half];
  }
  return v[0];
}

/// The mean depth of some samples is the plane's at their centroid.
BLYSK_INLINE float mean_nearness(F32 nearness, unsigned mask) {
  return sum_of(select(lanes_of(mask), nearness, F32(0.0f))) / static_cast<float>(__builtin_popcount(mask));
}

}  // namespace blysk::BLYSK_ISA
