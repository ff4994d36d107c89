// shading/normals_reference.h - the relief thesis' ways to interpolated normals, as the specification writes
// them. What the kernels are measured against. The number type is double unless operations are counted.
#pragma once

#include <algorithm>
#include <cmath>

#include "blysk/vector.h"
#include "math/inverse_length.h"

namespace blysk::reference {

/// Steps of a vector that is linear on the screen, and its value at corner 0 (specification 2.1).
template <class T>
struct LinearNormalsOf {
  T x, y;  ///< of corner 0, pixels
  Vec3<T> at_corner;
  Vec3<T> horizontal, vertical;  ///< from a pixel to the next
  [[nodiscard]] Vec3<T> at(T px, T py) const {
    return at_corner + horizontal * (px - x) + vertical * (py - y);
  }
};
using LinearNormals = LinearNormalsOf<double>;

template <class T = double>
LinearNormalsOf<T> linear_normals(const Vec2<T> (&corner)[3], const Vec3<T> (&normal)[3]) {
  const T x21 = corner[1].x - corner[0].x, y21 = corner[1].y - corner[0].y;
  const T x31 = corner[2].x - corner[0].x, y31 = corner[2].y - corner[0].y;
  const T inverse_area = 1 / (x21 * y31 - x31 * y21);
  const Vec3<T> n21 = normal[1] - normal[0], n31 = normal[2] - normal[0];
  return {corner[0].x, corner[0].y, normal[0], (n21 * y31 - n31 * y21) * inverse_area,
          (n31 * x21 - n21 * x31) * inverse_area};
}

/// Squared length along a row by additions alone (specification 2.3). The paper starts beta at 1; -beta is
/// meant.
template <class T>
class SquaredLengthsOf {
 public:
  SquaredLengthsOf(const Vec3<T>& first, const Vec3<T>& step) : k_(dot(first, first)) {
    const T beta = dot(step, step);
    difference_ = 2 * dot(first, step) + beta;
    twice_beta_ = 2 * beta;
  }
  [[nodiscard]] T value() const { return k_; }
  void next() {
    k_ += difference_;
    difference_ += twice_beta_;
  }

 private:
  T k_, difference_, twice_beta_;
};
using SquaredLengths = SquaredLengthsOf<double>;

template <class T = double>
T inverse_length(const InverseLength& polynomial, T k) {
  const T t = k - T(polynomial.origin);
  const auto c = [&](int i) { return T(polynomial.c[i]); };
  T p = c(2);
  if (polynomial.c[3] != 0) p = p + t * c(3);
  return c(0) + t * (c(1) + t * p);
}

/// Outside the polynomial's range by the exact root.
template <class T = double>
Vec3<T> normalize_fast(const InverseLength& polynomial, const Vec3<T>& n) {
  using std::sqrt;
  const T k = dot(n, n);
  if (k < T(polynomial.lowest) || k > T(kLargestSquare)) return n * (1 / sqrt(k));
  return n * inverse_length(polynomial, k);
}

/// Four times the vector in the middle of an edge: M of specification 2.4.
template <class T = double>
Vec3<T> mid_vector(const MidVector& polynomial, const Vec3<T>& a, const Vec3<T>& b) {
  const T c = dot(a, b);
  const double* q = polynomial.q;
  return (a + b) * (4 * (T(q[0]) + c * (T(q[1]) + c * T(q[2]))));
}

/// The quadratic form of six vectors (specification 2.4): what a triangle prepares, and its value.
template <class T>
struct SixVectorsOf {
  Vec3<T> n1, n2, n3, m12, m23, m13;

  SixVectorsOf(const MidVector& polynomial, const Vec3<T> (&normal)[3])
      : n1(normal[0]),
        n2(normal[1]),
        n3(normal[2]),
        m12(mid_vector(polynomial, n1, n2)),
        m23(mid_vector(polynomial, n2, n3)),
        m13(mid_vector(polynomial, n1, n3)) {}

  /// At barycentric (c1, c2, 1 - c1 - c2).
  [[nodiscard]] Vec3<T> at(T c1, T c2) const {
    const T c3 = 1 - c1 - c2;
    return n1 * (c1 * (2 * c1 - 1)) + n2 * (c2 * (2 * c2 - 1)) + n3 * (c3 * (2 * c3 - 1)) + m12 * (c1 * c2) +
           m23 * (c2 * c3) + m13 * (c1 * c3);
  }
};

/// The normal at barycentric (c1, c2, 1 - c1 - c2) of unit corner normals (specification 2.4). Where two of
/// them are further apart than the polynomial reaches, linear and made unit by the exact root.
inline Vec3d six_point_normal(const MidVector& polynomial, const Vec3d (&normal)[3], double c1, double c2) {
  const auto& [n1, n2, n3] = normal;
  if (std::min({dot(n1, n2), dot(n2, n3), dot(n1, n3)}) < polynomial.lowest) {
    const Vec3d n = n1 * c1 + n2 * c2 + n3 * (1 - c1 - c2);
    return n * (1 / length(n));
  }
  return SixVectorsOf<double>(polynomial, normal).at(c1, c2);
}

}  // namespace blysk::reference
