#include "shading/normals_reference.h"

#include <algorithm>
#include <cmath>

namespace blysk::reference {

Vec3d LinearNormals::at(double px, double py) const {
  return at_corner + horizontal * (px - x) + vertical * (py - y);
}

LinearNormals linear_normals(const Vec2<double> (&corner)[3], const Vec3d (&normal)[3]) {
  const double x21 = corner[1].x - corner[0].x, y21 = corner[1].y - corner[0].y;
  const double x31 = corner[2].x - corner[0].x, y31 = corner[2].y - corner[0].y;
  const double area = x21 * y31 - x31 * y21;
  const Vec3d n21 = normal[1] - normal[0], n31 = normal[2] - normal[0];
  return {corner[0].x, corner[0].y, normal[0], (n21 * y31 - n31 * y21) * (1 / area),
          (n31 * x21 - n21 * x31) * (1 / area)};
}

SquaredLengths::SquaredLengths(Vec3d first, Vec3d step)
    : k_(dot(first, first)),
      difference_(2 * dot(first, step) + dot(step, step)),
      twice_beta_(2 * dot(step, step)) {}

void SquaredLengths::next() {
  k_ += difference_;
  difference_ += twice_beta_;
}

double inverse_length(const InverseLength& polynomial, double k) {
  const double t = k - polynomial.origin;
  const double* c = polynomial.c;
  return c[0] + t * (c[1] + t * (c[2] + t * c[3]));
}

Vec3d normalize_fast(const InverseLength& polynomial, Vec3d n) {
  const double k = dot(n, n);
  if (k < polynomial.lowest || k > kLargestSquare) return n * (1 / std::sqrt(k));
  return n * inverse_length(polynomial, k);
}

Vec3d mid_vector(const MidVector& polynomial, Vec3d a, Vec3d b) {
  const double c = dot(a, b);
  const double* q = polynomial.q;
  return (a + b) * (4 * (q[0] + c * (q[1] + c * q[2])));
}

Vec3d six_point_normal(const MidVector& polynomial, const Vec3d (&normal)[3], double c1, double c2) {
  const auto& [n1, n2, n3] = normal;
  const double c3 = 1 - c1 - c2;
  if (std::min({dot(n1, n2), dot(n2, n3), dot(n1, n3)}) < polynomial.lowest) {
    const Vec3d n = n1 * c1 + n2 * c2 + n3 * c3;
    return n * (1 / length(n));
  }
  return n1 * (c1 * (2 * c1 - 1)) + n2 * (c2 * (2 * c2 - 1)) + n3 * (c3 * (2 * c3 - 1)) +
         mid_vector(polynomial, n1, n2) * (c1 * c2) + mid_vector(polynomial, n2, n3) * (c2 * c3) +
         mid_vector(polynomial, n1, n3) * (c1 * c3);
}

}  // namespace blysk::reference
