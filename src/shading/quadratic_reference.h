// shading/quadratic_reference.h - the second-order surface as the thesis writes it, in double precision.
//
// Specification of the shading thesis, sections 4.2 and 4.3.
#pragma once

#include <type_traits>

#include "blysk/vector.h"

namespace blysk::reference {

/// At corners 1, 2, 3 and in the middle of the edges between them.
template <class T>
struct SixSamplesOf {
  T i1, i2, i3, i12, i13, i23;
};
using SixSamples = SixSamplesOf<double>;

/// A x^2 + B y^2 + C x y + D x + E y + F, corner 1 at the origin.
template <class T>
struct SecondOrderSurfaceOf {
  T a, b, c, d, e, f;

  /// Formula (2.9).
  [[nodiscard]] T at(T x, T y) const { return x * (a * x + c * y + d) + y * (b * y + e) + f; }
  /// To the next pixel on the right, formula (2.3).
  [[nodiscard]] T difference(T x, T y) const { return 2 * a * x + a + c * y + d; }
};
using SecondOrderSurface = SecondOrderSurfaceOf<double>;

/// Through six samples; corners 2 and 3 relative to corner 1. The area must not be zero.
template <class T = double>
SecondOrderSurfaceOf<T> second_order_surface(std::type_identity_t<Vec2<T>> p2,
                                             std::type_identity_t<Vec2<T>> p3, const SixSamplesOf<T>& i) {
  const T a = -3 * i.i1 - i.i2 + 4 * i.i12, c = 2 * i.i1 + 2 * i.i2 - 4 * i.i12;
  const T b = -3 * i.i1 - i.i3 + 4 * i.i13, d = 2 * i.i1 + 2 * i.i3 - 4 * i.i13;
  const T e = 4 * (i.i1 + i.i23 - i.i12 - i.i13);
  const T area = p2.x * p3.y - p3.x * p2.y, square = area * area;
  return {(c * p3.y * p3.y - e * p2.y * p3.y + d * p2.y * p2.y) / square,
          (c * p3.x * p3.x - e * p2.x * p3.x + d * p2.x * p2.x) / square,
          (-2 * c * p3.x * p3.y + e * (p2.x * p3.y + p3.x * p2.y) - 2 * d * p2.x * p2.y) / square,
          (a * p3.y - b * p2.y) / area,
          (-a * p3.x + b * p2.x) / area,
          i.i1};
}

}  // namespace blysk::reference
