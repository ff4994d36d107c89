// shading/quadratic_reference.h - the second-order surface as the thesis writes it, in double precision.
//
// Specification of the shading thesis, sections 4.2 and 4.3.
#pragma once

#include <cstddef>
#include <vector>

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
  /// Formula (2.2).
  [[nodiscard]] double directly_at(double x, double y) const {
    return a * x * x + b * y * y + c * x * y + d * x + e * y + f;
  }
  /// To the next pixel on the right, formula (2.3).
  [[nodiscard]] double difference(double x, double y) const { return 2 * a * x + a + c * y + d; }
  /// From the end of a segment of 2^k pixels to the next, section 4.4.
  [[nodiscard]] double segment_difference(double x, double y, int k) const {
    const double length = 1 << k;
    return 2 * length * a * x + length * length * a + length * c * y + length * d;
  }
};

/// (2.3), (2.5), (2.7), (2.8).
enum class Recurrence { step, pair, triple, values };

/// `count` pixels of row y from x on. The first three come from (2.9), (2.3) and (2.5).
inline std::vector<double> recurrent_row(const SecondOrderSurface& s, Recurrence by, double x, double y,
                                         std::size_t count) {
  std::vector<double> i = {s.at(x, y)};
  while (i.size() < count) {
    const std::size_t n = i.size();
    if (by == Recurrence::step || n == 1) {
      i.push_back(i[n - 1] + s.difference(x + static_cast<double>(n - 1), y));
    } else if (by == Recurrence::pair || n == 2) {
      i.push_back(2 * i[n - 1] - i[n - 2] + 2 * s.a);
    } else if (by == Recurrence::triple) {
      i.push_back(i[n - 1] + i[n - 2] - i[n - 3] + 4 * s.a);
    } else {
      i.push_back(3 * i[n - 1] - 3 * i[n - 2] + i[n - 3]);
    }
  }
  return i;
}

/// A row of `count` pixels in segments of 2^k; the last incomplete one is not straightened.
inline std::vector<double> segmented_row(const SecondOrderSurface& s, double x, double y, std::size_t count,
                                         int k) {
  const std::size_t length = std::size_t{1} << k;
  std::vector<double> i;
  double begin = s.at(x, y);
  std::size_t n = 0;
  for (; n + length < count; n += length) {
    const double rise = s.segment_difference(x + static_cast<double>(n), y, k);
    for (std::size_t q = 0; q < length; ++q) {
      i.push_back(begin + rise * static_cast<double>(q) / static_cast<double>(length));
    }
    begin += rise;
  }
  for (; n < count; ++n) i.push_back(s.at(x + static_cast<double>(n), y));
  return i;
}

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
