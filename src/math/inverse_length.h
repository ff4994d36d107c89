// math/inverse_length.h - polynomials that make a nearly unit vector unit, without root or division.
//
// Relief thesis, formula (1) and the mid-edge vectors of its quadratic form. Kernels take the coefficients as
// floats, the reference forms as they stand.
#pragma once

namespace blysk {

/// p = c0 + t * (c1 + t * (c2 + t * c3)), t = K - origin, K the squared length.
/// Max error: |p sqrt(K) - 1| <= error. Valid range: K in [lowest, kLargestSquare] (at the upper end, where
/// only rounding leads, the error of K = 1 and 0.1 % more).
struct InverseLength {
  double origin;
  double c[4];
  double lowest;
  double error;
};

inline constexpr double kLargestSquare = 1.005;

/// As printed. Claimed: 0.36 %.
inline constexpr InverseLength kInverseLengthPaper = {0, {2.227, -2.046, 0.822, 0}, 0.499, 0.003509};
/// The same degree and range with the smallest possible error: tools/fit_inverse_length.py.
inline constexpr InverseLength kInverseLengthMinimax = {
    0, {2.235089530, -2.069099669, 0.837225114, 0}, 0.499, 0.003215};
/// Exact at K = 1, where flat surfaces lie: highlights keep their brightness. Minimax under that condition.
inline constexpr InverseLength kInverseLengthCubic = {
    1, {1, -0.520556118, 0.152987224, -0.919755255}, 0.499, 0.000544};

/// |a + b| / 2 of unit vectors at cosine c is sqrt((1 + c) / 2), so that (a + b) * (q0 + c * (q1 + c * q2))
/// is nearly unit. Max error: `error` of the length. Valid range: c in [lowest, 1].
struct MidVector {
  double q[3];
  double lowest;
  double error;
};

/// As printed, for angles up to 90 degrees. Claimed: 0.36 %.
inline constexpr MidVector kMidVectorPaper = {{0.705, -0.306, 0.103}, 0, 0.004000};
/// Minimax for angles up to 45 degrees.
inline constexpr MidVector kMidVectorMinimax = {
    {0.680796344, -0.237716584, 0.056939606}, 0.70710678118654752, 0.000039};

}  // namespace blysk
