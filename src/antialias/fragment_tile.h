// antialias/fragment_tile.h - the fragments of a tile's pixels, whatever the variant of the A-buffer.
//
//   FragmentLists lists(options);
//   lists.clear(64 * 64);
//   for each fragment in submission order: lists.insert(pixel, fragment);
//   for each pixel: lists.resolve(pixel, background);
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "antialias/fragment.h"
#include "antialias/overflow.h"
#include "antialias/resolve.h"
#include "blysk/vector.h"

namespace blysk::antialias {

struct ListStatistics {
  std::uint64_t generated = 0;          ///< fragments that were inserted
  std::uint64_t hidden_on_arrival = 0;  ///< of these: wholly behind what was there
  std::uint64_t removed_later = 0;      ///< wholly hidden by one that came after
  std::uint64_t overflowed = 0;         ///< discarded, or merged with another
  std::uint64_t most_live = 0;          ///< in one pixel at one time
  std::uint64_t live = 0;               ///< now
  std::uint64_t pool_used = 0;          ///< slots of the common pool now
  std::uint64_t pool_peak = 0;          ///< and at most

  /// Of tiles that were worked on one after another, or side by side.
  ListStatistics& operator+=(const ListStatistics& o) {
    generated += o.generated;
    hidden_on_arrival += o.hidden_on_arrival;
    removed_later += o.removed_later;
    overflowed += o.overflowed;
    most_live = std::max(most_live, o.most_live);
    live += o.live;
    pool_used += o.pool_used;
    pool_peak += o.pool_peak;
    return *this;
  }
};

class FragmentTile {
 public:
  virtual ~FragmentTile() = default;

  /// Forgets fragments and statistics.
  virtual void clear(std::size_t pixels) = 0;
  /// Fragments of one pixel come in submission order. One without samples or opacity is ignored.
  virtual void insert(std::size_t pixel, const Fragment& fragment) = 0;
  [[nodiscard]] virtual Composed compose(std::size_t pixel) = 0;
  [[nodiscard]] Vec3d resolve(std::size_t pixel, Vec3d background) { return compose(pixel).over(background); }

  [[nodiscard]] virtual std::size_t live(std::size_t pixel) const = 0;
  /// Held at present, working memory included.
  [[nodiscard]] virtual std::size_t bytes() const = 0;
  [[nodiscard]] const ListStatistics& statistics() const { return statistics_; }

  /// Where the colours of fragments come from that are not lit when they are inserted.
  void set_colours(Colours* colours) { colours_ = colours; }

 protected:
  void light(std::size_t pixel, Fragment* fragments, std::size_t count) const {
    if (colours_ == nullptr) return;
    for (std::size_t i = 0; i < count; ++i) colours_->light(pixel, fragments[i]);
  }

  ListStatistics statistics_;
  Colours* colours_ = nullptr;
};

/// Hides what an arriving fragment and a list hide of each other, before the fragment is placed in it.
struct Hidden {
  bool arrival = false;     ///< nothing is left of the fragment; it is not to be placed
  bool changed = false;     ///< stored fragments lost samples
  std::size_t removed = 0;  ///< stored fragments that lost all
};
[[nodiscard]] Hidden hide(FragmentList& list, Fragment& fragment, const SamplePattern& pattern, Tie tie);

}  // namespace blysk::antialias
