// The laws of normals along a row: reference forms against the values of the specification, the kernels' row
// formulas against the reference forms. The kernels' headers are compiled here for the plain processor.
#define BLYSK_ISA isa_test
#include <gtest/gtest.h>

#include "render/testing.h"
#include "shading/angular_reference.h"
#include "shading/angular_row.h"
#include "shading/row_edges.h"
#include "shading/symmetric_reference.h"
#include "shading/symmetric_row.h"

namespace blysk {
namespace {

using isa_test::AngularRow;
using isa_test::Path;
using isa_test::RowRoot;
using isa_test::SymmetricRow;
using isa_test::V3;

// Nine significant digits are printed.
void expect_printed(double found, double printed) {
  EXPECT_NEAR(found, printed, std::max(6e-9 * std::abs(printed), 1e-9));
}

// R6.
TEST(symmetric_reference, roots_are_the_specification) {
  using namespace reference;
  const double rows[][9] = {
      {0, 1, 1, 1.003, 1, 1.00318765, 1, 0.999520994, 0.999986486},
      {-0.01, 1.00503782, 1.0050375, 1.007112, 1.00414375, 1.00722431, 1.00430451, 1.00482007, 1.00503139},
      {-0.05, 1.02597835, 1.0259375, 1.0252, 1.02234375, 1.02504188, 1.02310379, 1.02637218, 1.02597747},
      {-0.125, 1.06904497, 1.06835938, 1.0661875, 1.06347656, 1.06565554, 1.06517165, 1.06934828, 1.06903352},
      {-0.25, 1.15470054, 1.1484375, 1.155, 1.15234375, 1.15423115, 1.15505056, 1.15415256, 1.15470042},
      {-0.378, 1.26795782, 1.2425815, 1.27249888, 1.26965575, 1.2719877, 1.27269038, 1.2682234, 1.2679334},
      {-0.5, 1.41421356, 1.34375, 1.4095, 1.40625, 1.40970555, 1.40893011, 1.41353615, 1.41419002}};
  for (const auto& r : rows) {
    const double m = r[0];
    const double found[] = {
        exact_root(m),   taylor_root(m),   chebyshev_root(m), shift_root(m),
        minimax_root(m), anchored_root(m), cubic_root(m),     newton_step(chebyshev_root(m), m)};
    for (int i = 0; i < 8; ++i) EXPECT_NEAR(found[i], r[i + 1], 5.1e-9) << m << ", column " << i;
  }
}

// Largest relative error over [lowest, 0].
template <class Root>
double largest_error(Root root, double lowest) {
  double worst = 0;
  for (int i = 0; i <= 100000; ++i) {
    const double m = lowest * i / 100000;
    worst = std::max(worst, std::abs(root(m) * std::sqrt(1 + m) - 1));
  }
  return worst;
}

// Table 6.3, and the errors that the kernels' comments quote.
TEST(symmetric_reference, errors_of_the_roots) {
  using namespace reference;
  EXPECT_NEAR(largest_error(taylor_root, -0.5), 0.0498253, 5e-8);
  EXPECT_NEAR(largest_error(chebyshev_root, -0.5), 0.0035814, 5e-8);
  EXPECT_NEAR(largest_error(shift_root, -0.5), 0.0056311, 5e-8);
  EXPECT_NEAR(largest_error(minimax_root, -0.5), 0.00318765, 5e-9);
  EXPECT_NEAR(largest_error(anchored_root, -0.5), 0.00373597, 5e-9);
  EXPECT_NEAR(largest_error(cubic_root, -0.5), 0.00047901, 5e-9);
  const struct {
    double degrees, quoted;
  } rows[] = {{10, 5.4e-9}, {20, 3.5e-7}, {30, 4.1e-6}, {45, 4.9e-5}, {60, 3.0e-4}, {90, 4.2e-3}};
  for (const auto& r : rows) {
    const double lowest = (std::cos(r.degrees * 3.14159265358979 / 180) - 1) / 2;
    const double error = largest_error([&](double m) { return fitted_root(m, lowest); }, lowest);
    EXPECT_LE(error, r.quoted) << r.degrees;
    EXPECT_GE(error, 0.93 * r.quoted) << r.degrees;
    EXPECT_LE(error, double(isa_test::own_root_error(static_cast<float>(-4 * lowest)))) << r.degrees;
  }
}

// R7a, R7b.
TEST(symmetric_reference, is_the_specification) {
  const struct {
    Vec3d na, nb, l;
    double m, s, c, b, g, h;
  } rows[] = {{{0.1, 0, 1},
               {0.5, 0.1, 1},
               {0.3, 0.4, 1},
               13,
               -0.0106504518,
               0.000819265524,
               0.916687969,
               0.00242513294,
               0.948214697},
              {{-0.6, 0.2, 1},
               {0.7, -0.3, 1},
               {0, 0, 1},
               10,
               -0.130073663,
               0.0130073663,
               0.845154255,
               -0.00495969706,
               0.795557284},
              {{1, 0, 0.1},
               {0.1, 1, 0},
               {0.2, 0.9, 0.3},
               8,
               -0.225247525,
               0.0281559406,
               0.236049575,
               0.0885185905,
               0.944198299},
              {{0, 0, 1}, {0, 0, 1}, {0.6, 0, 0.8}, 5, 0, 0, 0.8, 0, 0.8},
              {{0.2, 0.1, 1},
               {0.25, 0.1, 1},
               {-0.5, 0.2, -0.3},
               6,
               -0.000373910087,
               6.23183478e-05,
               -0.601585208,
               -0.00546947297,
               -0.634402045}};
  std::vector<reference::SymmetricRow> all;
  for (const auto& r : rows) {
    const reference::SymmetricRow& row =
        all.emplace_back(normalize(r.na), normalize(r.nb), normalize(r.l), r.m);
    expect_printed(row.s, r.s);
    EXPECT_NEAR(row.c, r.c, 6e-9 * r.c + 1e-15);
    expect_printed(row.b, r.b);
    expect_printed(row.g, r.g);
    expect_printed(row.h, r.h);
  }
  const double points[][9] = {
      {0, 0, 0, 0.916687969, 0.948214697, 0.916687969, 0.948214697, 0.919438032, 0.916687969},
      {0, 3, -0.0245779657, 0.923963367, 0.940939298, 0.935531623, 0.952720096, 0.936344719, 0.933642448},
      {0, 6, -0.034409152, 0.931238766, 0.933663899, 0.947686025, 0.95015399, 0.94784998, 0.945152134},
      {0, 13, 0, 0.948214697, 0.916687969, 0.948214697, 0.916687969, 0.951059341, 0.948214697},
      {1, 1, -0.117066297, 0.840194558, 0.800516981, 0.894161191, 0.85193508, 0.891795461, 0.889508184},
      {1, 4, -0.312176792, 0.825315467, 0.815396072, 0.995134015, 0.983173586, 0.997575157, 0.995333325},
      {1, 5, -0.325184158, 0.820355769, 0.820355769, 0.998641482, 0.998641482, 1.00145743, 0.999212739},
      {2, 2, -0.337871287, 0.413086756, 0.767161118, 0.507656628, 0.94279088, 0.509241321, 0.508101988},
      {2, 4, -0.45049505, 0.590123937, 0.590123937, 0.796081307, 0.796081307, 0.797236815, 0.795432225},
      {2, 7, -0.197091584, 0.855679708, 0.324568165, 0.954944712, 0.362220408, 0.953467542, 0.951199314},
      {3, 0, 0, 0.8, 0.8, 0.8, 0.8, 0.8024, 0.8},
      {3, 2, 0, 0.8, 0.8, 0.8, 0.8, 0.8024, 0.8},
      {4, 0, 0, -0.601585208, -0.634402045, -0.601585208, -0.634402045, -0.603389963, -0.601585208},
      {4, 3, -0.00056086513, -0.617993626, -0.617993626, -0.618167005, -0.618167005, -0.619987451,
       -0.618134595}};
  for (const auto& p : points) {
    const reference::SymmetricRow& row = all[static_cast<std::size_t>(p[0])];
    const double x = p[1], mirror = row.m - x;
    EXPECT_NEAR(row.square(x), p[2], 6e-10);
    EXPECT_NEAR(row.square(mirror), row.square(x), 1e-15);
    expect_printed(row.numerator(x), p[3]);
    expect_printed(row.mirrored(x), p[4]);
    expect_printed(row.numerator(mirror), p[4]);
    expect_printed(row.cosine(x, reference::exact_root), p[5]);
    expect_printed(row.cosine(mirror, reference::exact_root), p[6]);
    expect_printed(row.cosine(x, reference::chebyshev_root), p[7]);
    expect_printed(row.cosine(x, reference::shift_root), p[8]);
  }
}

// R8a, R8b.
TEST(angular_reference, is_the_specification) {
  const struct {
    Vec3d na, nb, h;
    double m, phi, step, cos_a, cos_l, s, cos_beta, psi, foot;
  } rows[] = {{{0.1, 0, 1},
               {0.5, 0.1, 1},
               {0.3, 0.4, 1},
               13,
               0.374277357,
               0.0287905659,
               0.916687969,
               0.948214697,
               0.259811659,
               0.952795324,
               0.276181238,
               9.59276864},
              {{0.1, 0, 1},
               {0.5, 0.1, 1},
               {-0.3, 0.2, 1},
               8,
               0.374277357,
               0.0467846696,
               0.907970682,
               0.72911286,
               -0.317289066,
               0.961812409,
               -0.336183492,
               -7.18576181},
              {{-0.6, 0.2, 1},
               {0.7, -0.3, 1},
               {0, 0.1, 1},
               10,
               1.21361838,
               0.121361838,
               0.857779113,
               0.767860812,
               0.499477461,
               0.99260402,
               0.527296748,
               4.34483159},
              {{1, 0, 0.1},
               {0.1, 1, 0},
               {0.2, 0.9, 0.3},
               8,
               1.47162394,
               0.183952993,
               0.236049575,
               0.944198299,
               0.925373927,
               0.955005919,
               1.32103696,
               7.18138336}};
  std::vector<reference::AngularRow> all;
  for (const auto& r : rows) {
    const reference::AngularRow& row =
        all.emplace_back(normalize(r.na), normalize(r.nb), normalize(r.h), r.m);
    const double found[] = {row.phi, row.step(),   row.cos_a, row.cos_l,
                            row.s,   row.cos_beta, row.psi,   row.foot()};
    const double printed[] = {r.phi, r.step, r.cos_a, r.cos_l, r.s, r.cos_beta, r.psi, r.foot};
    for (int i = 0; i < 8; ++i) expect_printed(found[i], printed[i]);
  }
  const double points[][4] = {{0, 0, 0.916687969, 0.0129144693},  {0, 3, 0.935683299, 0.0360117218},
                              {0, 6, 0.947702704, 0.0681719938},  {0, 13, 0.948214697, 0.0700380614},
                              {1, 0, 0.907970682, 0.00800923952}, {1, 4, 0.833086969, 0.000108272229},
                              {1, 8, 0.72911286, 1.37955149e-07}, {2, 0, 0.857779113, 0.000466415905},
                              {2, 5, 0.989467939, 0.588960707},   {2, 10, 0.767860812, 1.83706784e-06},
                              {3, 2, 0.55307588, 1.37795793e-13}, {3, 4, 0.796081307, 1.11653236e-05},
                              {3, 7, 0.954474369, 0.09732256}};
  for (const auto& p : points) {
    const reference::AngularRow& row = all[static_cast<std::size_t>(p[0])];
    expect_printed(row.expanded(p[1]), p[2]);
    EXPECT_NEAR(std::pow(row.expanded(p[1]), 50), p[3], 6e-9 * p[3]);
    EXPECT_NEAR(row.pair(p[1]), row.expanded(p[1]), 1e-14);
    EXPECT_NEAR(row.printed(p[1]), row.expanded(p[1]), 1e-14);
    // Rotating by a step, and the three-term recurrence.
    EXPECT_NEAR(row.expanded(p[1] + 1),
                2 * std::cos(row.step()) * row.expanded(p[1]) - row.expanded(p[1] - 1), 1e-14);
  }
}

// Half a pixel at most: 7.4 of the specification quotes 0.0083 for 30 degrees in 16 steps.
TEST(angular_reference, the_walk_is_half_a_step_off) {
  Random random(5);
  const double phi = 3.14159265358979 / 6;
  double worst = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vec3d na = {0, 0, 1}, nb = {std::sin(phi), 0, std::cos(phi)};
    const double at = uniform(random, 0, phi);
    const reference::AngularRow row(na, nb, {std::sin(at), 0, std::cos(at)}, 16);
    for (int t = 0; t <= 16; ++t) worst = std::max(worst, std::abs(row.walked(t) - row.expanded(t)));
  }
  EXPECT_LE(worst, 0.00835);
  EXPECT_GE(worst, 0.0075);
}

// R9.
TEST(angular_reference, triangles_are_the_specification) {
  const struct {
    Vec3d c, d, f, h;
    double m_d, m_f, i, tau, mu, cos_o, cos_o1, cos_o2, cos_phi, cos_alpha, cos_lambda;
  } rows[] = {{{0, 0, 1},
               {0.4, 0, 1},
               {0.1, 0.5, 1},
               {0.2, 0.2, 1},
               8,
               12,
               1,
               0.0475632971,
               0.0392948129,
               0.196116135,
               0.707106781,
               0.832050294,
               0.998464318,
               0.97031233,
               0.97040388},
              {{0, 0, 1},
               {0.4, 0, 1},
               {0.1, 0.5, 1},
               {0.2, 0.2, 1},
               8,
               12,
               4,
               0.190253189,
               0.157179252,
               0.196116135,
               0.707106781,
               0.832050294,
               0.975656906,
               0.981281733,
               0.98583626},
              {{0, 0, 1},
               {0.4, 0, 1},
               {0.1, 0.5, 1},
               {0.2, 0.2, 1},
               8,
               12,
               8,
               0.380506377,
               0.314358503,
               0.196116135,
               0.707106781,
               0.832050294,
               0.905497897,
               0.964901281,
               0.985116776},
              {{0.2, 0.1, 1},
               {-0.4, 0.3, 1},
               {0.5, 0.6, 1},
               {0, -0.5, 1},
               20,
               14,
               5,
               0.148267838,
               0.16737749,
               -0.194126281,
               -0.0243902439,
               -0.975949933,
               0.970429271,
               0.818116278,
               0.726766092},
              {{0.2, 0.1, 1},
               {-0.4, 0.3, 1},
               {0.5, 0.6, 1},
               {0, -0.5, 1},
               20,
               14,
               14,
               0.415149945,
               0.468656971,
               -0.194126281,
               -0.0243902439,
               -0.975949933,
               0.781025038,
               0.753291779,
               0.493435164}};
  for (const auto& r : rows) {
    const Vec3d c = normalize(r.c), d = normalize(r.d), f = normalize(r.f), h = normalize(r.h);
    const reference::SphericalTriangle t(c, d, f, h);
    const double tau = r.i * t.angle_d / r.m_d, mu = r.i * t.angle_f / r.m_f;
    const Vec3d across = cross(c, h);
    const double length = std::sqrt(dot(across, across));
    expect_printed(tau, r.tau);
    expect_printed(mu, r.mu);
    expect_printed(t.cos_o, r.cos_o);
    expect_printed(t.h_d / length, r.cos_o1);
    expect_printed(t.h_f / length, r.cos_o2);
    expect_printed(t.cos_phi(tau, mu), r.cos_phi);
    expect_printed(t.cos_alpha(tau), r.cos_alpha);
    expect_printed(t.cos_lambda(mu), r.cos_lambda);
    // The row they give is the row of the vectors.
    const auto along = [](Vec3d a, Vec3d b, double angle) {
      const Vec3d side = normalize(b - a * dot(a, b));
      return a * std::cos(angle) + side * std::sin(angle);
    };
    const reference::AngularRow by_vectors(along(c, d, tau), along(c, f, mu), h, 10);
    const reference::AngularRow by_angles(t.cos_phi(tau, mu), t.cos_alpha(tau), t.cos_lambda(mu), 10);
    for (int x = 0; x <= 10; ++x) EXPECT_NEAR(by_angles.expanded(x), by_vectors.expanded(x), 1e-12);
  }
}

// R10.
TEST(angular_reference, arccosines_are_the_specification) {
  using namespace reference;
  const double rows[][8] = {
      {0, 1.57079633, 1.57079633, 1.55877507, 1.56466508, 1.57018194, 1.57072543, 1.57018195},
      {0.25, 1.31811607, 1.31819216, 1.32780825, 1.32127087, 1.31862464, 1.31813591, 1.31862465},
      {0.5, 1.04719755, 1.04996299, 1.04818932, 1.05124101, 1.04712539, 1.0471512, 1.0471254},
      {0.75, 0.722734248, 0.750483827, 0.719918265, 0.723843198, 0.722454482, 0.722754844, 0.722454486},
      {0.8, 0.643501109, 0.685462993, 0.648425801, 0.643937408, 0.643279145, 0.643527611, 0.643279147},
      {0.95, 0.317560429, 0.477900493, 0.422271902, 0.316737258, 0.317595564, 0.31756267, 0.317595563},
      {0.999, 0.0447250872, 0.40562916, 0.344599708, 0.0445517322, 0.0447422984, 0.0447231274, 0.0447422981}};
  for (const auto& r : rows) {
    const double x = r[0];
    const double found[] = {std::acos(x),    arccos_taylor(x), arccos_parabola(x),        arccos_root1(x),
                            arccos_root2(x), arccos_root3(x),  angle_of_chord2(2 - 2 * x)};
    for (int i = 0; i < 7; ++i) EXPECT_NEAR(found[i], r[i + 1], 6e-9) << x << ", column " << i;
  }
  for (int i = 1; i <= 2000; ++i) {
    const double z = i / 1000.0, exact = 2 * std::asin(std::sqrt(z) / 2);
    EXPECT_NEAR(reference::angle_of_chord(z) / exact, 1, 4.55e-5);
    EXPECT_NEAR(double(isa_test::angle_of_chord(static_cast<float>(z))) / exact, 1, 4.6e-5);
  }
}

TEST(angular_row, sine_and_cosine) {
  double sine = 0, cosine = 0;
  for (int i = -100000; i <= 100000; ++i) {
    const float x = static_cast<float>(i) * 7.853981e-6f;
    sine = std::max(sine, std::abs(double(isa_test::small_sine(x)) - std::sin(double(x))));
    cosine = std::max(cosine, std::abs(double(isa_test::small_cosine(x)) - std::cos(double(x))));
  }
  EXPECT_LE(sine, 1e-6);
  EXPECT_LE(cosine, 1.9e-7);
}

V3<float> lane(Vec3d v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

// Ends up to 90 degrees apart, most of them near.
struct RandomRow {
  Vec3d na, nb, from, to;  // the unit vector to a lamp at both ends; equal if it is far
  bool far;
  double m, x;

  explicit RandomRow(Random& random) {
    na = random_direction(random);
    do {
      nb = normalize(na + random_direction(random) * std::pow(uniform(random, 0, 1.2), 3));
    } while (dot(na, nb) < 0.001);
    far = whole(random, 0, 1) == 0;
    from = to = random_direction(random);
    if (!far) to = normalize(from + random_direction(random) * uniform(random, 0, 0.3));
    m = double(whole(random, 1, 300));
    x = double(whole(random, 0, static_cast<std::int64_t>(m)));
  }

  [[nodiscard]] Path<float> path() const { return {lane(from), lane(normalize(from + to)), lane(to), far}; }
  // What the parabola through three unit vectors gives.
  [[nodiscard]] Vec3d direction(double t) const {
    if (far) return from;
    const Vec3d middle = normalize(from + to);
    return from + (to - from) * t + (middle * 4 - (from + to) * 2) * (t * (1 - t));
  }
  template <class Law, class... Root>
  [[nodiscard]] double cosine(const typename Law::template Turn<float>& turn, Root... root) const {
    const auto along = Law::dot_along(turn, lane(na), lane(nb), path());
    const float t = static_cast<float>(x) / static_cast<float>(m);
    return double(
        Law::cosine(along, Law::point(root..., turn, isa_test::RowPoint<float>{t, t - t * t}), far));
  }
};

TEST(symmetric_row, follows_the_reference_form) {
  Random random(17);
  const struct {
    RowRoot root;
    double (*reference)(double);
  } rows[] = {{RowRoot::exact, reference::exact_root},
              {RowRoot::taylor, reference::taylor_root},
              {RowRoot::chebyshev, reference::chebyshev_root},
              {RowRoot::shift, reference::shift_root},
              {RowRoot::minimax, nullptr}};
  double worst = 0;
  for (int i = 0; i < 1000000; ++i) {
    const RandomRow row(random);
    const auto& r = rows[i % 5];
    const V3<float> difference = isa_test::minus(lane(row.nb), lane(row.na));
    const auto turn = isa_test::root_terms(r.root, isa_test::dot(difference, difference));
    const double found = row.cosine<SymmetricRow>(turn, r.root);
    const Vec3d direction = row.direction(row.x / row.m);
    const reference::SymmetricRow exact(row.na, row.nb, direction, row.m);
    const double lowest = std::min(-1e-12, (dot(row.na, row.nb) - 1) / 2), m = exact.square(row.x);
    const double root = r.reference != nullptr ? r.reference(m) : reference::fitted_root(m, lowest);
    worst = std::max(worst, std::abs(found - exact.numerator(row.x) * root));
  }
  EXPECT_LE(worst, 5e-6);
  RecordProperty("worst", std::to_string(worst * 1e6) + "e-6");
}

// Acceptance (h): one root serves a pixel and its mirror.
TEST(symmetric_row, is_symmetric) {
  Random random(18);
  for (int i = 0; i < 10000; ++i) {
    const float c = static_cast<float>(uniform(random, 0, 2));
    const auto turn = isa_test::root_terms(RowRoot::minimax, c);
    const float t = static_cast<float>(whole(random, 0, 64)) / 64;
    const auto root = [&](float at) {
      return SymmetricRow::point(RowRoot::minimax, turn, isa_test::RowPoint<float>{at, at - at * at}).root;
    };
    EXPECT_EQ(root(t), root(1 - t));
  }
}

TEST(angular_row, follows_the_reference_form) {
  Random random(19);
  double worst = 0;
  for (int i = 0; i < 1000000; ++i) {
    const RandomRow row(random);
    const V3<float> difference = isa_test::minus(lane(row.nb), lane(row.na));
    const double found = row.cosine<AngularRow>(AngularRow::turn_of(isa_test::dot(difference, difference)));
    const Vec3d direction = row.direction(row.x / row.m);
    const double c = dot(row.na, row.nb), t = row.x / row.m;
    const double expected = 1 - c < 1e-9
                                ? dot(row.na, direction) * (1 - t) + dot(row.nb, direction) * t
                                : reference::AngularRow(row.na, row.nb, direction, row.m).pair(row.x);
    worst = std::max(worst, std::abs(found - expected));
  }
  EXPECT_LE(worst, 4e-5);  // the angle is 4.6e-5 off at 90 degrees, the ends by half of that
  RecordProperty("worst", std::to_string(worst * 1e6) + "e-6");
}

// A foot that is half-way between two pixels, or at an end, may be decided either way.
TEST(angular_row, walks_from_the_foot_as_the_reference_form) {
  Random random(29);
  double worst = 0;
  long walks = 0;
  for (int i = 0; i < 1500000; ++i) {
    RandomRow row(random);
    const double c = dot(row.na, row.nb);
    if (1 - c < 1e-6) continue;
    const reference::AngularRow exact(row.na, row.nb, row.from, row.m);
    const double foot = exact.foot(), part = foot - std::floor(foot);
    const double close = 1e-6 + 2e-6 / exact.step() + 1e-4 * row.m;
    if (std::abs(part - 0.5) < close || std::abs(foot) < close || std::abs(foot - row.m) < close) continue;
    if (row.m < 2 && foot > 0 && foot < row.m) continue;  // the step is as wide as the row
    const V3<float> difference = isa_test::minus(lane(row.nb), lane(row.na));
    const auto turn = AngularRow::turn_of(isa_test::dot(difference, difference));
    const Path<float> far{lane(row.from), {}, {}, true};
    const auto along = AngularRow::from_foot(AngularRow::dot_along(turn, lane(row.na), lane(row.nb), far),
                                             turn.angle, static_cast<float>(row.m));
    const float t = static_cast<float>(row.x) / static_cast<float>(row.m);
    const double found = double(
        AngularRow::cosine(along, AngularRow::point(turn, isa_test::RowPoint<float>{t, t - t * t}), true));
    worst = std::max(worst, std::abs(found - exact.walked(row.x)));
    walks += foot > 0 && foot < row.m ? 1 : 0;
  }
  EXPECT_LE(worst, 1e-4);
  EXPECT_GT(walks, 10000);
  RecordProperty("worst", std::to_string(worst * 1e6) + "e-6");
}

// Rows between edges that turn evenly: by vectors here, by spherical triangles there.
TEST(angular_row, turns_along_edges_as_the_reference_form) {
  Random random(31);
  double worst = 0;
  for (int i = 0; i < 1000000; ++i) {
    Vec3d n[3] = {random_direction(random), {}, {}};
    do {
      for (int k = 1; k < 3; ++k) {
        n[k] = normalize(n[0] + random_direction(random) * std::pow(uniform(random, 0, 1.2), 3));
      }
    } while (std::min({dot(n[0], n[1]), dot(n[0], n[2]), dot(n[1], n[2])}) < 0.001 ||
             length(cross(n[0], n[1])) < 1e-3 || length(cross(n[0], n[2])) < 1e-3);
    const double down = uniform(random, 0, 1), over = uniform(random, 0, 1), t = uniform(random, 0, 1);
    const Vec3d h = random_direction(random);
    const reference::SphericalTriangle triangle(n[0], n[1], n[2], h);
    const double tau = triangle.angle_d * down, mu = triangle.angle_f * over;
    const double phi = triangle.cos_phi(tau, mu);
    if (phi > 1 - 1e-8) continue;
    const double expected =
        reference::AngularRow(phi, triangle.cos_alpha(tau), triangle.cos_lambda(mu), 1).expanded(t);
    const auto turned = [&](const V3<float>& a, const V3<float>& b, double u) {
      return isa_test::turned(a, b, static_cast<float>(u));
    };
    const V3<float> c = lane(n[0]), at = turned(turned(c, lane(n[1]), down), turned(c, lane(n[2]), over), t);
    worst = std::max(worst, std::abs(double(isa_test::dot(at, lane(h))) - expected));
  }
  EXPECT_LE(worst, 1e-4);
  RecordProperty("worst", std::to_string(worst * 1e6) + "e-6");
}

TEST(angular_row, equal_ends) {
  const Vec3d n = normalize(Vec3d{0.3, -0.2, 0.9});
  const auto turn = AngularRow::turn_of(0.0f);
  const Path<float> up{lane({0, 0, 1}), {}, {}, true};
  const auto along = AngularRow::dot_along(turn, lane(n), lane(n), up);
  for (const float t : {0.0f, 0.25f, 1.0f}) {
    const auto point = AngularRow::point(turn, isa_test::RowPoint<float>{t, t - t * t});
    EXPECT_NEAR(double(AngularRow::cosine(along, point, true)), n.z, 2e-7);
  }
}

}  // namespace
}  // namespace blysk
