// The reference forms against the values of the specification (A-buffer specification, E-C and C.3, C.4).
#include "shading/row_normals_reference.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/random.h"
#include "shading/testing.h"

namespace blysk::reference {
namespace {

constexpr double kPi = 3.14159265358979323846;

// d, c, (14), g, (11) at the exact c, U_1 .. U_7.
struct StepRow {
  double d, c, printed_c, g, printed_g, u[7];
};
constexpr StepRow kSteps[] = {
    {1, 1, 0.9998, 0.125, 0.13, {2, 3, 4, 5, 6, 7, 8}},
    {0.9,
     0.998411161655,
     0.998298,
     0.129272300975,
     0.134018450680,
     {1.996822323, 2.987299391, 3.968283787, 4.936658260, 5.889345629, 6.823318562, 7.735609194}},
    {0.75,
     0.995921956064,
     0.9958875,
     0.136398218929,
     0.140947718977,
     {1.991843912, 2.967442170, 3.918837709, 4.838270864, 5.718242656, 6.551575958, 7.331474031}},
    {0.5,
     0.991444861374,
     0.99145,
     0.150718664429,
     0.155357531437,
     {1.982889723, 2.931851653, 3.830648788, 4.663902460, 5.417355468, 6.078116023, 6.634878326}},
    {0.25,
     0.986457007947,
     0.9864875,
     0.169399162443,
     0.174358087286,
     {1.972914016, 2.892389714, 3.733522191, 4.473528544, 5.092364975, 5.573269689, 5.903216908}},
    {0,
     0.980785280403,
     0.981,
     0.195090322016,
     0.199737572758,
     {1.961570561, 2.847759065, 3.624509785, 4.261972627, 4.735650251, 5.027339492, 5.125830895}}};

TEST(row_normals_reference, steps) {
  for (const StepRow& row : kSteps) {
    SCOPED_TRACE(row.d);
    const double c = exact_step_cosine(row.d);
    EXPECT_NEAR(c, row.c, 6e-13);
    EXPECT_NEAR(step_cosine(kChebyshevPaper, row.d), row.printed_c, 1e-12);
    EXPECT_NEAR(exact_step_weight(c), row.g, 6e-13);
    EXPECT_NEAR(step_weight(kChebyshevPaper, c), row.printed_g, 6e-13);
    for (int k = 1; k <= 7; ++k) EXPECT_NEAR(chebyshev_u(k, c), row.u[k - 1], 6e-10);
  }
}

TEST(row_normals_reference, direct_weights) {
  const struct {
    double d, exact[7], cubic[7];
  } rows[] = {{0.9,
               {.129272301, .258133816, .386175066, .512989176, .638173172, .761329261, .882066091},
               {.129387442, .258348245, .386458949, .513302015, .638469147, .761562435, .882196795}},
              {0.5,
               {.150718664, .298858491, .441884765, .577350269, .702937150, .816496581, .916085529},
               {.150600250, .298637625, .441592625, .577027875, .702632375, .816256375, .915951375}},
              {0, {.195090322, .382683432, .555570233, .707106781, .831469612, .923879533, .980785280}, {}}};
  for (const auto& row : rows) {
    const double phi = std::acos(row.d);
    for (int k = 1; k <= 7; ++k) {
      EXPECT_NEAR(std::sin(k * phi / 8) / std::sin(phi), row.exact[k - 1], 6e-10);
      if (row.cubic[0] != 0) {
        EXPECT_NEAR(row_weight(kRowWeightsCubic, k, row.d), row.cubic[k - 1], 6e-10);
      }
    }
  }
  // C.4's table of errors.
  const double most[] = {1.2e-4, 2.2e-4, 3.0e-4, 3.3e-4, 3.1e-4, 2.4e-4, 1.4e-4};
  for (int k = 1; k <= 7; ++k) {
    double error = 0;
    for (int i = 0; i < 20000; ++i) {
      const double d = i / 20000.0, phi = std::acos(d);
      error = std::max(error,
                       std::abs(row_weight(kRowWeightsCubic, k, d) - std::sin(k * phi / 8) / std::sin(phi)));
    }
    EXPECT_NEAR(error, most[k - 1], 0.06e-4) << k;
  }
}

TEST(row_normals_reference, rows_of_nine) {
  const double third = 1.0 / 3;
  const Vec3d z = {0, 0, 1}, first_b = {0.6, 0, 0.8}, second_a = {third, 2 * third, 2 * third},
              second_b = {2 * third, -third, 2 * third};
  const Row9 first =
      chebyshev_row(z, first_b, 0.8, exact_step_cosine(0.8), exact_step_weight(exact_step_cosine(0.8)));
  const double xs[] = {.080350925, .160182243, .238977706, .316227766, .391432868, .464106680, .533779242};
  const double zs[] = {.996766637, .987087458, .971025054, .948683298, .920206667, .885779312, .845623865};
  const std::vector<Vec3d> halved = halved_row(z, first_b, 9);
  for (std::size_t k = 1; k < 8; ++k) {
    expect_near(first[k], {xs[k - 1], 0, zs[k - 1]});
    expect_near(halved[k], {xs[k - 1], 0, zs[k - 1]});
    expect_near(slerp(z, first_b, static_cast<double>(k) / 8), {xs[k - 1], 0, zs[k - 1]});
  }
  const Row9 printed = chebyshev_row(kChebyshevPaper, z, first_b);
  expect_near(printed[1], {.083199, 0, .996712}, 6e-7);
  expect_near(printed[4], {.327346, 0, .947823}, 6e-7);
  expect_near(printed[7], {.552204, 0, .843084}, 6e-7);
  EXPECT_NEAR(length(printed[1]), 1.000178, 6e-7);
  EXPECT_NEAR(length(printed[4]), 1.002758, 6e-7);
  EXPECT_NEAR(length(printed[7]), 1.007829, 6e-7);

  const std::vector<Vec3d> second = halved_row(second_a, second_b, 9);
  expect_near(second[1], {.410200901, .563026186, .717451556});
  expect_near(second[4], {.588348405, .196116135, .784464541});
  expect_near(second[7], {.665976432, -.204300408, .717451556});
  const Row9 second_printed = chebyshev_row(kChebyshevPaper, second_a, second_b);
  expect_near(second_printed[4], {.597646, .184943, .791152}, 6e-7);
  expect_near(second_printed[7], {.680627, -.221771, .728044}, 6e-7);
  EXPECT_NEAR(length(second_printed[4]), 1.008616, 6e-7);
  EXPECT_NEAR(length(second_printed[7]), 1.021021, 6e-7);

  const std::vector<Vec3d> quarter = halved_row(z, {1, 0, 0}, 9);
  for (std::size_t k = 0; k < 9; ++k) {
    const double angle = static_cast<double>(k) * 11.25 * kPi / 180;
    expect_near(quarter[k], {std::sin(angle), 0, std::cos(angle)});
  }
  const Vec3d eighth = chebyshev_row(kChebyshevPaper, z, {1, 0, 0})[7];
  expect_near(eighth, {1.002951, 0, .202662}, 6e-7);
  EXPECT_NEAR(length(eighth), 1.023222, 6e-7);

  const std::vector<Vec3d> long_row = halved_row(z, first_b, 17);
  EXPECT_NEAR(dot(long_row[0], long_row[1]), .999191332301, 6e-13);
  expect_near(long_row[1], {.040207977, 0, .999191332});
  expect_near(long_row[4], {.160182243, 0, .987087458});
  expect_near(long_row[8], {.316227766, 0, .948683298});
  expect_near(long_row[12], {.464106680, 0, .885779312});
  expect_near(long_row[15], {.567348417, 0, .823477852});
}

// Largest errors over rows whose ends have d in [low, 1]: length, angle in degrees, vector.
struct RowErrors {
  double length = 0, angle = 0, vector = 0;

