// shading/determinant.h - a product less another of whole numbers, to the last digit where the sign hangs on
// it.
#pragma once

#include "shading/corners.h"

namespace blysk::BLYSK_ISA {

/// a * b - c * d modulo 2^32.
BLYSK_INLINE std::int32_t low_determinant(std::int32_t a, std::int32_t b, std::int32_t c, std::int32_t d) {
  const auto u = [](std::int32_t v) { return static_cast<std::uint32_t>(v); };
  return static_cast<std::int32_t>(u(a) * u(b) - u(c) * u(d));
}
template <int kRegisters>
BLYSK_INLINE Ints<kRegisters> low_determinant(Ints<kRegisters> a, Ints<kRegisters> b, Ints<kRegisters> c,
                                              Ints<kRegisters> d) {
  return a * b - c * d;
}

/// a * b - c * d of whole numbers up to 2^23 in size. Its sign is exact, and so it is up to one rounding
/// while it is under 2^30; beyond that both products may be off by 2^22.
template <class F>
BLYSK_INLINE F determinant(F a, F b, F c, F d) {
  // Where rounding could turn the sign, 32 bits hold the whole value.
  const F rough = a * b - c * d;
  const F size = float_of_bits(bits_of(rough) & Integer<F>(0x7fffffff));
  const F exact = to_float(low_determinant(truncate(a), truncate(b), truncate(c), truncate(d)));
  return select(size < F(1073741824.0f), exact, rough);
}

}  // namespace blysk::BLYSK_ISA
