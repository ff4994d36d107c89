// shading/row_normals_reference.h - unit vectors between two, of rows and of triangles, as the per-fragment
// paper's and the relief thesis' specifications write them, in double precision unless operations are
// counted. Sections are those of the A-buffer specification, part C, unless said otherwise.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "blysk/vector.h"
#include "math/row_normals.h"

namespace blysk::reference {

/// Chebyshev polynomial of the second kind.
double chebyshev_u(int k, double c);

/// cos and the weight of (10) by exact roots, (13), and by the fits of a row.
double exact_step_cosine(double d);
double exact_step_weight(double c);

template <class T = double>
T step_cosine(const ChebyshevRow& row, T d) {
  const T p = T(row.c[0]) + d * (T(row.c[1]) + d * T(row.c[2]));
  return row.from_one ? 1 - (1 - d) * p : p;
}

template <class T = double>
T step_weight(const ChebyshevRow& row, T c) {
  const T e = row.from_one ? 1 - c : c;
  T p = T(row.g[2]);
  if (row.g[3] != 0) p = p + e * T(row.g[3]);
  return T(row.g[0]) + e * (T(row.g[1]) + e * p);
}

template <class T>
using Row9Of = std::array<Vec3<T>, 9>;
using Row9 = Row9Of<double>;

/// A row of nine from unit ends by Chebyshev polynomials, (4) - (10).
template <class T = double>
Row9Of<T> chebyshev_row(const Vec3<T>& a, const Vec3<T>& b, T d, T c, T g) {
  Row9Of<T> row;
  row[0] = a;
  row[1] = a * c + (b - a * d) * g;
  const T twice = 2 * c;
  T before = T(1), u = twice;  // U_(t - 3), U_(t - 2) of point t
  for (std::size_t t = 3; t <= 8; ++t) {
    row[t - 1] = row[1] * u - a * before;
    if (t == 8) break;
    const T next = twice * u - before;
    before = u;
    u = next;
  }
  row[8] = b;
  return row;
}
template <class T = double>
Row9Of<T> chebyshev_row(const ChebyshevRow& row, const Vec3<T>& a, const Vec3<T>& b) {
  const T d = dot(a, b), c = step_cosine(row, d);
  return chebyshev_row(a, b, d, c, step_weight(row, c));
}

/// The same by weights, C.4.
double row_weight(const RowWeights& weights, int k, double d);
Row9 weighted_row(const RowWeights& weights, Vec3d a, Vec3d b);

/// Halves until every point is found, C.5; `points` is 2^k + 1.
template <class T = double>
std::vector<Vec3<T>> halved_row(const Vec3<T>& a, const Vec3<T>& b, int points) {
  using std::sqrt;
  const auto last = static_cast<std::size_t>(points - 1);
  std::vector<Vec3<T>> row(last + 1);
  row[0] = a;
  row[last] = b;
  T h = dot(a, b);
  for (std::size_t step = last / 2; step > 0; step /= 2) {
    h = sqrt((1 + h) / 2);
    const T scale = 1 / (2 * h);
    for (std::size_t i = step; i < last; i += 2 * step) row[i] = (row[i - step] + row[i + step]) * scale;
  }
  return row;
}

/// sin(u phi) / sin(phi) by `terms` terms of the series, the last one times mu (C.4).
double series_weight(double u, double d, int terms, double mu);

/// At u = 0..1 of the way from a to b.
Vec3d slerp(Vec3d a, Vec3d b, double u);

/// By kArcFit, arcs of up to 90 degrees: what a row prepares, and its value at t = -1..1.
template <class T>
struct ArcOf {
  Vec3<T> sum, difference;
  T even[2], odd[2];