  void take(Vec3d found, Vec3d exact) {
    length = std::max(length, std::abs(of(found) - 1));
    vector = std::max(vector, of(found - exact));
    angle = std::max(angle, std::atan2(of(cross(found, exact)), dot(found, exact)) * 180 / kPi);
  }
  static double of(Vec3d v) { return std::sqrt(dot(v, v)); }
};

template <class Make>
RowErrors errors_of(Make make, double low) {
  RowErrors e;
  for (int i = 0; i <= 4000; ++i) {
    const double d = low + (1 - low) * i / 4000;
    const Vec3d a = {1, 0, 0}, b = {d, std::sqrt(1 - d * d), 0};
    const Row9 row = make(a, b);
    for (std::size_t k = 1; k < 8; ++k) e.take(row[k], slerp(a, b, static_cast<double>(k) / 8));
  }
  return e;
}

TEST(row_normals_reference, errors_of_rows_of_nine) {
  const auto paper = [](Vec3d a, Vec3d b) { return chebyshev_row(kChebyshevPaper, a, b); };
  const auto quadratic = [](Vec3d a, Vec3d b) { return chebyshev_row(kChebyshevQuadratic, a, b); };
  const auto cubic = [](Vec3d a, Vec3d b) { return chebyshev_row(kChebyshevCubic, a, b); };
  const auto direct = [](Vec3d a, Vec3d b) { return weighted_row(kRowWeightsCubic, a, b); };
  const auto quartic = [](Vec3d a, Vec3d b) { return weighted_row(kRowWeightsQuartic, a, b); };
  RowErrors e = errors_of(paper, 0);
  EXPECT_NEAR(e.length, 0.0256, 0.00006);
  EXPECT_NEAR(e.angle, 0.96, 0.006);
  EXPECT_NEAR(e.vector, 0.0266, 0.00006);
  e = errors_of(quadratic, 0);
  EXPECT_NEAR(e.length, 0.0018, 0.00006);
  EXPECT_NEAR(e.angle, 0.158, 0.0006);
  EXPECT_NEAR(e.vector, 0.0029, 0.00006);
  e = errors_of(quadratic, 0.99);
  EXPECT_NEAR(e.length, 0.00026, 0.000006);
  EXPECT_NEAR(e.angle, 0.003, 0.0006);
  e = errors_of(cubic, 0);
  EXPECT_NEAR(e.length, 0.00024, 0.000006);
  EXPECT_NEAR(e.angle, 0.016, 0.0006);
  EXPECT_NEAR(e.vector, 0.0003, 0.00006);
  e = errors_of(direct, 0);
  EXPECT_NEAR(e.length, 0.00063, 0.000006);
  EXPECT_NEAR(e.angle, 0.0065, 0.00006);
  EXPECT_NEAR(e.vector, 0.00063, 0.000006);
  EXPECT_NEAR(errors_of(direct, 0.9).length, 0.00061, 0.000006);
  EXPECT_NEAR(errors_of(direct, 0.99).length, 0.00011, 0.000006);
  e = errors_of(quartic, 0);
  EXPECT_NEAR(e.length, 0.000096, 0.0000006);
  EXPECT_NEAR(e.angle, 0.0010, 0.00006);
}

TEST(row_normals_reference, errors_of_rows_of_any_length) {
  const struct {
    int terms;
    double mu, error, unit;
  } rows[] = {{3, 1.712488, 2.9e-3, 6e-5},
              {4, 1.759354, 1.0e-3, 6e-5},
              {6, 1.817748, 1.6e-4, 6e-6},
              {8, 1.852981, 2.9e-5, 6e-7}};
  for (const auto& row : rows) {
    double error = 0;
    for (int i = 0; i <= 500; ++i) {
      const double d = i / 500.0;
      for (int j = 0; j <= 500; ++j) {
        const double u = j / 500.0, wa = series_weight(1 - u, d, row.terms, row.mu),
                     wb = series_weight(u, d, row.terms, row.mu);
        error = std::max(error, std::abs(std::sqrt(wa * wa + wb * wb + 2 * wa * wb * d) - 1));
      }
    }
    EXPECT_NEAR(error, row.error, row.unit) << row.terms;
  }
}

TEST(row_normals_reference, errors_of_arcs) {
  const auto errors = [](double low, double high) {
    RowErrors e;
    for (int i = 0; i <= 1000; ++i) {
      const double d = low + (high - low) * i / 1000;
      const Vec3d a = {1, 0, 0}, b = {d, std::sqrt(1 - d * d), 0};
      for (int j = 0; j <= 500; ++j) e.take(arc(a, b, j / 500.0), slerp(a, b, j / 500.0));
    }
    return e;
  };
  const RowErrors all = errors(0, 1);
  EXPECT_LT(all.length, 1.7e-4);
  EXPECT_LT(all.vector, 1.7e-4);
  EXPECT_LT(errors(0.9, 1).vector, 2.7e-5);
  EXPECT_LT(errors(0.99, 1).vector, 7e-6);
  EXPECT_LT(errors(kLowestArc, 0).vector, 1.7e-4);
  const Vec3d n = normalize(Vec3d{1, 2, 3});
  expect_near(arc(n, n, 0.3), n, 1e-15);
}

// Specification of relief and texturing, T7.
TEST(row_normals_reference, between_neighbours) {
  const Vec3d a = {1, 0, 0}, b = {0.8, 0.6, 0}, c = {0, 0, 1}, d = normalize(Vec3d{0, 0.1, 1}), e = {0, 1, 0};
  expect_near(between(Between::exact, a, b), {0.948683298, 0.316227766, 0});
  expect_near(between(Between::paper, a, b), {0.947016000, 0.315672000, 0});
  expect_near(between(Between::minimax, a, b), {0.948715964, 0.316238655, 0});
  expect_near(between(Between::exact, c, d), {0, 0.0498137019, 0.998758527});
  expect_near(between(Between::paper, c, d), {0, 0.0500005012, 1.00250383}, 6e-9);
  expect_near(between(Between::minimax, c, d), {0, 0.0498150792, 0.998786141});
  expect_near(between(Between::half_sum, c, d), {0, 0.0497518595, 0.997518595});
  expect_near(between(Between::exact, a, e), {0.707106781, 0.707106781, 0});
  expect_near(between(Between::paper, a, e), {0.705, 0.705, 0});
  // Too far apart for the form.
  expect_near(between(Between::half_sum, a, b), {0.948683298, 0.316227766, 0});
  expect_near(between(Between::minimax, a, e), {0.707106781, 0.707106781, 0});
}

TEST(row_normals_reference, matrix_block) {
  const Vec3d n00 = {0, 0, 1}, n80 = normalize(Vec3d{.3, 0, 1}), n08 = normalize(Vec3d{0, .4, 1}),
              n88 = normalize(Vec3d{.35, .45, .9});
  const auto exact = [](Vec3d a, Vec3d b) {
    const std::vector<Vec3d> row = halved_row(a, b, 9);
    Row9 r;
    std::copy(row.begin(), row.end(), r.begin());
    return r;
  };
  const auto paper = [](Vec3d a, Vec3d b) { return chebyshev_row(kChebyshevPaper, a, b); };
  const Matrix9 m = matrix_block(exact, n00, n80, n08, n88);
  expect_near(m[4][4], {.159908319, .205475911, .965509699});
  expect_near(m[1][0], {.036424040, 0, .999336424});
  expect_near(m[0][3], {0, .142206180, .989837058});
  expect_near(m[7][2], {.266428763, .107711426, .957817291});
  expect_near(m[5][8], {.207833249, .408884776, .888604851});
  const Matrix9 printed = matrix_block(paper, n00, n80, n08, n88);
  expect_near(printed[4][4], {.166841, .213862, .961054}, 6e-7);
  expect_near(printed[7][2], {.277290, .111845, .949710}, 6e-7);

  const Vec3d b = normalize(Vec3d{.4, .1, .9}), c = normalize(Vec3d{-.1, .5, .8});
  const TriangleBlock t = triangle_block(exact, n00, b, c);
  expect_near(t.v1, {.353024008, .379584244, .855154870});
  expect_near(t.v2, {.107085111, .581273747, .806631025});
  expect_near(t.node[8][0], {.206782307, .051695577, .977020289});
  expect_near(t.node[8][8], {.158405310, .333124709, .929481407});
  expect_near(t.node[5][5], {.098965378, .209568697, .972772746});
  expect_near(t.node[12][2], {.296987926, .148757870, .943222809});
  expect_near(t.node[3][11], {.006191421, .396863242, .917856870});
  expect_near(t.node[10][6], {.222243343, .277619609, .934631076});

  // With the edges exact: on them as the rows of nine, inside near the blocks.
  const TriangleNodes exact_edges(n00, b, c, 16);
  for (int i = 0; i <= 16; ++i) {
    for (int j = 0; i + j <= 16; ++j) {
      const Vec3d node = exact_edges.at(i, j);
      EXPECT_NEAR(length(node), 1, 1e-4);
      EXPECT_GT(dot(node, t.node[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)]), 0.9998);
    }
  }
  expect_near(exact_edges.at(10, 6), slerp(b, c, 6.0 / 16));
  expect_near(exact_edges.at(8, 0), t.node[8][0]);
}

double angle_deg(Vec3d a, Vec3d b) { return std::atan2(length(cross(a, b)), dot(a, b)) * 180 / kPi; }

// Random unit vectors within a cone of this full angle, or on its rim.
enum class In { cone, rim };
Vec3d vector_in(In in, double full_deg, Random& random) {
  const double lowest = std::cos(full_deg / 2 * kPi / 180), turn = 2 * kPi * double{random.unit()};
  const double z = in == In::rim ? lowest : 1 - (1 - lowest) * double{random.unit()},
               r = std::sqrt(1 - z * z);
  return {r * std::cos(turn), r * std::sin(turn), z};
}

Row9 exact_row(Vec3d a, Vec3d b) {
  Row9 row;
  for (std::size_t k = 0; k < 9; ++k) row[k] = slerp(a, b, static_cast<double>(k) / 8);
  return row;
}

template <class Make>
RowErrors matrix_errors(Make make, In in, double full_deg) {
  RowErrors e;
  Random random(1);
  for (int trial = 0; trial < 2000; ++trial) {
    Vec3d n[4];
    for (Vec3d& v : n) v = vector_in(in, full_deg, random);
    const Matrix9 found = matrix_block(make, n[0], n[1], n[2], n[3]),
                  exact = matrix_block(exact_row, n[0], n[1], n[2], n[3]);
    for (std::size_t i = 0; i < 9; ++i) {
      for (std::size_t j = 0; j < 9; ++j) e.take(found[i][j], exact[i][j]);
    }
  }
  return e;
}

// C.6 prints the largest errors of random corners; those here are other random ones, and come within 6 %.
// Corners on the cone's rim are the worst.
TEST(row_normals_reference, errors_of_matrix_blocks) {
  const auto paper = [](Vec3d a, Vec3d b) { return chebyshev_row(kChebyshevPaper, a, b); };
  const auto minimax = [](Vec3d a, Vec3d b) {  // C.3, "minimax"
    const double d = dot(a, b), c = 0.980833 + d * (0.023373 - d * 0.004254), e = 1 - c;
    return chebyshev_row(a, b, d, c, 0.125168 + e * (2.463230 + e * 60.481425));
  };
  const auto direct = [](Vec3d a, Vec3d b) { return weighted_row(kRowWeightsCubic, a, b); };
  const struct {
    double full_deg, length, angle;
  } rows[] = {{10, 0.016, 0.66}, {30, 0.017, 1.63}, {60, 0.030, 1.91}, {90, 0.048, 1.97}};
  for (const auto& r : rows) {
    SCOPED_TRACE(r.full_deg);
    const RowErrors of_paper = matrix_errors(paper, In::cone, r.full_deg);
    EXPECT_NEAR(of_paper.length, r.length, 0.06 * r.length);
    EXPECT_NEAR(of_paper.angle, r.angle, 0.06 * r.angle);
    EXPECT_GE(matrix_errors(paper, In::rim, r.full_deg).length, of_paper.length);
    const RowErrors of_minimax = matrix_errors(minimax, In::cone, r.full_deg);
    EXPECT_NEAR(of_minimax.length, 0.004, 0.0005);
    EXPECT_GE(of_minimax.angle, 0.04);
    EXPECT_LE(of_minimax.angle, 0.245);
    const RowErrors of_direct = matrix_errors(direct, In::cone, r.full_deg);
    EXPECT_GE(of_direct.length, 0.00015);
    EXPECT_LE(of_direct.length, 0.00105);
    EXPECT_LE(of_direct.angle, 0.0225);
  }
  const auto halved = [](Vec3d a, Vec3d b) {
    const std::vector<Vec3d> row = halved_row(a, b, 9);
    Row9 r;
    std::copy(row.begin(), row.end(), r.begin());
    return r;
  };
  EXPECT_LT(matrix_errors(halved, In::rim, 90).vector, 1e-14);
}

// How far nodes of a triangle are from arcs between arcs: C.6's triangle block, Phong's linear normals, and
// ours with exact edges.
struct FarFromArcs {
  double block = 0, inner = 0, phong = 0, edges = 0;  // degrees; `inner`: of the block, not on edge BC

