// math/row_normals.h - polynomials for unit vectors at equal angles between two unit vectors.
//
// Per-fragment paper, formulas (10) - (14); sections C.2 - C.4 of its specification. d is the cosine between
// the two vectors. Kernels take the coefficients as floats, the reference forms as they stand.
#pragma once

namespace blysk {

/// Rows of nine by Chebyshev polynomials: c is the cosine of an eighth of the angle, g the weight that leads
/// to the second vector. g is a polynomial of e, from_one ? 1 - c : c.
///
/// Max error: of the vectors' length, `length`, and of the whole vector, `vector`. Valid range: d in [0, 1].
struct ChebyshevRow {
  double c[4];  ///< from_one: c = 1 - (1 - d) * (c0 + ...), else c = c0 + ... in d
  double g[4];
  bool from_one;
  double length, vector;
};

/// As printed. Claimed: 0.005 % and 0.17 %; true of coefficients that are not rounded.
inline constexpr ChebyshevRow kChebyshevPaper = {
    {0.981, 0.023, -0.0042, 0}, {64.98, -127.27, 62.42, 0}, false, 0.0256, 0.0266};
/// Exact where both ends are equal, degree 2 and 3.
inline constexpr ChebyshevRow kChebyshevQuadratic = {
    {0.019158, -0.004098, 0, 0}, {0.125, 2.502592, 58.752466, 0}, true, 0.0018, 0.0029};
inline constexpr ChebyshevRow kChebyshevCubic = {
    {0.019209, -0.004967, 0.001492, 0}, {0.125, 2.640216, 34.674591, 921.236007}, true, 0.00024, 0.0003};

/// Weights of rows of nine: w_k = k / 8 + (1 - d) * (q0 + d * (q1 + d * (q2 + d * q3))).
/// Max error: 3.3e-4 (cubic), 6e-5 (quartic). Valid range: d in [0, 1].
using RowWeights = double[7][4];  // k = 1..7
inline constexpr RowWeights kRowWeightsCubic = {
    {0.069971, -0.048222, 0.021362}, {0.132460, -0.090307, 0.039875}, {0.180275, -0.120674, 0.052989},
    {0.206781, -0.134818, 0.058735}, {0.206162, -0.129773, 0.055957}, {0.173637, -0.104486, 0.044475},
    {0.105650, -0.060082, 0.025175}};
inline constexpr RowWeights kRowWeightsQuartic = {
    {0.070072, -0.051500, 0.035044, -0.013113}, {0.132650, -0.096413, 0.065354, -0.024419},
    {0.180526, -0.128757, 0.086717, -0.032322}, {0.207058, -0.143731, 0.095917, -0.035628},
    {0.206423, -0.138206, 0.091130, -0.033698}, {0.173843, -0.111132, 0.072187, -0.026544},
    {0.105765, -0.063806, 0.040697, -0.014865}};

/// Any point of an arc, from its middle: t runs from -1 to 1, z = (1 - d) / 2, e = 1 - t * t.
///
///   N = (B + A) * (1/2 + e * (E0 + e * E1)) + (B - A) * t * (1/2 + e * (O0 + e * O1))
///
/// E0 = z * (even[0] + ...), E1 = z * z * (even[4] + z * even[5]), O0 = z * (odd[0] + ...), O1 = z * z *
/// odd[3]. Both ends are exact, and everything is where they are equal. Found by tools/fit_arc.py. Max
/// error: 1.7e-4 of the vector, 2.7e-5 from d = 0.9 on. Valid range: d in [0, 1].
struct ArcFit {
  double even[6], odd[4];
};
inline constexpr ArcFit kArcFit = {
    {0.249209638, 0.193051281, -0.046176212, 0.471316157, 0.016458087, 0.050565914},
    {0.084105857, 0.023162808, 0.047013572, 0.006271409}};

/// At a larger angle an arc is halved first; nearly opposite vectors are no ends of an arc.
inline constexpr double kLowestArc = -0.95;

/// Rows of fewer pixels are not worth what their ends cost: every pixel has its own normal.
inline constexpr int kShortestArc = 16;

/// Half the sum of two unit vectors is at most 0.31 % short at cosines from here on: 9 degrees.
inline constexpr double kLowestHalfSum = 0.98769;

}  // namespace blysk
