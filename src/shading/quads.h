// shading/quads.h - four neighbouring pixels in sixteen lanes: red, green, blue and a fourth number of each.
//
// Runs of few pixels are shaded so: what a triangle has for the channels is one load for all pixels, and a
// value is written where it belongs.
#pragma once

#include "raster/tile.h"
#include "simd/lanes.h"

namespace blysk::BLYSK_ISA {

inline constexpr int kQuad = 4;

/// Four numbers, the same for every pixel.
BLYSK_INLINE F32 for_each_pixel(const float row[4]) {
  F32 r;
#if HWY_TARGET == HWY_SCALAR
  for (int i = 0; i < kLanes; ++i) r.part[i] = hn::LoadU(FloatTag(), row + (i & 3));
#else
  BLYSK_EACH(kParts, r.part[i] = hn::LoadDup128(FloatTag(), row));
#endif
  return r;
}

/// From the first pixel's centre to each pixel's, subpixels.
BLYSK_INLINE F32 quad_columns() { return to_float(shift_left<kSubpixelBits>(shift_right<2>(iota(0)))); }

/// Writes the pixels whose bits are set, opaque; channels are 0..255 and rounded here.
BLYSK_INLINE void store_quad(F32 v, unsigned pixels, std::uint32_t* to) {
  // Adding 2^23 leaves the nearest integer in the low bits.
  const I32 code = bits_of(v + F32(8388608.0f));
#if HWY_TARGET == HWY_AVX3
  const __m128i bytes = _mm512_cvtepi32_epi8(code.part[0].raw);
  const __m128i opaque = _mm_or_si128(bytes, _mm_set1_epi32(static_cast<int>(0xff000000)));
  _mm_mask_storeu_epi32(to, static_cast<__mmask8>(pixels & 15), opaque);
#else
  std::uint8_t bytes[kLanes];
  const hn::RebindToUnsigned<IntTag> words;
  const hn::Rebind<std::uint8_t, IntTag> tag;
  BLYSK_EACH(kParts, {
    const auto low = hn::BitCast(words, (code & I32(0xff)).part[i]);
    hn::StoreU(hn::U8FromU32(low), tag, bytes + i * kPartLanes);
  });
  for (int i = 0; i < kQuad; ++i) {
    std::uint32_t pixel;
    std::memcpy(&pixel, bytes + 4 * i, sizeof pixel);
    if ((pixels >> i & 1) != 0) to[i] = pixel | 0xff000000u;
  }
#endif
}

}  // namespace blysk::BLYSK_ISA
