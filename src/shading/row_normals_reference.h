// shading/row_normals_reference.h - unit vectors between two, of rows and of triangles, as the per-fragment
// paper's and the relief thesis' specifications write them, in double precision. Sections are those of the
// A-buffer specification, part C, unless said otherwise.
#pragma once

#include <array>
#include <vector>

#include "blysk/vector.h"
#include "math/row_normals.h"

namespace blysk::reference {

/// Chebyshev polynomial of the second kind.
double chebyshev_u(int k, double c);

/// cos and the weight of (10) by exact roots, (13), and by the fits of a row.
double exact_step_cosine(double d);
double exact_step_weight(double c);
double step_cosine(const ChebyshevRow& row, double d);
double step_weight(const ChebyshevRow& row, double c);

/// A row of nine from unit ends. Chebyshev: (4) - (10); weights: C.4; halved: C.5.
using Row9 = std::array<Vec3d, 9>;
Row9 chebyshev_row(Vec3d a, Vec3d b, double c, double g);
Row9 chebyshev_row(const ChebyshevRow& row, Vec3d a, Vec3d b);
double row_weight(const RowWeights& weights, int k, double d);
Row9 weighted_row(const RowWeights& weights, Vec3d a, Vec3d b);

/// Halves until every point is found; `points` is 2^k + 1.
std::vector<Vec3d> halved_row(Vec3d a, Vec3d b, int points);

/// sin(u phi) / sin(phi) by `terms` terms of the series, the last one times mu (C.4).
double series_weight(double u, double d, int terms, double mu);

/// At u = 0..1 of the way from a to b.
Vec3d slerp(Vec3d a, Vec3d b, double u);
/// By kArcFit; arcs of more than 90 degrees halved first. d of a and b not under kLowestArc.
Vec3d arc(Vec3d a, Vec3d b, double u);

/// The vector between two neighbours (specification of relief and texturing, 2.6). Too far apart for the
/// form: the exact one.
enum class Between { exact, paper, minimax, half_sum };
Vec3d between(Between form, Vec3d a, Vec3d b);

/// A row of nine from its ends, whatever makes it.
using RowMaker = Row9 (*)(Vec3d a, Vec3d b);
/// 9 x 9 normals of a square from its corners (C.6): [column][row].
using Matrix9 = std::array<Row9, 9>;
Matrix9 matrix_block(RowMaker make, Vec3d n00, Vec3d n80, Vec3d n08, Vec3d n88);

/// Normals of the half square i + j <= 16 between corners at (0, 0), (16, 0) and (0, 16) from three matrix
/// blocks; v1 and v2 are the corners outside it.
struct TriangleBlock {
  std::array<std::array<Vec3d, 17>, 17> node;
  Vec3d v1, v2;
};
TriangleBlock triangle_block(RowMaker make, Vec3d a, Vec3d b, Vec3d c);

/// The same with exact edges: each row runs from edge ac to edge bc. size: 16, 8, 4, 2 or 1 steps an edge.
Vec3d triangle_node(Vec3d a, Vec3d b, Vec3d c, int size, int i, int j);

}  // namespace blysk::reference