  ArcOf(const Vec3<T>& a, const Vec3<T>& b) : sum(b + a), difference(b - a) {
    const auto e = [](int i) { return T(kArcFit.even[i]); };
    const auto o = [](int i) { return T(kArcFit.odd[i]); };
    const T z = std::max((1 - dot(a, b)) / 2, T(0)), square = z * z;
    even[0] = z * (e(0) + z * (e(1) + z * (e(2) + z * e(3))));
    even[1] = square * (e(4) + z * e(5));
    odd[0] = z * (o(0) + z * (o(1) + z * o(2)));
    odd[1] = square * o(3);
  }
  [[nodiscard]] Vec3<T> at(T t) const {
    const T e = 1 - t * t;
    return sum * (T(0.5) + e * (even[0] + e * even[1])) +
           difference * (t * (T(0.5) + e * (odd[0] + e * odd[1])));
  }
};

/// The same at u = 0..1; arcs of more than 90 degrees halved first. d of a and b not under kLowestArc.
template <class T = double>
Vec3<T> arc(const Vec3<T>& a, const Vec3<T>& b, T u) {
  using std::sqrt;
  const T d = dot(a, b);
  if (d < T(0)) {
    const Vec3<T> middle = (a + b) * (1 / sqrt(2 + 2 * d));
    return u < T(0.5) ? arc(a, middle, 2 * u) : arc(middle, b, 2 * u - 1);
  }
  return ArcOf<T>(a, b).at(2 * u - 1);
}

/// The vector between two neighbours (specification of relief and texturing, 2.6). Too far apart for the
/// form: the exact one.
enum class Between { exact, paper, minimax, half_sum };
Vec3d between(Between form, Vec3d a, Vec3d b);

/// 9 x 9 normals of a square from its corners (C.6): [column][row]. `make` gives a row of nine from its ends.
template <class T>
using Matrix9Of = std::array<Row9Of<T>, 9>;
using Matrix9 = Matrix9Of<double>;
template <class Make, class T = double>
Matrix9Of<T> matrix_block(Make make, const Vec3<T>& n00, const Vec3<T>& n80, const Vec3<T>& n08,
                          const Vec3<T>& n88) {
  const Row9Of<T> left = make(n00, n08), right = make(n80, n88);
  Matrix9Of<T> m;
  for (std::size_t j = 0; j < 9; ++j) {
    const Row9Of<T> row = make(left[j], right[j]);
    for (std::size_t i = 0; i < 9; ++i) m[i][j] = row[i];
  }
  return m;
}

/// Normals of the half square i + j <= 16 between corners at (0, 0), (16, 0) and (0, 16) from three matrix
/// blocks; v1 and v2 are the corners outside it.
template <class T>
struct TriangleBlockOf {
  std::array<std::array<Vec3<T>, 17>, 17> node;
  Vec3<T> v1, v2;
};
using TriangleBlock = TriangleBlockOf<double>;
template <class Make, class T = double>
TriangleBlockOf<T> triangle_block(Make make, const Vec3<T>& a, const Vec3<T>& b, const Vec3<T>& c) {
  const Vec3<T> ab = normalize(a + b), ac = normalize(a + c), bc = normalize(b + c);
  TriangleBlockOf<T> t;
  t.v1 = normalize(b + bc - ab);
  t.v2 = normalize(c + bc - ac);
  const Matrix9Of<T> q00 = matrix_block(make, a, ab, ac, bc), q10 = matrix_block(make, ab, b, bc, t.v1),
                     q01 = matrix_block(make, ac, bc, c, t.v2);
  for (std::size_t i = 0; i < 17; ++i) {
    for (std::size_t j = 0; i + j < 17; ++j) {
      t.node[i][j] = i > 8 ? q10[i - 8][j] : j > 8 ? q01[i][j - 8] : q00[i][j];
    }
  }
  return t;
}

/// The same of 16, 8, 4, 2 or 1 steps an edge with exact edges, alike in both triangles of an edge: each row
/// runs from edge ac to edge bc. At (i, j): i steps towards b, j towards c.
template <class T>
class TriangleNodesOf {
 public:
  TriangleNodesOf(const Vec3<T>& a, const Vec3<T>& b, const Vec3<T>& c, int steps) : steps_(steps) {
    const auto ab = halved_row(a, b, steps + 1), ac = halved_row(a, c, steps + 1),
               bc = halved_row(b, c, steps + 1);
    nodes_.resize(static_cast<std::size_t>((steps + 1) * (steps + 1)));
    for (int j = 0; j <= steps; ++j) {
      const Vec3<T>& left = ac[static_cast<std::size_t>(j)];
      const Vec3<T>& right = bc[static_cast<std::size_t>(j)];
      for (int i = 1; i + j < steps; ++i) {
        node(i, j) = j == 0 ? ab[static_cast<std::size_t>(i)]
                            : arc(left, right, T(static_cast<double>(i) / (steps - j)));
      }
      node(0, j) = left;
      node(steps - j, j) = j == steps ? left : right;
    }
  }
  [[nodiscard]] const Vec3<T>& at(int i, int j) const {
    return nodes_[static_cast<std::size_t>(j * (steps_ + 1) + i)];
  }

 private:
  Vec3<T>& node(int i, int j) { return nodes_[static_cast<std::size_t>(j * (steps_ + 1) + i)]; }

  int steps_;
  std::vector<Vec3<T>> nodes_;
};
using TriangleNodes = TriangleNodesOf<double>;

}  // namespace blysk::reference
