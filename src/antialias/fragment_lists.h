// antialias/fragment_lists.h - the A-buffer with visibility masks: lists without a limit, or of N fragments.
#pragma once

#include <span>

#include "antialias/fragment_tile.h"
#include "antialias/growing_lists.h"

namespace blysk::antialias {

struct FragmentListOptions {
  const SamplePattern* pattern = &kGrid16;
  Overflow overflow = Overflow::unlimited;
  std::size_t most = 8;  ///< fragments a pixel, at least 1; not for Overflow::unlimited
  Tie tie = Tie::existing;
};

class FragmentLists final : public FragmentTile {
 public:
  explicit FragmentLists(const FragmentListOptions& options);

  void clear(std::size_t pixels) override;
  void insert(std::size_t pixel, const Fragment& fragment) override;
  [[nodiscard]] Composed compose(std::size_t pixel) override;
  [[nodiscard]] std::size_t live(std::size_t pixel) const override { return lists_.size(pixel); }
  [[nodiscard]] std::size_t bytes() const override;

  /// In ascending z.
  [[nodiscard]] std::span<const Fragment> fragments(std::size_t pixel) { return lists_.items(pixel); }

 private:
  void overflow(std::size_t pixel, FragmentList& list);
  [[nodiscard]] bool shows_before_drop() const {
    return options_.overflow == Overflow::d3 || options_.overflow == Overflow::d4;
  }

  // What d3 and d4 show, and for d5 whether anything was dropped.
  struct Memory {
    Composed shown;
    bool dropped = false;
  };

  FragmentListOptions options_;
  GrowingLists<Fragment> lists_;
  Resolver resolver_;
  std::vector<Memory> memory_;
};

}  // namespace blysk::antialias
