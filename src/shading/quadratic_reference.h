// shading/quadratic_reference.h - the second-order surface as the thesis writes it, in double precision.
//
// Specification of the shading thesis, sections 4.2 and 4.3.
#pragma once

#include "blysk/vector.h"

namespace blysk::reference {

/// At corners 1, 2, 3 and in the middle of the edges between them.
struct SixSamples {
  double i1, i2, i3, i12, i13, i23;
};

/// A x^2 + B y^2 + C x y + D x + E y + F, corner 1 at the origin.
struct SecondOrderSurface {
  double a, b, c, d, e, f;

  /// Formula (2.9).
  [[nodiscard]] double at(double x, double y) const { return x * (a * x + c * y + d) + y * (b * y + e) + f; }
  /// To the next pixel on the right, formula (2.3).
  [[nodiscard]] double difference(double x, double y) const { return 2 * a * x + a + c * y + d; }
};

/// Through six samples; corners 2 and 3 relative to corner 1. The area must not be zero.
inline SecondOrderSurface second_order_surface(Vec2<double> p2, Vec2<double> p3, const SixSamples& i) {
  const double a = -3 * i.i1 - i.i2 + 4 * i.i12, c = 2 * i.i1 + 2 * i.i2 - 4 * i.i12;
  const double b = -3 * i.i1 - i.i3 + 4 * i.i13, d = 2 * i.i1 + 2 * i.i3 - 4 * i.i13;
  const double e = 4 * (i.i1 + i.i23 - i.i12 - i.i13);
  const double area = p2.x * p3.y - p3.x * p2.y, square = area * area;
  return {(c * p3.y * p3.y - e * p2.y * p3.y + d * p2.y * p2.y) / square,
          (c * p3.x * p3.x - e * p2.x * p3.x + d * p2.x * p2.x) / square,
          (-2 * c * p3.x * p3.y + e * (p2.x * p3.y + p3.x * p2.y) - 2 * d * p2.x * p2.y) / square,
          (a * p3.y - b * p2.y) / area,
          (-a * p3.x + b * p2.x) / area,
          i.i1};
}

}  // namespace blysk::reference
