#include "antialias/carpenter.h"

#include <algorithm>
#include <array>

namespace blysk::antialias {
namespace {

CarpenterFragment of(const Fragment& f, const SamplePattern& pattern) {
  CarpenterFragment c = {.mask = f.mask, .rgb = f.rgb, .opacity = f.alpha, .object = f.object};
  c.nearest = c.farthest = depth_at(f, pattern, static_cast<std::size_t>(std::countr_zero(f.mask)));
  for (Mask left = f.mask; left != 0; left &= left - 1) {
    const float z = depth_at(f, pattern, static_cast<std::size_t>(std::countr_zero(left)));
    c.nearest = std::min(c.nearest, z);
    c.farthest = std::max(c.farthest, z);
  }
  return c;
}

bool hides_all_behind(const CarpenterFragment& f, const SamplePattern& pattern) {
  return f.mask == pattern.full() && f.opacity >= 1;
}

// Samples in common would be a fold of the object: such fragments stay apart.
bool belong_together(const CarpenterFragment& a, const CarpenterFragment& b) {
  return a.object == b.object && (a.mask & b.mask) == 0 && a.nearest <= b.farthest && b.nearest <= a.farthest;
}

CarpenterFragment together(const CarpenterFragment& a, const CarpenterFragment& b) {
  const auto ka = static_cast<float>(samples_in(a.mask)), kb = static_cast<float>(samples_in(b.mask));
  const float share = 1 / (ka + kb);
  return {.mask = a.mask | b.mask,
          .rgb = (a.rgb * ka + b.rgb * kb) * share,
          .opacity = a.opacity == b.opacity ? a.opacity : (a.opacity * ka + b.opacity * kb) * share,
          .nearest = std::min(a.nearest, b.nearest),
          .farthest = std::max(a.farthest, b.farthest),
          .object = a.object};
}

// Samples whose colour is still to be found from fragment `first` on, and how much of it they show.
struct Search {
  std::size_t first;
  Mask mask;
  double weight;
};

}  // namespace

double visible_share(const CarpenterFragment& front, const CarpenterFragment& next) {
  const double depth =
      (double{front.farthest} - double{front.nearest}) + (double{next.farthest} - double{next.nearest});
  if (!(depth > 0)) return 1;
  return std::clamp((double{next.farthest} - double{front.nearest}) / depth, 0.0, 1.0);
}

FrontWeights front_weights(const CarpenterFragment& front, const CarpenterFragment& next) {
  const double share = visible_share(front, next), of = double{front.opacity}, on = double{next.opacity};
  return {share * of + (1 - share) * (1 - on) * of, (1 - share) * on + share * (1 - of) * on,
          (1 - of) * (1 - on)};
}

Composed pack(std::span<const CarpenterFragment> list, const SamplePattern& pattern) {
  // The recursion is linear in what it finds, so a stack will do. Its masks are disjoint and not empty: there
  // are no more of them than samples.
  std::array<Search, kMostSamples + 1> stack;
  std::size_t depth = 0;
  const auto search = [&](std::size_t first, Mask mask, double weight) {
    if (mask != 0 && weight > 0) stack[depth++] = {first, mask, weight};
  };
  Composed sum = {{}, 0};
  const auto add = [&](Vec3f rgb, double weight) { sum.rgb = sum.rgb + to_double(rgb) * weight; };

  search(0, pattern.full(), 1);
  while (depth > 0) {
    auto [i, mask, weight] = stack[--depth];
    while (i < list.size() && (list[i].mask & mask) == 0) ++i;
    if (i == list.size()) {
      sum.background += weight * samples_in(mask);
      continue;
    }
    const CarpenterFragment& front = list[i];
    search(i + 1, mask & ~front.mask, weight);
    Mask inside = mask & front.mask;
    std::size_t n = i + 1;
    while (n < list.size() && (list[n].mask & inside) == 0) ++n;
    if (n < list.size() && front.farthest > list[n].nearest) {
      search(i, inside & ~list[n].mask, weight);
      inside &= list[n].mask;
      const FrontWeights w = front_weights(front, list[n]);
      const double area = weight * samples_in(inside);
      add(front.rgb, w.front * area);
      add(list[n].rgb, w.next * area);
      search(n + 1, inside, weight * w.behind);
    } else {
      const double opacity = double{front.opacity};
      add(front.rgb, opacity * weight * samples_in(inside));
      search(i + 1, inside, weight * (1 - opacity));
    }
  }
  const double share = 1.0 / static_cast<double>(pattern.count);
  return {sum.rgb * share, sum.background * share};
}

void CarpenterLists::clear(std::size_t pixels) {
  lists_.clear(pixels, 4);
  statistics_ = {};
}

void CarpenterLists::insert(std::size_t pixel, const Fragment& fragment) {
  if (fragment.mask == 0 || !(fragment.alpha > 0)) return;
  ++statistics_.generated;
  CarpenterFragment* const list = lists_.with_room(pixel);
  std::size_t size = lists_.size(pixel);
  CarpenterFragment f = of(fragment, *pattern_);
  for (std::size_t i = 0; i < size; ++i) {
    if (hides_all_behind(list[i], *pattern_) && list[i].farthest < f.nearest) {
      ++statistics_.hidden_on_arrival;
      return;
    }
  }
  if (!fragment.lit && colours_ != nullptr) f.rgb = colours_->colour(pixel, fragment);
  statistics_.live += 1;
  for (std::size_t i = 0; i < size;) {
    if (belong_together(list[i], f)) {
      f = together(list[i], f);
      ++statistics_.overflowed;
      std::copy(list + i + 1, list + size, list + i);
      --size;
      --statistics_.live;
      i = 0;  // its depths are wider now: an earlier one may belong to it
    } else {
      ++i;
    }
  }
  if (hides_all_behind(f, *pattern_)) {
    CarpenterFragment* const end =
        std::remove_if(list, list + size, [&](const auto& g) { return g.nearest > f.farthest; });
    const auto kept = static_cast<std::size_t>(end - list);
    statistics_.removed_later += size - kept;
    statistics_.live -= size - kept;
    size = kept;
  }
  std::size_t place = size;
  for (; place > 0 && list[place - 1].nearest > f.nearest; --place) list[place] = list[place - 1];
  list[place] = f;
  lists_.set_size(pixel, ++size);
  statistics_.most_live = std::max<std::uint64_t>(statistics_.most_live, size);
}

Composed CarpenterLists::compose(std::size_t pixel) { return pack(lists_.items(pixel), *pattern_); }

}  // namespace blysk::antialias
