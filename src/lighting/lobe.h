// lighting/lobe.h - how the specular term falls off, for plain floats and for lanes.
//
// The exact power wants the square of the cosine, the others the cosine. The choice is one for a whole draw.
// lobe_reference.h has the formulas in double precision.
#pragma once

#include "lighting/lamp.h"
#include "simd/approx.h"
#include "simd/lanes.h"

namespace blysk::BLYSK_ISA {

/// x^k for k >= 1 by repeated squaring from the highest bit: at most two multiplications a bit.
template <class F>
BLYSK_INLINE F whole_power(F x, int k) {
  F r = x;
  for (int bit = 30 - __builtin_clz(static_cast<unsigned>(k)); bit >= 0; --bit) {
    r = r * r;
    if (((k >> bit) & 1) != 0) r = r * x;
  }
  return r;
}

/// cos^n from the square of a cosine in [0, 1].
template <class F>
BLYSK_INLINE F power_lobe(F square, const Surface& s) {
  if (s.whole_shininess == 0) {
    return select(square > F(0.0f), power_poly(max(square, F(1e-30f)), 0.5f * s.shininess), F(0.0f));
  }
  if (s.whole_shininess == 1) return sqrt(square);
  const F r = whole_power(square, s.whole_shininess >> 1);
  return (s.whole_shininess & 1) != 0 ? r * sqrt(square) : r;
}

/// 2^(n log2 c) with straight lines for both functions between powers of two, which is what the bits of a
/// float are; c in [0, 1].
///
/// Based on: J. N. Mitchell. Computer multiplication and division using binary logarithms. 1962.
template <class F>
BLYSK_INLINE F logarithmic_lobe(F c, float n) {
  using I = decltype(bits_of(c));
  constexpr std::int32_t kOne = 0x3f800000;
  const F lowest(-126.0f * 8388608.0f);  // of the normal floats
  const F log_power = to_float(bits_of(c) - I(kOne)) * F(n);
  return select(log_power > lowest, float_of_bits(truncate(max(log_power, lowest)) + I(kOne)), F(0.0f));
}

/// gamma^2 from 2 - 2 cos(gamma) in [0, 2], the square of the chord.
///
/// Max error: 9.1e-5 relative. Based on: shading thesis, section 8.1 of the specification.
template <class F>
BLYSK_INLINE F squared_angle(F chord) {
  F r = F(0.001645482f) * chord + F(0.003225090f);
  r = r * chord + F(0.042325762f);
  r = r * chord + F(0.999954859f);
  return r * r * chord;
}

/// The lobes that are not the exact power, from the cosine; a rounded one may pass 1.
template <class F>
BLYSK_INLINE F approximate_lobe(F cosine, const Surface& s) {
  const F c = min(cosine, F(1.0f));
  if (s.lobe == Lobe::logarithmic) return logarithmic_lobe(c, s.shininess);
  const F fall = F(1.0f) - c;
  if (s.lobe == Lobe::schlick) return c / (F(s.shininess) * fall + c);
  const F t = s.lobe == Lobe::quadratic ? squared_angle(fall + fall) : fall;
  return whole_power(max(F(1.0f) - F(s.lobe_scale) * t, F(0.0f)), s.lobe_exponent);
}

/// The surface's lobe from the square of a cosine in [0, 1]: 1 at 1, 0 at 0.
template <class F>
BLYSK_INLINE F specular_lobe(F square, const Surface& s) {
  if (__builtin_expect(s.lobe == Lobe::power, 1)) return power_lobe(square, s);
  return approximate_lobe(sqrt(square), s);
}

/// The same from what the lobe wants: the square for the exact power, the cosine for the others.
template <class F>
BLYSK_INLINE F lobe_of_argument(F argument, const Surface& s) {
  if (__builtin_expect(s.lobe == Lobe::power, 1)) return power_lobe(argument, s);
  return approximate_lobe(argument, s);
}

/// From a cosine in [0, 1].
template <class F>
BLYSK_INLINE F lobe_of_cosine(F c, const Surface& s) {
  if (__builtin_expect(s.lobe == Lobe::power, 1)) return power_lobe(c * c, s);
  return approximate_lobe(c, s);
}

}  // namespace blysk::BLYSK_ISA
