// Transforms, divides and snaps sixteen vertices at a time.
#include "geometry/transform.h"
#include "simd/kernels.h"
#include "simd/lanes.h"

namespace blysk::BLYSK_ISA {
namespace {

struct Positions {
  F32 x, y, z;
};

BLYSK_INLINE F32 row_times(const float* row, const Positions& p) {
  return (F32(row[0]) * p.x + F32(row[1]) * p.y) + (F32(row[2]) * p.z + F32(row[3]));
}

// The four words of sixteen vertices.
BLYSK_INLINE void transform_block(const Projection& m, const Positions& p, std::int32_t* out) {
  const F32 w = row_times(m.row[3], p);
  const F32 q = F32(1.0f) / w;
  const F32 x = row_times(m.row[0], p) * q;
  const F32 y = row_times(m.row[1], p) * q;
  const F32 nearness = row_times(m.row[2], p) * q;

  // Written so that anything not a number fails; the lanes that fail must not reach the conversion.
  constexpr auto kGuard = static_cast<float>(kGuardBand);
  const Mask placed = (w > F32(0.0f)) & (nearness >= F32(0.0f)) & (nearness <= F32(1.0f)) &
                      (x <= F32(kGuard)) & (x >= F32(-kGuard)) & (y <= F32(kGuard)) & (y >= F32(-kGuard));
  const I32 xi = select(placed, nearest(select(placed, x, F32(0.0f))), I32(kUnplaced));
  const I32 yi = nearest(select(placed, y, F32(0.0f)));
  store_interleaved(xi, yi, bits_of(nearness), bits_of(q), out);
}

}  // namespace

void transform_vertices(const TransformJob& job) {
  const auto* in = reinterpret_cast<const float*>(job.positions);
  auto* out = reinterpret_cast<std::int32_t*>(job.out);
  Positions p;
  std::size_t i = 0;
  for (; i + kLanes <= job.count; i += kLanes) {
    load_interleaved(in + 3 * i, p.x, p.y, p.z);
    transform_block(job.projection, p, out + 4 * i);
  }
  if (i < job.count) {
    float rest[3 * kLanes] = {};
    std::int32_t words[4 * kLanes];
    std::memcpy(rest, in + 3 * i, (job.count - i) * sizeof(Vec3f));
    load_interleaved(rest, p.x, p.y, p.z);
    transform_block(job.projection, p, words);
    std::memcpy(out + 4 * i, words, (job.count - i) * sizeof(ScreenVertex));
  }
}

}  // namespace blysk::BLYSK_ISA
