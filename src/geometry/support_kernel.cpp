// Sixteen points at a time. A maximum does not depend on the order it is taken in.
#include "geometry/support.h"
#include "simd/kernels.h"
#include "simd/lanes.h"

namespace blysk::BLYSK_ISA {

void support(const Vec3f* points, std::size_t count, const Vec3f* axis, float* reach) {
  const auto* in = reinterpret_cast<const float*>(points);
  F32 most[kSupportAxes];
  for (int k = 0; k < kSupportAxes; ++k) most[k] = F32(reach[k]);
  const auto take = [&](const float* block) __attribute__((always_inline)) {
    F32 x, y, z;
    load_interleaved(block, x, y, z);
    for (int k = 0; k < kSupportAxes; ++k) {
      most[k] = max(most[k], (F32(axis[k].x) * x + F32(axis[k].y) * y) + F32(axis[k].z) * z);
    }
  };
  std::size_t i = 0;
  for (; i + kLanes <= count; i += kLanes) take(in + 3 * i);
  if (i < count) {
    // The last block is filled up with its first point.
    float rest[3 * kLanes];
    for (int k = 0; k < kLanes; ++k) {
      const std::size_t at = i + static_cast<std::size_t>(k) < count ? i + static_cast<std::size_t>(k) : i;
      std::memcpy(rest + 3 * k, in + 3 * at, 3 * sizeof(float));
    }
    take(rest);
  }
  for (int k = 0; k < kSupportAxes; ++k) {
    float lanes[kLanes];
    store(most[k], lanes);
    for (const float v : lanes) reach[k] = max(reach[k], v);
  }
}

}  // namespace blysk::BLYSK_ISA