  FarFromArcs(In in, double full_deg) {
    Random random(1);
    for (int trial = 0; trial < 1000; ++trial) {
      const Vec3d a = vector_in(in, full_deg, random), b = vector_in(in, full_deg, random),
                  c = vector_in(in, full_deg, random);
      const TriangleBlock nodes = triangle_block(exact_row, a, b, c);
      const TriangleNodes ours(a, b, c, 16);
      for (int j = 0; j < 16; ++j) {
        const double v = j / 16.0;
        const Vec3d left = slerp(a, c, v), right = slerp(b, c, v);
        for (int i = 0; i + j <= 16; ++i) {
          const Vec3d exact = slerp(left, right, static_cast<double>(i) / (16 - j));
          const double u = i / 16.0,
                       found = angle_deg(nodes.node[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)],
                                         exact);
          block = std::max(block, found);
          if (i + j < 16) inner = std::max(inner, found);
          phong = std::max(phong, angle_deg(a * (1 - u - v) + b * u + c * v, exact));
          edges = std::max(edges, angle_deg(ours.at(i, j), exact));
        }
      }
    }
  }
};

// Of random corners again: the block's within a quarter of what is printed, Phong's within 5 %.
TEST(row_normals_reference, triangle_blocks_against_arcs) {
  const struct {
    double full_deg, block, phong;
  } rows[] = {{10, 0.007, 0.005}, {30, 0.19, 0.13}, {60, 1.36, 1.05}, {90, 3.5, 3.9}};
  for (const auto& r : rows) {
    SCOPED_TRACE(r.full_deg);
    const FarFromArcs random(In::cone, r.full_deg), worst(In::rim, r.full_deg);
    EXPECT_NEAR(random.block, r.block, 0.25 * r.block);
    EXPECT_NEAR(random.phong, r.phong, std::max(0.05 * r.phong, 0.0005));
    EXPECT_LT(random.inner, random.block);  // always the hypotenuse
    EXPECT_GT(worst.block, random.block);
    EXPECT_LT(worst.edges, 0.01);
  }
}

}  // namespace
}  // namespace blysk::reference
