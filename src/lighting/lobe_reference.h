// lighting/lobe_reference.h - the lobes as the specification writes them, in double precision.
//
// c is cos(gamma) in [0, 1], n the shininess. Relief thesis, section 4.2 of the specification (Schlick, W);
// shading thesis, section 8.2 (the others). The number type is double unless operations are counted.
#pragma once

#include <algorithm>

#include "lighting/lamp.h"

namespace blysk::reference {

/// b^k by squaring, k >= 1.
template <class T>
T integer_power(T b, int k) {
  while (k % 2 == 0) {
    b = b * b;
    k /= 2;
  }
  T r = b;
  while (k /= 2) {
    b = b * b;
    if (k % 2 == 1) r = r * b;
  }
  return r;
}

/// The same where k is known beforehand, so that no loop is left.
template <int k, class T>
T fixed_power(const T& b) {
  static_assert(k >= 1);
  if constexpr (k == 1) {
    return b;
  } else {
    const T half = fixed_power<k / 2>(b);
    return k % 2 == 0 ? half * half : half * half * b;
  }
}

/// c^n.
double power_lobe(double c, double n);
/// c / (n - n c + c).
template <class T = double>
T schlick_lobe(T c, double n) {
  return c / (T(n) - T(n) * c + c);
}

/// (n + 1) / (k + 1).
double w_scale(double n, int k);
/// The same by shifts alone, for k = 4, 8, 16; for k = 3, 7, 15 it is one shift.
double w_shift_scale(double n, int k);
/// W(n, gamma) = (scale (c - 1) + 1)^k, 0 where the base is negative.
template <class T = double>
T w_lobe(T c, double scale, int k) {
  return integer_power(std::max(T(0), T(scale) * (c - 1) + 1), k);
}

/// The same where k is known beforehand.
template <int k, class T>
T fixed_w_lobe(const T& c, double scale) {
  return fixed_power<k>(std::max(T(0), T(scale) * (c - 1) + 1));
}

/// 2^(n log2 c), both functions linear between powers of two: the hardware form without ROM.
double logarithmic_lobe(double c, double n);
/// (1 - s n gamma^2)^2, 0 where the base is negative; 0.178 has the least error.
double quadratic_lobe(double c, double n, double s = 0.178);
/// (1 - n (1 - c) / width)^2, 0 where the base is negative; 2 needs shifts only, 2.81 has the least error.
template <class T = double>
T cosine_squared_lobe(T c, double n, double width = 2.81) {
  return integer_power(std::max(T(0), 1 - T(n / width) * (1 - c)), 2);
}

/// The lobe that a name selects: 0 at c <= 0, and the exact power for n so small that the lobe would not
/// reach zero within 90 degrees.
double specular_lobe(Lobe lobe, double c, double n);

/// The exact lobe in other number types; whole n of at least 1 only.
template <class T>
T specular_lobe(Lobe, const T& c, double n) {
  return c > T(0) ? integer_power(c, static_cast<int>(n)) : T(0);
}

}  // namespace blysk::reference
