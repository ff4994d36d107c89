#include "shading/row_normals_reference.h"

#include <algorithm>
#include <cmath>

#include "shading/normals_reference.h"

namespace blysk::reference {

double chebyshev_u(int k, double c) {
  double before = 0, u = 1;
  for (int i = 0; i < k; ++i) {
    const double next = 2 * c * u - before;
    before = u;
    u = next;
  }
  return u;
}

double exact_step_cosine(double d) {
  double c = d;
  for (int i = 0; i < 3; ++i) c = std::sqrt((1 + c) / 2);
  return c;
}

double exact_step_weight(double c) { return 1 / chebyshev_u(7, c); }

double row_weight(const RowWeights& weights, int k, double d) {
  if (k == 0 || k == 8) return k / 8.0;
  const auto& q = weights[k - 1];
  return k / 8.0 + (1 - d) * (q[0] + d * (q[1] + d * (q[2] + d * q[3])));
}

Row9 weighted_row(const RowWeights& weights, Vec3d a, Vec3d b) {
  const double d = dot(a, b);
  Row9 row;
  for (int k = 0; k <= 8; ++k) {
    row[static_cast<std::size_t>(k)] = a * row_weight(weights, 8 - k, d) + b * row_weight(weights, k, d);
  }
  return row;
}

double series_weight(double u, double d, int terms, double mu) {
  double nested = mu;
  for (int i = terms; i >= 1; --i) {
    nested *= (u * u - i * i) / (i * (2 * i + 1)) * (d - 1);
    if (i > 1) nested += 1;
  }
  return u * (1 + nested);
}

Vec3d slerp(Vec3d a, Vec3d b, double u) {
  const double angle = std::acos(std::clamp(dot(a, b), -1.0, 1.0));
  if (angle < 1e-6) return a * (1 - u) + b * u;
  return a * (std::sin((1 - u) * angle) / std::sin(angle)) + b * (std::sin(u * angle) / std::sin(angle));
}

Vec3d between(Between form, Vec3d a, Vec3d b) {
  const double c = dot(a, b);
  if (form == Between::half_sum && c >= kLowestHalfSum) return (a + b) * 0.5;
  if (form == Between::paper && c >= kMidVectorPaper.lowest) return mid_vector(kMidVectorPaper, a, b) * 0.25;
  if (form == Between::minimax && c >= kMidVectorMinimax.lowest) {
    return mid_vector(kMidVectorMinimax, a, b) * 0.25;
  }
  return (a + b) * (1 / std::sqrt(2 + 2 * c));
}

}  // namespace blysk::reference
