// math/noise.h - gradient noise with its exact slope.
//
// Based on: Perlin. Improving Noise. 2002.
#pragma once

#include "blysk/vector.h"

namespace blysk {

struct Noise {
  double value;    ///< below 1.04 in magnitude, 0 at whole coordinates
  Vec3d gradient;  ///< of `value`
};

/// Repeats every 256 along each axis. Valid range: |coordinate| < 2^31.
[[nodiscard]] Noise gradient_noise(Vec3d p);

}  // namespace blysk
