#include "math/srgb.h"

namespace blysk {
namespace {

// t^(1/5) for t in 0.09..1 by Newton's method, which squares the start's relative error of 4% four times.
double fifth_root(double t) {
  double y = 0.5575 + (0.7707 - 0.3316 * t) * t;
  for (int i = 0; i < 4; ++i) y = (4 * y + t / (y * y * y * y)) / 5;
  return y;
}

}  // namespace

float srgb_to_linear(float code) {
  if (!(code > 0)) return 0;
  if (code >= 1) return 1;
  const double c = static_cast<double>(code);
  if (c <= 0.04045) return static_cast<float>(c / 12.92);
  // t^2.4 = t^2 (t^(1/5))^2
  const double t = (c + 0.055) / 1.055;
  const double r = t * fifth_root(t);
  return static_cast<float>(r * r);
}

}  // namespace blysk
