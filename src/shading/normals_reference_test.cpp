// The reference forms against the values of the specification, and the errors of their polynomials over all
// of their range.
#include "shading/normals_reference.h"

#include <gtest/gtest.h>

#include <cmath>

#include "shading/testing.h"

namespace blysk::reference {
namespace {

TEST(normals_reference, linear_normals) {
  const LinearNormals a =
      linear_normals({{10, 10}, {110, 30}, {40, 90}}, {{0, 0, 1}, {0.6, 0, 0.8}, {0, 0.6, 0.8}});
  expect_near(a.horizontal, {0.00648648649, -0.00162162162, -0.00162162162});
  expect_near(a.vertical, {-0.00243243243, 0.00810810811, -0.00189189189});
  expect_near(a.horizontal + a.vertical, {0.00405405405, 0.00648648649, -0.00351351351});
  expect_near(a.at(50, 40), {0.186486486, 0.178378378, 0.878378378});
  const LinearNormals b =
      linear_normals({{0, 0}, {64, 0}, {0, 64}}, {{0, 0, 1}, {0.28, 0, 0.96}, {0, -0.28, 0.96}});
  expect_near(b.horizontal, {0.004375, 0, -6.25e-4});
  expect_near(b.vertical, {0, -0.004375, -6.25e-4});
  expect_near(b.at(16, 32), {0.07, -0.14, 0.97});
}

TEST(normals_reference, normalize_fast) {
  const InverseLength& paper = kInverseLengthPaper;
  expect_near(normalize_fast(paper, {0, 0, 1}), {0, 0, 1.003});
  expect_near(normalize_fast(paper, {0.6, 0.2, 0.7}), {0.634299720, 0.211433240, 0.740016340});
  expect_near(normalize_fast(paper, {0.5, 0.5, 0}), {0.70475, 0.70475, 0});
  expect_near(normalize_fast(paper, {0.3, -0.4, 0.6}), {0.385441860, -0.513922480, 0.770883720});
  expect_near(normalize_fast(paper, {0.7, 0.7, 0}), {0.707958160, 0.707958160, 0});
  expect_near(normalize_fast(kInverseLengthMinimax, {0, 0, 1}), {0, 0, 1.00321497}, 1e-8);
  expect_near(normalize_fast(kInverseLengthMinimax, {0.6, 0.2, 0.7}), {0.634054102, 0.211351367, 0.739729786},
              1e-8);
  expect_near(normalize_fast(kInverseLengthCubic, {0, 0, 1}), {0, 0, 1});
  expect_near(normalize_fast(kInverseLengthCubic, {0.6, 0.2, 0.7}), {0.636201908, 0.212067303, 0.742235559});
  expect_near(normalize_fast(kInverseLengthCubic, {0.5, 0.5, 0}), {0.706747136, 0.706747136, 0});
  // Out of range: exact.
  expect_near(normalize_fast(paper, {0, 0.3, 0.4}), {0, 0.6, 0.8}, 1e-15);
  expect_near(normalize_fast(paper, {0, 3, 4}), {0, 0.6, 0.8}, 1e-15);
}

// Largest and last relative error of a polynomial over its range.
struct LengthErrors {
  double largest, at, low_end, flat;
};
LengthErrors length_errors(const InverseLength& polynomial) {
  constexpr int kSteps = 1000000;
  const auto error = [&](double k) { return inverse_length(polynomial, k) * std::sqrt(k) - 1; };
  LengthErrors e = {0, 0, error(polynomial.lowest), error(1)};
  for (int i = 0; i <= kSteps; ++i) {
    const double k = polynomial.lowest + (1 - polynomial.lowest) * i / kSteps;
    if (std::abs(error(k)) > e.largest) e = {std::abs(error(k)), k, e.low_end, e.flat};
  }
  return e;
}

TEST(normals_reference, errors_of_inverse_lengths) {
  const LengthErrors paper = length_errors(kInverseLengthPaper);
  EXPECT_NEAR(100 * paper.largest, 0.3509, 0.00005);
  EXPECT_NEAR(paper.at, 0.62128, 0.00001);
  EXPECT_NEAR(100 * paper.low_end, -0.3465, 0.00005);
  EXPECT_NEAR(100 * paper.flat, 0.3, 0.00005);
  const LengthErrors minimax = length_errors(kInverseLengthMinimax);
  EXPECT_NEAR(100 * minimax.largest, 0.3215, 0.00005);
  EXPECT_NEAR(100 * minimax.flat, 0.3215, 0.00005);
  const LengthErrors cubic = length_errors(kInverseLengthCubic);
  EXPECT_NEAR(100 * cubic.largest, 0.0544, 0.00005);
  EXPECT_EQ(cubic.flat, 0);
  for (const InverseLength* p : {&kInverseLengthPaper, &kInverseLengthMinimax, &kInverseLengthCubic}) {
    EXPECT_NEAR(length_errors(*p).largest, p->error, 0.000001);
    EXPECT_LT(std::abs(inverse_length(*p, kLargestSquare) * std::sqrt(kLargestSquare) - 1), p->error + 0.001);
  }
}

TEST(normals_reference, squared_lengths) {
  const auto after = [](Vec3d first, Vec3d step, int steps) {
    SquaredLengths k(first, step);
    for (int i = 0; i < steps; ++i) k.next();
    return k.value();
  };
  EXPECT_NEAR(after({0.6, 0, 0.8}, {-0.03, 0.03, 0}, 10), 0.82, 1e-12);
  EXPECT_NEAR(after({1, 0, 0}, {-0.01, 0.01, 0}, 50), 0.5, 1e-12);
  EXPECT_NEAR(after({0.36, 0.48, 0.8}, {0.002, -0.004, 0.001}, 100), 1.13, 1e-12);
}

TEST(normals_reference, mid_vector) {
  expect_near(mid_vector(kMidVectorPaper, {0, 0, 1}, {0, 0, 1}), {0, 0, 4.016});
  expect_near(mid_vector(kMidVectorPaper, {0, 0, 1}, {0.6, 0, 0.8}), {1.26268800, 0, 3.78806400});
  expect_near(mid_vector(kMidVectorPaper, {1, 0, 0}, {0, 1, 0}), {2.82, 2.82, 0});
}

TEST(normals_reference, errors_of_mid_vectors) {
  const auto largest = [](const MidVector& polynomial) {
    double error = 0;
    for (int i = 0; i <= 200000; ++i) {
      const double c = polynomial.lowest + (1 - polynomial.lowest) * i / 200000;
      const Vec3d middle = mid_vector(polynomial, {1, 0, 0}, {c, std::sqrt(1 - c * c), 0}) * 0.25;
      error = std::max(error, std::abs(length(middle) - 1));
    }
    return error;
  };
  EXPECT_NEAR(100 * largest(kMidVectorPaper), 0.4, 0.00005);
  EXPECT_NEAR(100 * largest(kMidVectorMinimax), 0.0039, 0.00005);
  EXPECT_NEAR(largest(kMidVectorPaper), kMidVectorPaper.error, 1e-6);
  EXPECT_NEAR(largest(kMidVectorMinimax), kMidVectorMinimax.error, 1e-6);
}

TEST(normals_reference, six_point_normal) {
  const Vec3d n[3] = {{0, 0, 1}, {0.6, 0, 0.8}, {0, 0.6, 0.8}};
  expect_near(six_point_normal(kMidVectorPaper, n, 0.5, 0.5), {0.315672, 0, 0.947016});
  expect_near(six_point_normal(kMidVectorPaper, n, 0.2, 0.3), {0.202246848, 0.324754368, 0.919385088});
  expect_near(six_point_normal(kMidVectorPaper, n, 1, 0), {0, 0, 1});
  // 120 degrees between two of them: linear, and unit.
  const Vec3d wide[3] = {{0, 0, 1}, {std::sqrt(0.75), 0, -0.5}, {0, 1, 0}};
  expect_near(six_point_normal(kMidVectorPaper, wide, 0.5, 0.5), {std::sqrt(0.75), 0, 0.5}, 1e-12);
}

// How far from unit the form gets between three vectors with equal angles: the specification's table.
TEST(normals_reference, lengths_of_six_point_normals) {
  const struct {
    double deg, low, high;
  } rows[] = {{5, 0, 0.508},   {15, 0, 0.315},    {30, -0.181, 0},
              {45, -0.694, 0}, {60, -1.42, 0.07}, {75, -3.71, 0.39}};
  for (const auto& row : rows) {
    SCOPED_TRACE(row.deg);
    // Three vectors at equal pairwise cosine c stand at polar cosine sqrt((1 + 2c) / 3).
    const double c = std::cos(row.deg * 3.14159265358979323846 / 180);
    const double z = std::sqrt((1 + 2 * c) / 3), r = std::sqrt(1 - z * z), h = std::sqrt(0.75);
    const Vec3d n[3] = {{r, 0, z}, {-r / 2, r * h, z}, {-r / 2, -r * h, z}};
    double low = 0, high = 0;
    constexpr int kSteps = 300;
    for (int i = 0; i <= kSteps; ++i) {
      for (int j = 0; i + j <= kSteps; ++j) {
        const double error =
            length(six_point_normal(kMidVectorPaper, n, double(i) / kSteps, double(j) / kSteps)) - 1;
        low = std::min(low, error);
        high = std::max(high, error);
      }
    }
    const double printed = row.deg < 50 ? 0.0006 : 0.006;  // printed to 3 and 2 digits
    EXPECT_NEAR(100 * low, row.low, printed);
    EXPECT_NEAR(100 * high, row.high, printed);
  }
}

}  // namespace
}  // namespace blysk::reference
