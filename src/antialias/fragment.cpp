#include "antialias/fragment.h"

#include <cmath>

namespace blysk::antialias {
namespace {

struct Interval {
  float low, high;
};

// Depths at all samples, wide enough for every rounding on the way to one.
Interval depths(const Fragment& f, const SamplePattern& pattern) {
  constexpr float kRoundings = 8 * 0x1p-24f;
  const float reach = pattern.reach_a * std::abs(f.zx) + pattern.reach_b * std::abs(f.zy);
  const float wide = reach + kRoundings * (std::abs(f.z) + reach);
  return {f.z - wide, f.z + wide};
}

}  // namespace

Mask visibility(const Fragment& g, const Fragment& f, const SamplePattern& pattern, bool ties) {
  Mask nearer = 0, equal = 0;
  for (std::size_t s = 0; s < pattern.count; ++s) {
    const float zg = depth_at(g, pattern, s), zf = depth_at(f, pattern, s);
    nearer |= static_cast<Mask>(zg < zf) << s;
    equal |= static_cast<Mask>(zg == zf) << s;
  }
  return ties ? nearer | equal : nearer;
}

Mask fast_visibility(const Fragment& g, const Fragment& f, const SamplePattern& pattern, bool ties) {
  const Interval of_g = depths(g, pattern), of_f = depths(f, pattern);
  if (of_g.high < of_f.low) return pattern.full();
  if (of_f.high < of_g.low) return 0;
  return visibility(g, f, pattern, ties);
}

}  // namespace blysk::antialias
