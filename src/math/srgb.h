// math/srgb.h - linear light of sRGB codes that are numbers, without a power function of any libm.
#pragma once

namespace blysk {

/// The decoding curve of IEC 61966-2-1. Codes are clamped to 0..1; not a number gives 0.
/// Max error: 1 unit in the last place. Monotonic.
[[nodiscard]] float srgb_to_linear(float code);

}  // namespace blysk
