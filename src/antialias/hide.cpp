// Hidden surfaces inside a pixel, sample by sample.
#include <cmath>

#include "antialias/fragment_tile.h"

namespace blysk::antialias {
namespace {

bool stored_wins_ties(const Fragment& stored, const Fragment& arriving, Tie tie) {
  return tie == Tie::existing || (tie == Tie::lower_id && stored.id < arriving.id);
}

// Depths at all samples, wide enough for every rounding on the way to one.
struct Interval {
  float low, high;
};

Interval depths(const Fragment& f, const SamplePattern& pattern) {
  constexpr float kRoundings = 8 * 0x1p-24f;
  const float reach = pattern.reach_a * std::abs(f.zx) + pattern.reach_b * std::abs(f.zy);
  const float wide = reach + kRoundings * (std::abs(f.z) + reach);
  return {f.z - wide, f.z + wide};
}

}  // namespace

Hidden hide(FragmentList& list, Fragment& f, const SamplePattern& pattern, Tie tie) {
  Hidden result;
  const Interval of_f = depths(f, pattern);
  for (std::size_t i = 0; i < list.size; ++i) {
    Fragment& g = list.at[i];
    const Mask both = f.mask & g.mask;
    if (both == 0 || (!f.opaque() && !g.opaque())) continue;
    const Interval of_g = depths(g, pattern);
    const Mask g_nearer = of_g.high < of_f.low   ? both
                          : of_f.high < of_g.low ? 0
                                                 : visibility(g, f, pattern, stored_wins_ties(g, f, tie));
    if (g.opaque()) f.mask &= ~(both & g_nearer);
    if (f.opaque() && (both & ~g_nearer) != 0) {
      g.mask &= ~(both & ~g_nearer);
      result.changed = true;
    }
    if (f.mask == 0) break;
  }
  result.arrival = f.mask == 0;
  if (!result.changed) return result;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < list.size; ++i) {
    if (list.at[i].mask == 0) continue;
    if (kept != i) list.at[kept] = list.at[i];
    ++kept;
  }
  result.removed = list.size - kept;
  list.size = kept;
  return result;
}

}  // namespace blysk::antialias
