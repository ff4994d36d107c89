// antialias/growing_lists.h - many short lists in one block of memory that is kept from use to use.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace blysk::antialias {

/// Each list is contiguous; a full one moves to a place of twice its size, and the place it leaves is used
/// again. Allocation stops once the largest use has been seen.
template <class T>
class GrowingLists {
 public:
  /// All lists empty, each with room for `capacity`, at least 1.
  void clear(std::size_t lists, std::size_t capacity) {
    first_capacity_ = capacity;
    lists_.assign(lists, {});
    for (std::size_t i = 0; i < lists; ++i) lists_[i].first = i * capacity;
    used_ = lists * capacity;
    if (memory_.size() < used_) memory_.resize(used_);
    for (auto& places : left_) places.clear();
  }

  [[nodiscard]] std::size_t lists() const { return lists_.size(); }
  [[nodiscard]] std::size_t size(std::size_t list) const { return lists_[list].size; }
  [[nodiscard]] std::span<T> items(std::size_t list) {
    return {memory_.data() + lists_[list].first, lists_[list].size};
  }

  /// The items, with memory for one more behind them.
  [[nodiscard]] T* with_room(std::size_t list) {
    if (lists_[list].size == first_capacity_ << lists_[list].doublings) grow(list);
    return memory_.data() + lists_[list].first;
  }
  void set_size(std::size_t list, std::size_t size) { lists_[list].size = static_cast<std::uint32_t>(size); }

  [[nodiscard]] std::size_t bytes() const {
    return memory_.capacity() * sizeof(T) + lists_.capacity() * sizeof(List);
  }

 private:
  struct List {
    std::size_t first = 0;
    std::uint32_t size = 0, doublings = 0;
  };

  void grow(std::size_t list) {
    List& l = lists_[list];
    const std::size_t old = l.first;
    left_.resize(std::max<std::size_t>(left_.size(), l.doublings + 2));
    auto& larger = left_[l.doublings + 1];
    if (larger.empty()) {
      l.first = used_;
      used_ += first_capacity_ << (l.doublings + 1);
      if (memory_.size() < used_) memory_.resize(std::max(used_, 2 * memory_.size()));
    } else {
      l.first = larger.back();
      larger.pop_back();
    }
    std::copy_n(memory_.data() + old, l.size, memory_.data() + l.first);
    left_[l.doublings].push_back(old);
    ++l.doublings;
  }

  std::vector<T> memory_;
  std::vector<List> lists_;
  std::vector<std::vector<std::size_t>> left_;  ///< places without a list, by doublings
  std::size_t first_capacity_ = 1, used_ = 0;
};

}  // namespace blysk::antialias
