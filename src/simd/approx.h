// simd/approx.h - roots, logarithms and powers of kernels, from + - * and integers alone.
//
// Exact division and square root are the slow instructions of a processor, its approximate ones differ
// between vendors. These polynomials are neither. Every template serves float and F32 with the same bits. The
// reference forms are the standard functions in double precision (approx_test.cpp measures the errors).
#pragma once

#include "simd/lanes.h"

namespace blysk::BLYSK_ISA {

/// 1 / sqrt(x) by a bit-level first guess y, good to 3.6 %, and the best cubic for 1 / sqrt(z) in what is
/// left, z = x y^2 in [0.9297, 1.0645]. Two halves of the cubic wait less for each other than Newton's steps
/// would.
///
/// Max error: 1.2e-6 relative. Valid range: [1e-37, 1e37].
/// Based on: L. Moroz, C. Walczyk, A. Hrynchyshyn, V. Holimath, J. Cieslinski. Fast calculation of inverse
/// square root with the use of magic constant - analytical approach. 2018. Differs in: own constant and
/// cubic.
template <class F>
BLYSK_INLINE F reciprocal_root(F x) {
  const F y = float_of_bits(decltype(bits_of(x))(0x5f370000) - shift_right<1>(bits_of(x)));
  const F z = (x * y) * y;
  const F low = F(2.193306915f) - F(2.203702664f) * z, high = F(1.327473709f) - F(0.3170786639f) * z;
  return y * (low + (z * z) * high);
}

/// log2(x): exponent, and an odd series of (m - 1) / (m + 1) for the mantissa m in [sqrt(1/2), sqrt(2)).
///
/// Max error: 1e-7 absolute plus 1 ulp. Valid range: positive normal floats.
template <class F>
BLYSK_INLINE F log2_poly(F x) {
  using I = decltype(bits_of(x));
  const I bits = bits_of(x) - I(0x3f3504f3);
  const I exponent = shift_right<23>(bits);
  const F m = float_of_bits(bits_of(x) - shift_left<23>(exponent));
  const F t = (m - F(1.0f)) / (m + F(1.0f));
  const F q = t * t;
  F p = F(0.4121985972f) * q + F(0.5770780169f);
  p = p * q + F(0.9617966939f);
  p = p * q + F(2.885390082f);
  return to_float(exponent) + p * t;
}

/// 2^x by the integer part in the exponent and a polynomial for the rest.
///
/// Max error: 2.5e-7 relative. Valid range: [-126, 127]; below it 2^-126.
template <class F>
BLYSK_INLINE F exp2_poly(F x) {
  using I = decltype(bits_of(x));
  const F clamped = max(x, F(-126.0f));
  const I whole = truncate(clamped + F(127.5f)) - I(127);  // nearest, as clamped + 127.5 > 0
  const F f = clamped - to_float(whole);                   // [-0.5, 0.5]
  F p = F(1.5403530e-4f) * f + F(1.3333558e-3f);
  p = p * f + F(9.6181291e-3f);
  p = p * f + F(5.5504109e-2f);
  p = p * f + F(2.4022651e-1f);
  p = p * f + F(6.9314718e-1f);
  p = p * f + F(1.0f);
  return float_of_bits(bits_of(p) + shift_left<23>(whole));
}

/// x^n for x in (0, 1], n > 0.  Max error: 2.4e-7 * (1 + n * |log2 x|) relative.
template <class F>
BLYSK_INLINE F power_poly(F x, float n) {
  return exp2_poly(log2_poly(x) * F(n));
}

}  // namespace blysk::BLYSK_ISA
