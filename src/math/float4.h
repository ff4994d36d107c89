// math/float4.h - four floats at once where no kernel is worth its while: the compilers' own vectors, in the
// instructions that every processor has. Each lane rounds as a float does.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "blysk/vector.h"

namespace blysk {

using Float4 = float __attribute__((vector_size(16)));
using Mask4 = std::int32_t __attribute__((vector_size(16)));  ///< of a comparison: 0 or -1 in each lane

/// x, y, z of an Array's element and what lies behind them: an Array may be read 16 bytes past its end.
inline Float4 load4(const Vec3f* element) {
  Float4 v;
  std::memcpy(&v, reinterpret_cast<const char*>(element), sizeof v);
  return v;
}

inline Vec3f to_vector(Float4 v) { return {v[0], v[1], v[2]}; }

inline Float4 rotate(Float4 v) { return __builtin_shufflevector(v, v, 1, 2, 0, 3); }  ///< y, z, x, w

/// cross() of blysk/vector.h in the first three lanes, to the bit.
inline Float4 cross(Float4 a, Float4 b) { return rotate(a * rotate(b) - rotate(a) * b); }

/// Lane 0 says whether the first three lanes of `m` are all set.
inline Mask4 all3(Mask4 m) {
  return m & __builtin_shufflevector(m, m, 1, 2, 0, 3) & __builtin_shufflevector(m, m, 2, 0, 1, 3);
}

inline bool none4(Mask4 m) {
  std::uint64_t half[2];
  std::memcpy(half, &m, sizeof half);
  return (half[0] | half[1]) == 0;
}

inline Float4 magnitude(Float4 v) { return std::bit_cast<Float4>(std::bit_cast<Mask4>(v) & 0x7fffffff); }

/// dot() of blysk/vector.h, to the bit: of `a` with b, c, d, and with itself in the last lane.
inline Float4 dots(Float4 a, Float4 b, Float4 c, Float4 d) {
  const Float4 p = a * b, q = a * c, r = a * d, s = a * a;
  const Float4 pq = __builtin_shufflevector(p, q, 0, 4, 1, 5), rs = __builtin_shufflevector(r, s, 0, 4, 1, 5);
  const Float4 z = __builtin_shufflevector(__builtin_shufflevector(p, q, 2, 6, 2, 6),
                                           __builtin_shufflevector(r, s, 2, 6, 2, 6), 0, 1, 4, 5);
  return __builtin_shufflevector(pq, rs, 0, 1, 4, 5) + __builtin_shufflevector(pq, rs, 2, 3, 6, 7) + z;
}

}  // namespace blysk
