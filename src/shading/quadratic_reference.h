// shading/quadratic_reference.h - the second-order surface as the thesis writes it, in double precision.
//
// Specification of the shading thesis, sections 4.2 and 4.3.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <type_traits>
#include <vector>

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
  /// Formula (2.2).
  [[nodiscard]] T directly_at(T x, T y) const {
    return a * x * x + b * y * y + c * x * y + d * x + e * y + f;
  }
  /// To the next pixel on the right, formula (2.3).
  [[nodiscard]] T difference(T x, T y) const { return 2 * a * x + a + c * y + d; }
  /// From the end of a segment of 2^k pixels to the next, section 4.4.
  [[nodiscard]] T segment_difference(T x, T y, int k) const {
    const T length = T(1 << k);
    return 2 * length * a * x + length * length * a + length * c * y + length * d;
  }
};
using SecondOrderSurface = SecondOrderSurfaceOf<double>;

/// The column to the right. A program knows which pixel it is at: numbers that count operations do not count
/// this.
inline double next_pixel(double x) { return x + 1; }
inline float next_pixel(float x) { return x + 1; }

enum class QuadraticForm { direct, horner, step, pair, triple, values, values_shift, forward };

/// Formula number as the thesis prints it.
inline std::string_view formula_of(QuadraticForm form) {
  constexpr std::string_view kFormulas[] = {"(2.2)", "(2.9)", "(2.3)",           "(2.5)",
                                            "(2.7)", "(2.8)", "(2.8) optimised", "forward differences"};
  return kFormulas[static_cast<int>(form)];
}

/// Pixels x, x + 1, ... of row y; at least four. C y is kept from the first of them; 2 A and 4 A are found
/// anew at every pixel, as the thesis counts, but for forward differences.
template <class T>
void quadratic_row(QuadraticForm form, const SecondOrderSurfaceOf<T>& s, T x, T y, std::span<T> out) {
  if (form == QuadraticForm::direct || form == QuadraticForm::horner) {
    for (T& i : out) {
      i = form == QuadraticForm::horner ? s.at(x, y) : s.directly_at(x, y);
      x = next_pixel(x);
    }
    return;
  }
  const T cy = s.c * y;
  out[0] = x * (s.a * x + cy + s.d) + y * (s.b * y + s.e) + s.f;
  if (form == QuadraticForm::forward) {
    T difference = 2 * s.a * x + s.a + cy + s.d;
    const T bend = 2 * s.a;
    for (std::size_t k = 1; k < out.size(); ++k) {
      out[k] = out[k - 1] + difference;
      difference = difference + bend;
    }
    return;
  }
  for (std::size_t k = 1; k < out.size(); ++k) {
    const T a = out[k - 1];
    if (form == QuadraticForm::step || k == 1) {
      out[k] = a + (2 * s.a * x + s.a + cy + s.d);
      x = next_pixel(x);
      continue;
    }
    const T b = out[k - 2];
    if (form == QuadraticForm::pair || k == 2) {
      out[k] = 2 * a - b + 2 * s.a;
      continue;
    }
    const T c = out[k - 3];
    if (form == QuadraticForm::triple) out[k] = a + b - c + 4 * s.a;
    if (form == QuadraticForm::values) out[k] = T(3) * a - T(3) * b + c;
    if (form == QuadraticForm::values_shift) out[k] = 2 * a + a - 2 * b - b + c;
  }
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
