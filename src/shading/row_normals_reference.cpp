#include "shading/row_normals_reference.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

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

double step_cosine(const ChebyshevRow& row, double d) {
  const double p = row.c[0] + d * (row.c[1] + d * row.c[2]);
  return row.from_one ? 1 - (1 - d) * p : p;
}

double step_weight(const ChebyshevRow& row, double c) {
  const double e = row.from_one ? 1 - c : c;
  return row.g[0] + e * (row.g[1] + e * (row.g[2] + e * row.g[3]));
}

Row9 chebyshev_row(Vec3d a, Vec3d b, double c, double g) {
  Row9 row;
  row[0] = a;
  row[1] = a * c + (b - a * dot(a, b)) * g;
  for (int t = 3; t <= 8; ++t) {
    row[static_cast<std::size_t>(t - 1)] = row[1] * chebyshev_u(t - 2, c) - a * chebyshev_u(t - 3, c);
  }
  row[8] = b;
  return row;
}

Row9 chebyshev_row(const ChebyshevRow& row, Vec3d a, Vec3d b) {
  const double c = step_cosine(row, dot(a, b));
  return chebyshev_row(a, b, c, step_weight(row, c));
}

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

std::vector<Vec3d> halved_row(Vec3d a, Vec3d b, int points) {
  const auto last = static_cast<std::size_t>(points - 1);
  std::vector<Vec3d> row(last + 1);
  row[0] = a;
  row[last] = b;
  double h = dot(a, b);
  for (std::size_t step = last / 2; step > 0; step /= 2) {
    h = std::sqrt((1 + h) / 2);
    for (std::size_t i = step; i < last; i += 2 * step) {
      row[i] = (row[i - step] + row[i + step]) * (1 / (2 * h));
    }
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

Vec3d arc(Vec3d a, Vec3d b, double u) {
  const double d = dot(a, b);
  if (d < 0) {
    const Vec3d middle = (a + b) * (1 / std::sqrt(2 + 2 * d));
    return u < 0.5 ? arc(a, middle, 2 * u) : arc(middle, b, 2 * u - 1);
  }
  const double z = std::max((1 - d) / 2, 0.0), t = 2 * u - 1, e = 1 - t * t;
  const double* even = kArcFit.even;
  const double* odd = kArcFit.odd;
  const double e0 = z * (even[0] + z * (even[1] + z * (even[2] + z * even[3])));
  const double e1 = z * z * (even[4] + z * even[5]);
  const double o0 = z * (odd[0] + z * (odd[1] + z * odd[2])), o1 = z * z * odd[3];
  return (b + a) * (0.5 + e * (e0 + e * e1)) + (b - a) * (t * (0.5 + e * (o0 + e * o1)));
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

Matrix9 matrix_block(RowMaker make, Vec3d n00, Vec3d n80, Vec3d n08, Vec3d n88) {
  const Row9 left = make(n00, n08), right = make(n80, n88);
  Matrix9 m;
  for (std::size_t j = 0; j < 9; ++j) {
    const Row9 row = make(left[j], right[j]);
    for (std::size_t i = 0; i < 9; ++i) m[i][j] = row[i];
  }
  return m;
}

TriangleBlock triangle_block(RowMaker make, Vec3d a, Vec3d b, Vec3d c) {
  const Vec3d ab = normalize(a + b), ac = normalize(a + c), bc = normalize(b + c);
  TriangleBlock t;
  t.v1 = normalize(b + bc - ab);
  t.v2 = normalize(c + bc - ac);
  const Matrix9 q00 = matrix_block(make, a, ab, ac, bc), q10 = matrix_block(make, ab, b, bc, t.v1),
                q01 = matrix_block(make, ac, bc, c, t.v2);
  for (std::size_t i = 0; i < 17; ++i) {
    for (std::size_t j = 0; i + j < 17; ++j) {
      t.node[i][j] = i > 8 ? q10[i - 8][j] : j > 8 ? q01[i][j - 8] : q00[i][j];
    }
  }
  return t;
}

Vec3d triangle_node(Vec3d a, Vec3d b, Vec3d c, int size, int i, int j) {
  const auto on = [&](Vec3d from, Vec3d to, int k) {
    return halved_row(from, to, size + 1)[static_cast<std::size_t>(k)];
  };
  if (j == 0) return on(a, b, i);
  const Vec3d left = on(a, c, j), right = on(b, c, j);
  return j == size || i == 0 ? left : i + j == size ? right : arc(left, right, double(i) / (size - j));
}

}  // namespace blysk::reference
