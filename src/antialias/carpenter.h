// antialias/carpenter.h - the classic A-buffer: masks, and of each fragment's depth only its extent.
//
// Based on: L. Carpenter. The A-buffer, an antialiased hidden surface method. 1984. Kept to compare with:
// where surfaces meet or cross, extents of depth cannot tell what is seen.
#pragma once

#include <span>

#include "antialias/fragment_tile.h"
#include "antialias/growing_lists.h"

namespace blysk::antialias {

struct CarpenterFragment {
  Mask mask = 0;
  Vec3f rgb;
  float opacity = 1;
  float nearest = 0, farthest = 0;  ///< extent of depth (Zmin, Zmax)
  std::uint32_t object = 0;
};

/// The visible share of `front` where the extents of depth of two fragments overlap.
[[nodiscard]] double visible_share(const CarpenterFragment& front, const CarpenterFragment& next);

/// Weights of the front fragment, the next one, and what is behind both.
struct FrontWeights {
  double front, next, behind;
};
[[nodiscard]] FrontWeights front_weights(const CarpenterFragment& front, const CarpenterFragment& next);

/// The list as a colour: Carpenter's recursive packing.
[[nodiscard]] Composed pack(std::span<const CarpenterFragment> list, const SamplePattern& pattern);

class CarpenterLists final : public FragmentTile {
 public:
  explicit CarpenterLists(const SamplePattern& pattern) : pattern_(&pattern) {}

  void clear(std::size_t pixels) override;
  /// Colours are taken at once: fragments of one object may be merged.
  void insert(std::size_t pixel, const Fragment& fragment) override;
  [[nodiscard]] Composed compose(std::size_t pixel) override;
  [[nodiscard]] std::size_t live(std::size_t pixel) const override { return lists_.size(pixel); }
  [[nodiscard]] std::size_t bytes() const override { return lists_.bytes(); }

  /// In ascending order of the nearest depth.
  [[nodiscard]] std::span<const CarpenterFragment> fragments(std::size_t pixel) {
    return lists_.items(pixel);
  }

 private:
  const SamplePattern* pattern_;
  GrowingLists<CarpenterFragment> lists_;
};

}  // namespace blysk::antialias
