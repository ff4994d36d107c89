// shading/symmetric_reference.h - the accelerated cosines of a row as the thesis writes them, in double
// precision; the thesis' roots in other number types too, so that their operations can be counted.
//
// Specification of the shading thesis, sections 6.1 to 6.4.
#pragma once

#include <cmath>

#include "blysk/vector.h"

namespace blysk::reference {

/// 1 / sqrt(1 + m), m in [-0.5, 0].
template <class T>
T exact_root_of(const T& m) {
  using std::sqrt;
  return 1 / sqrt(1 + m);
}
template <class T>
T taylor_root_of(const T& m) {
  return 1 - m / 2 + T(0.375) * m * m;
}
template <class T>
T chebyshev_root_of(const T& m) {
  return T(1.003) - T(0.403) * m + T(0.82) * m * m;
}
/// Shifts alone beside one product: l = 1/4 + 1/8 + 1/32.
template <class T>
T shift_root_of(const T& m) {
  const T z = m * (2 * m - 1);
  return 1 + (z / 4 + z / 8 + z / 32);
}
inline double exact_root(double m) { return exact_root_of(m); }
inline double taylor_root(double m) { return taylor_root_of(m); }
inline double chebyshev_root(double m) { return chebyshev_root_of(m); }
inline double shift_root(double m) { return shift_root_of(m); }
inline double minimax_root(double m) { return 1.00318764536 - 0.395312238031 * m + 0.835447146791 * m * m; }
/// Exact on rows that do not turn.
inline double anchored_root(double m) { return 1 - 0.422544240097 * m + 0.79063195182 * m * m; }
inline double cubic_root(double m) {
  return 0.999520993786 - 0.528606396191 * m + 0.120511169763 * m * m - 0.956673287732 * m * m * m;
}
inline double newton_step(double r, double m) { return r * (1.5 - 0.5 * (1 + m) * r * r); }

/// Through the root at 0 and at two places of the range [lowest, 0]: what `minimax` does for each row.
inline double fitted_root(double m, double lowest) {
  const double m1 = (2 * std::sqrt(3.0) - 3) * lowest, m2 = 2 * m1;
  const double a = (exact_root(m1) - 1) / m1, b = (exact_root(m2) - 1) / m2;
  return 1 + m * (a + (m - m1) * (b - a) / (m2 - m1));
}

/// N.L along a row of m steps between unit normals.
struct SymmetricRow {
  double m, s, c;  ///< M(x) = c x^2 + s x
  double b, g, h;  ///< numerator g x + b, at the last pixel h

  SymmetricRow(Vec3d na, Vec3d nb, Vec3d l, double steps)
      : m(steps),
        s(-(2 - 2 * dot(na, nb)) / steps),
        c((2 - 2 * dot(na, nb)) / (steps * steps)),
        b(dot(na, l)),
        g((dot(nb, l) - dot(na, l)) / steps),
        h(dot(nb, l)) {}

  [[nodiscard]] double square(double x) const { return c * x * x + s * x; }
  [[nodiscard]] double numerator(double x) const { return g * x + b; }
  [[nodiscard]] double mirrored(double x) const { return h - g * x; }
  template <class Root>
  [[nodiscard]] double cosine(double x, Root root) const {
    return numerator(x) * root(square(x));
  }
};

}  // namespace blysk::reference
