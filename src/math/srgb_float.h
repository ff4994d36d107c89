// math/srgb_float.h - srgb_to_linear() for the colours of a million vertices.
#pragma once

namespace blysk {

/// As srgb_to_linear(double), five times as fast.
/// Max error: 1 unit in the last place of float. Monotonic.
[[nodiscard]] float srgb_to_linear(float value);

}  // namespace blysk
