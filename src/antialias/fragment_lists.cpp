#include "antialias/fragment_lists.h"

namespace blysk::antialias {

FragmentLists::FragmentLists(const FragmentListOptions& options)
    : options_(options), resolver_(*options.pattern) {}

void FragmentLists::clear(std::size_t pixels) {
  constexpr std::size_t kUsual = 4;
  lists_.clear(pixels, options_.overflow == Overflow::unlimited ? kUsual : options_.most + 1);
  memory_.assign(shows_before_drop() || options_.overflow == Overflow::d5 ? pixels : 0, {});
  statistics_ = {};
}

void FragmentLists::insert(std::size_t pixel, const Fragment& fragment) {
  if (fragment.mask == 0 || !(fragment.alpha > 0)) return;
  ++statistics_.generated;
  Fragment f = fragment;
  FragmentList list = {lists_.with_room(pixel), lists_.size(pixel)};
  const Hidden hidden = hide(list, f, *options_.pattern, options_.tie);
  statistics_.removed_later += hidden.removed;
  statistics_.live -= hidden.removed;
  if (hidden.arrival) {
    ++statistics_.hidden_on_arrival;
  } else {
    list.place(f);
    ++statistics_.live;
    if (options_.overflow != Overflow::unlimited) overflow(pixel, list);
    statistics_.most_live = std::max<std::uint64_t>(statistics_.most_live, list.size);
  }
  lists_.set_size(pixel, list.size);
}

void FragmentLists::overflow(std::size_t pixel, FragmentList& list) {
  if (shows_before_drop()) {
    light(pixel, list.at, list.size);
    memory_[pixel].shown = resolver_.compose({list.at, list.size});
  }
  if (list.size <= options_.most) return;
  ++statistics_.overflowed;
  --statistics_.live;
  if (merges(options_.overflow)) {
    merge_two(list, options_.overflow, *options_.pattern, pixel, colours_);
    return;
  }
  list.erase(victim(list, options_.overflow));
  if (options_.overflow == Overflow::d5) memory_[pixel].dropped = true;
}

Composed FragmentLists::compose(std::size_t pixel) {
  if (shows_before_drop()) return memory_[pixel].shown;
  const std::span<Fragment> list = lists_.items(pixel);
  light(pixel, list.data(), list.size());
  const bool whole = options_.overflow == Overflow::d5 && memory_[pixel].dropped;
  return resolver_.compose(list, whole ? Uncovered::left_out : Uncovered::background);
}

std::size_t FragmentLists::bytes() const { return lists_.bytes() + memory_.capacity() * sizeof(Memory); }

}  // namespace blysk::antialias
