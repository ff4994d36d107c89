#include "math/trig.h"

#include <cmath>

namespace blysk {
namespace {

// pi/2 in two parts, so that the reduction keeps its digits.
constexpr double kHalfPiHigh = 1.5707963267341256;  // 33 bits
constexpr double kHalfPiLow = 6.077100506506192e-11;

// Taylor on [-pi/4, pi/4]: the first term left out is below 2e-17 (sine) and 1e-18 (cosine).
double sine_core(double x) {
  const double q = x * x;
  double s = 1.0 / 355687428096000.0;
  s = s * q - 1.0 / 1307674368000.0;
  s = s * q + 1.0 / 6227020800.0;
  s = s * q - 1.0 / 39916800.0;
  s = s * q + 1.0 / 362880.0;
  s = s * q - 1.0 / 5040.0;
  s = s * q + 1.0 / 120.0;
  s = s * q - 1.0 / 6.0;
  return x + x * q * s;
}

double cosine_core(double x) {
  const double q = x * x;
  double c = 1.0 / 20922789888000.0;
  c = c * q - 1.0 / 87178291200.0;
  c = c * q + 1.0 / 479001600.0;
  c = c * q - 1.0 / 3628800.0;
  c = c * q + 1.0 / 40320.0;
  c = c * q - 1.0 / 720.0;
  c = c * q + 1.0 / 24.0;
  return 1.0 - 0.5 * q + q * q * c;
}

struct Reduced {
  double x;
  long long quadrant;
};

Reduced reduce(double radians) {
  const double turns = radians * (2.0 / kPi);
  const long long k = static_cast<long long>(turns < 0 ? turns - 0.5 : turns + 0.5);
  const double kd = static_cast<double>(k);
  return {(radians - kd * kHalfPiHigh) - kd * kHalfPiLow, k & 3};
}

}  // namespace

double sine(double radians) {
  const Reduced r = reduce(radians);
  const double v = (r.quadrant & 1) != 0 ? cosine_core(r.x) : sine_core(r.x);
  return r.quadrant >= 2 ? -v : v;
}

double cosine(double radians) {
  const Reduced r = reduce(radians);
  const double v = (r.quadrant & 1) != 0 ? sine_core(r.x) : cosine_core(r.x);
  return r.quadrant == 1 || r.quadrant == 2 ? -v : v;
}

double arc_tangent(double v) {
  if (v < 0) return -arc_tangent(-v);
  if (v > 1) return kPi / 2 - arc_tangent(1 / v);
  // Two halvings of the angle bring the argument below 0.2, where the series is short.
  for (int i = 0; i < 2; ++i) v = v / (1 + std::sqrt(1 + v * v));
  const double q = v * v;
  double s = 0;
  for (int k = 25; k >= 1; k -= 2) s = 1.0 / k - q * s;
  return 4 * v * s;
}

double tangent(double radians) { return sine(radians) / cosine(radians); }

}  // namespace blysk
