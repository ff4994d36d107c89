// io/share_equal.h - one number for things that are equal and stand near each other.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "blysk/array.h"
#include "core/threads.h"

namespace blysk::io {

inline constexpr std::size_t kSharingBlock = std::size_t{3}
                                             << 16;  ///< things that may share; a multiple of three

/// The things met last: two places for each hash, the newer one first.
template <class Key>
class RecentKeys {
 public:
  /// Makes room for what is worth remembering of so many things.
  void forget(std::size_t things) {
    bits_ = std::clamp(static_cast<int>(std::bit_width(things)), kLeastBits, kMostBits);
    slots_.assign(std::size_t{1} << bits_, {{}, kFree});
  }

  /// The number of the thing, which is `next` if it is new here.
  std::uint32_t find(const Key& key, std::uint32_t next) {
    const auto at = static_cast<std::size_t>(key.hash() >> (64 - bits_));
    Slot& first = slots_[at];
    if (first.key == key && first.number != kFree) return first.number;
    Slot& second = slots_[at ^ 1];
    if (second.key == key && second.number != kFree) return second.number;
    second = first;
    first = {key, next};
    return next;
  }

 private:
  static constexpr int kLeastBits = 6;
  static constexpr int kMostBits = 15;  // half a megabyte of points: within a core's second cache
  static constexpr std::uint32_t kFree = 0xffffffff;
  struct Slot {
    Key key;
    std::uint32_t number;
  };
  std::vector<Slot> slots_;
  int bits_ = kLeastBits;
};

template <class Key>
struct SharedKeys {
  std::vector<Array<Key>> runs;    ///< the different things in the order of first appearance
  std::vector<std::size_t> first;  ///< number of each run's first thing, and of all things together
  Array<std::uint32_t> ids;        ///< for every thing its number

  [[nodiscard]] std::size_t count() const { return first.back(); }
};

/// Numbers `count` things, at most 2^32 - 2. `each(begin, end, take)` calls take(Key) for the things from
/// begin to end in their order, from any thread; kSharingBlock divides `begin`. Equal things get one number
/// where few others stand between them, which keeps to memory that is near: most corners of a mesh share so
/// whatever it is, those far apart may get a number each. Key has == and hash(), whose highest bits count.
/// The result does not depend on the number of threads. Cost: linear whatever the things.
template <class Key, class Each>
[[nodiscard]] SharedKeys<Key> share_equal(std::size_t count, const Each& each, ThreadPool& pool) {
  const std::size_t blocks = (count + kSharingBlock - 1) / kSharingBlock;
  const auto begin_of = [&](std::size_t block) { return std::min(count, block * kSharingBlock); };
  SharedKeys<Key> shared;
  shared.ids.resize(count);
  shared.runs.resize(blocks);
  std::vector<RecentKeys<Key>> recent(static_cast<std::size_t>(pool.size()));
  pool.for_each(blocks, [&](int worker, std::size_t block) {
    RecentKeys<Key>& known = recent[static_cast<std::size_t>(worker)];
    known.forget(begin_of(block + 1) - begin_of(block));
    Array<Key> run;
    run.reserve(begin_of(block + 1) - begin_of(block));
    std::uint32_t* id = shared.ids.data() + begin_of(block);
    each(begin_of(block), begin_of(block + 1), [&](const Key& key) {
      const auto next = static_cast<std::uint32_t>(run.size());
      *id = known.find(key, next);
      if (*id++ == next) run.push_back(key);
    });
    shared.runs[block] = std::move(run);
  });

  shared.first.resize(blocks + 1);
  for (std::size_t block = 0; block < blocks; ++block)
    shared.first[block + 1] = shared.first[block] + shared.runs[block].size();
  pool.for_each(blocks, [&](int, std::size_t block) {
    const auto base = static_cast<std::uint32_t>(shared.first[block]);
    for (std::size_t i = begin_of(block); i < begin_of(block + 1); ++i) shared.ids[i] += base;
  });
  return shared;
}

}  // namespace blysk::io
