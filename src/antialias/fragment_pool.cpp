#include "antialias/fragment_pool.h"

namespace blysk::antialias {

FragmentPool::FragmentPool(const FragmentPoolOptions& options)
    : options_(options), resolver_(*options.pattern) {}

void FragmentPool::clear(std::size_t pixels) {
  main_.resize(pixels * options_.main);
  addresses_.resize(pixels * options_.extra);
  sizes_.assign(pixels, 0);
  slots_.resize(options_.pool);
  for (std::size_t i = 0; i < slots_.size(); ++i) slots_[i].id = static_cast<std::uint32_t>(i + 1);
  first_free_ = 0;
  free_count_ = slots_.size();
  statistics_ = {};
}

std::size_t FragmentPool::read(std::size_t pixel, Fragment* to) const {
  const std::size_t size = sizes_[pixel], in_main = std::min(size, options_.main);
  std::copy_n(main_.begin() + static_cast<std::ptrdiff_t>(pixel * options_.main), in_main, to);
  for (std::size_t i = in_main; i < size; ++i) {
    to[i] = slots_[addresses_[pixel * options_.extra + i - options_.main]];
  }
  return size;
}

void FragmentPool::write(std::size_t pixel, const FragmentList& list) {
  std::uint32_t* const addresses = addresses_.data() + pixel * options_.extra;
  const std::size_t had = slots_owned(pixel), needed = owned(list.size);
  for (std::size_t i = had; i < needed; ++i) {
    addresses[i] = first_free_;
    first_free_ = slots_[first_free_].id;
    --free_count_;
  }
  for (std::size_t i = had; i > needed; --i) {
    slots_[addresses[i - 1]].id = first_free_;
    first_free_ = addresses[i - 1];
    ++free_count_;
  }
  const std::size_t in_main = list.size - needed;
  std::copy_n(list.at, in_main, main_.begin() + static_cast<std::ptrdiff_t>(pixel * options_.main));
  for (std::size_t i = 0; i < needed; ++i) slots_[addresses[i]] = list.at[in_main + i];
  sizes_[pixel] = static_cast<std::uint8_t>(list.size);
  statistics_.pool_used = slots_.size() - free_count_;
  statistics_.pool_peak = std::max(statistics_.pool_peak, statistics_.pool_used);
}

void FragmentPool::insert(std::size_t pixel, const Fragment& fragment) {
  if (fragment.mask == 0 || !(fragment.alpha > 0)) return;
  ++statistics_.generated;
  Copy copy;
  FragmentList list = {copy.data(), read(pixel, copy.data())};
  Fragment f = fragment;
  const Hidden hidden = hide(list, f, *options_.pattern, options_.tie);
  statistics_.removed_later += hidden.removed;
  statistics_.live -= hidden.removed;
  if (hidden.arrival) {
    ++statistics_.hidden_on_arrival;
    if (hidden.changed) write(pixel, list);
    return;
  }
  list.place(f);
  if (fits(pixel, list.size)) {
    ++statistics_.live;
  } else {
    merge_two(list, options_.overflow, *options_.pattern, pixel, colours_);
    ++statistics_.overflowed;
  }
  write(pixel, list);
  statistics_.most_live = std::max<std::uint64_t>(statistics_.most_live, list.size);
}

std::vector<Fragment> FragmentPool::fragments(std::size_t pixel) const {
  Copy copy;
  const std::size_t size = read(pixel, copy.data());
  return {copy.begin(), copy.begin() + static_cast<std::ptrdiff_t>(size)};
}

Composed FragmentPool::compose(std::size_t pixel) {
  Copy copy;
  const std::size_t size = read(pixel, copy.data());
  light(pixel, copy.data(), size);
  return resolver_.compose({copy.data(), size});
}

bool FragmentPool::sound() const {
  std::vector<bool> seen(slots_.size());
  std::size_t counted = 0;
  const auto see = [&](std::size_t slot) {
    if (slot >= seen.size() || seen[slot]) return false;
    seen[slot] = true;
    ++counted;
    return true;
  };
  std::uint32_t slot = first_free_;
  for (std::size_t i = 0; i < free_count_; ++i, slot = slots_[slot].id) {
    if (!see(slot)) return false;
  }
  for (std::size_t pixel = 0; pixel < sizes_.size(); ++pixel) {
    if (sizes_[pixel] > options_.main + options_.extra) return false;
    for (std::size_t i = 0; i < slots_owned(pixel); ++i) {
      if (!see(addresses_[pixel * options_.extra + i])) return false;
    }
  }
  return counted == slots_.size() && statistics_.pool_used + free_count_ == slots_.size();
}

std::size_t FragmentPool::bytes() const {
  return (main_.capacity() + slots_.capacity()) * sizeof(Fragment) +
         addresses_.capacity() * sizeof(std::uint32_t) + sizes_.capacity();
}

}  // namespace blysk::antialias
