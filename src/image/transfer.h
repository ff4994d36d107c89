// image/transfer.h - the sRGB transfer function between linear light and 8-bit codes (IEC 61966-2-1).
#pragma once

#include <cstdint>

namespace blysk {

/// The exactly rounded code: the curve's value times 255, rounded to the nearest. Not a number and what is
/// below zero give 0, what is above one gives 255.
std::uint8_t encode_srgb(float linear);

/// What pictures are made with: a straight line for every eighth of an octave, in integers.
/// Max error: 0.54 codes from the curve, so at most one from encode_srgb; exact at 0 and 1. Monotonic.
std::uint8_t encode_srgb_fast(float linear);

// encode_srgb_fast step by step, for kernels that do the same on every lane (transfer.cpp is the model):
// clamp to [kSrgbLowest, kSrgbHighest] (not a number to kSrgbLowest), take the bits of the float, then
//   segment = kSrgbSegments[(bits - kSrgbLowestBits) >> 20]
//   code    = ((segment >> 16 << 9) + (segment & 0xffff) * (bits >> 12 & 0xff)) >> 16
// No intermediate value exceeds 24 bits; the factors have at most 16 and 8.
inline constexpr float kSrgbLowest = 0x1p-13f;
inline constexpr float kSrgbHighest = 0x1.fffffep-1f;
inline constexpr std::uint32_t kSrgbLowestBits = 114u << 23;
extern const std::uint32_t kSrgbSegments[104];

}  // namespace blysk
