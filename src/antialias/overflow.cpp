#include "antialias/overflow.h"

#include <algorithm>
#include <array>

namespace blysk::antialias {
namespace {

constexpr std::array<std::string_view, 12> kNames = {"unlimited", "d1", "d2", "d3", "d4", "d5",
                                                     "m0",        "m1", "m2", "m3", "m4", "m5"};

MergedPlane plane_of(Overflow policy) {
  switch (policy) {
    case Overflow::m0:
      return MergedPlane::printed;
    case Overflow::m1:
      return MergedPlane::corrected;
    case Overflow::m3:
      return MergedPlane::larger;
    default:
      return MergedPlane::least_squares;
  }
}

// The cheapest pair of one opacity class; if there is none, of all. Of equal ones the last.
template <class Cost>
Pair cheapest(const FragmentList& list, std::size_t farthest_apart, const Cost& cost) {
  Pair best = {0, 1};
  double least = 0;
  bool found = false, alike = false;
  for (std::size_t i = 0; i < list.size; ++i) {
    for (std::size_t j = i + 1; j < list.size && j - i <= farthest_apart; ++j) {
      const bool same = list.at[i].opaque() == list.at[j].opaque();
      if (alike && !same) continue;
      const double c = cost(list.at[i], list.at[j]);
      if (found && same == alike && !(c <= least)) continue;
      best = {i, j};
      least = c;
      found = true;
      alike = same;
    }
  }
  return best;
}

}  // namespace

std::string_view overflow_name(Overflow overflow) { return kNames[static_cast<std::size_t>(overflow)]; }

std::optional<Overflow> overflow_of(std::string_view name) {
  for (const Overflow o : kOverflows) {
    if (overflow_name(o) == name) return o;
  }
  return std::nullopt;
}

void FragmentList::erase(std::size_t i) {
  std::copy(at + i + 1, at + size, at + i);
  --size;
}

void FragmentList::place(const Fragment& f) {
  std::size_t i = size;
  for (; i > 0 && at[i - 1].z > f.z; --i) at[i] = at[i - 1];
  at[i] = f;
  ++size;
}

std::size_t victim(const FragmentList& list, Overflow policy) {
  const bool by_depth = policy != Overflow::d2 && policy != Overflow::d4;
  std::size_t worst = 0;
  for (std::size_t i = 1; i < list.size; ++i) {
    const Fragment &a = list.at[worst], &b = list.at[i];
    const int ka = samples_in(a.mask), kb = samples_in(b.mask);
    const bool goes = by_depth ? b.z > a.z || (b.z == a.z && kb <= ka) : kb < ka || (kb == ka && b.z >= a.z);
    if (goes) worst = i;
  }
  return worst;
}

Pair pair_to_merge(const FragmentList& list, Overflow policy, const SamplePattern& pattern) {
  if (policy == Overflow::m3 || policy == Overflow::m4) {
    return cheapest(list, 1, [](const Fragment& a, const Fragment& b) { return double{b.z} - double{a.z}; });
  }
  if (policy == Overflow::m5) {
    return cheapest(list, list.size,
                    [&](const Fragment& a, const Fragment& b) { return ward_cost(a, b, pattern); });
  }
  return {list.size - 2, list.size - 1};
}

void merge_two(FragmentList& list, Overflow policy, const SamplePattern& pattern, std::size_t pixel,
               Colours* colours) {
  const Pair pair = pair_to_merge(list, policy, pattern);
  Fragment &a = list.at[pair.near], &b = list.at[pair.far];
  if (colours != nullptr) {
    colours->light(pixel, a);
    colours->light(pixel, b);
  }
  const Fragment merged = merge(a, b, plane_of(policy), pattern);
  list.erase(pair.far);
  list.erase(pair.near);
  list.place(merged);
}

}  // namespace blysk::antialias
