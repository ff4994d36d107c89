// shading/angular_reference.h - angular interpolation of normals as the thesis writes it, in double
// precision.
//
// Specification of the shading thesis, sections 7 and 8.1.
#pragma once

#include <cmath>

#include "blysk/vector.h"

namespace blysk::reference {

/// A row of m steps between unit normals, and a unit vector h.
struct AngularRow {
  double m, phi, cos_phi;
  double cos_a, cos_l;   ///< h with the ends
  double s;              ///< cos(beta) sin(psi)
  double cos_beta, psi;  ///< h with the plane of the arc; from the first end to the foot of h, signed

  AngularRow(Vec3d na, Vec3d nb, Vec3d h, double steps)
      : AngularRow(dot(na, nb), dot(na, h), dot(nb, h), steps) {}
  /// From the three cosines alone, as per-triangle quantities give them.
  AngularRow(double cos_ab, double cos_ah, double cos_bh, double steps)
      : m(steps),
        phi(std::acos(cos_ab)),
        cos_phi(cos_ab),
        cos_a(cos_ah),
        cos_l(cos_bh),
        s((cos_bh - cos_ah * cos_ab) / std::sqrt(1 - cos_ab * cos_ab)),
        cos_beta(std::hypot(cos_ah, s)),
        psi(std::atan2(s, cos_ah)) {}

  [[nodiscard]] double step() const { return phi / m; }
  /// Pixels from the first end to the foot of h.
  [[nodiscard]] double foot() const { return psi / step(); }

  /// Formula (3.4).
  [[nodiscard]] double printed(double t) const { return cos_beta * std::cos(psi - t * step()); }
  /// Without inverse functions but phi.
  [[nodiscard]] double expanded(double t) const {
    return cos_a * std::cos(t * step()) + s * std::sin(t * step());
  }
  /// About the middle of the row: pixel m - t has the other sign of the sine.
  [[nodiscard]] double pair(double t) const {
    const double u = (m / 2 - t) * step();
    const double c = (cos_a + cos_l) / (2 * std::cos(phi / 2)), d = (cos_l - cos_a) / (2 * std::sin(phi / 2));
    return c * std::cos(u) - d * std::sin(u);
  }
  /// The walk from the foot of h: both sides share their cosines, so that the foot must be a pixel (erratum
  /// E32). Where it is not on the arc there is no walk.
  [[nodiscard]] double walked(double t) const {
    const double from = foot() < 0 || foot() > m ? foot() : std::round(foot());
    return cos_beta * std::cos((t - from) * step());
  }
};

/// Rows of a triangle by spherical trigonometry: A runs from C to D, B from C to F; no vector after set-up.
struct SphericalTriangle {
  double angle_d, angle_f;  ///< of the edges
  double cos_o;             ///< between their planes at C
  double h_c;               ///< H.N_C
  double h_d, h_f;          ///< |H x N_C| times the cosines O1 and O2

  SphericalTriangle(Vec3d c, Vec3d d, Vec3d f, Vec3d h)
      : angle_d(std::acos(dot(c, d))), angle_f(std::acos(dot(c, f))), h_c(dot(h, c)) {
    const Vec3d n_d = normalize(cross(c, d)), n_f = normalize(cross(c, f)), across = cross(c, h);
    cos_o = dot(n_d, n_f);
    h_d = dot(n_d, across);
    h_f = dot(n_f, across);
  }

  [[nodiscard]] double cos_phi(double tau, double mu) const {
    return std::cos(tau) * std::cos(mu) + std::sin(tau) * std::sin(mu) * cos_o;
  }
  [[nodiscard]] double cos_alpha(double tau) const { return std::cos(tau) * h_c + std::sin(tau) * h_d; }
  [[nodiscard]] double cos_lambda(double mu) const { return std::cos(mu) * h_c + std::sin(mu) * h_f; }
};

/// Section 8.1. The first two are the thesis' own kind, which fail for small angles (erratum E40).
inline double arccos_taylor(double x) { return 1.57079632679489662 - x - x * x * x / 6; }
inline double arccos_parabola(double x) { return 1.55877507 - 0.82656305 * x - 0.38921692 * x * x; }
inline double arccos_root1(double x) { return std::sqrt(1 - x) * (1.564665081 - 0.155971579 * x); }
inline double arccos_root2(double x) {
  return std::sqrt(1 - x) * (1.570181939 - 0.201876838 * x + 0.046461605 * x * x);
}
inline double arccos_root3(double x) {
  return std::sqrt(1 - x) * (1.570725429 - 0.212052546 * x + 0.074093317 * x * x - 0.018616468 * x * x * x);
}
/// Of z = 2 - 2 cos: no digits are lost for small angles.
inline double angle_of_chord(double z) {
  return std::sqrt(z) * (0.999954859 + 0.042325762 * z + 0.003225090 * z * z + 0.001645482 * z * z * z);
}
inline double angle_of_chord2(double z) {
  return std::sqrt(z) * (1.000391126 + 0.038520952 * z + 0.008213319 * z * z);
}

}  // namespace blysk::reference
