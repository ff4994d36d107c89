// antialias/resolve.h - from the fragments of a pixel to its colour.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "antialias/fragment.h"

namespace blysk::antialias {

/// What is shown of samples that no fragment covers.
enum class Uncovered {
  background,
  left_out  ///< the covered samples stand for the whole pixel
};

/// A pixel's colour before it is known what stands behind.
struct Composed {
  Vec3d rgb;
  double background = 1;  ///< share of the pixel that shows it

  [[nodiscard]] Vec3d over(Vec3d behind) const { return rgb + behind * background; }
};

/// Composes fragments per sample, front to back. Keeps its working memory from pixel to pixel.
class Resolver {
 public:
  explicit Resolver(const SamplePattern& pattern) : pattern_(&pattern) {}

  /// Of lit fragments in any order. Opaque masks must be disjoint.
  [[nodiscard]] Composed compose(std::span<const Fragment> fragments,
                                 Uncovered uncovered = Uncovered::background);

 private:
  struct Layer {
    float z;
    std::uint32_t id;
    const Fragment* fragment;
  };
  void add_sample(std::span<const Fragment> fragments, std::size_t sample, Composed& sum);

  const SamplePattern* pattern_;
  std::vector<Layer> layers_;
};

}  // namespace blysk::antialias
