#include "antialias/resolve.h"

#include <algorithm>

namespace blysk::antialias {
namespace {

// Where each sample shows one colour.
Composed opaque(std::span<const Fragment> fragments, int samples, Uncovered uncovered) {
  Vec3d sum;
  int covered = 0;
  for (const Fragment& f : fragments) {
    const int k = samples_in(f.mask);
    sum = sum + to_double(f.rgb) * k;
    covered += k;
  }
  if (uncovered == Uncovered::left_out && covered > 0) return {sum * (1.0 / covered), 0};
  return {sum * (1.0 / samples), static_cast<double>(samples - covered) / samples};
}

}  // namespace

void Resolver::add_sample(std::span<const Fragment> fragments, std::size_t sample, Composed& sum) {
  layers_.clear();
  for (const Fragment& f : fragments) {
    if ((f.mask >> sample & 1) != 0) layers_.push_back({depth_at(f, *pattern_, sample), f.id, &f});
  }
  std::sort(layers_.begin(), layers_.end(), [](const Layer& one, const Layer& other) {
    return one.z != other.z ? one.z < other.z : one.id < other.id;
  });
  double through = 1;
  for (const Layer& layer : layers_) {
    const double alpha = double{layer.fragment->alpha};
    sum.rgb = sum.rgb + to_double(layer.fragment->rgb) * (through * alpha);
    through *= 1 - alpha;
  }
  sum.background += through;
}

Composed Resolver::compose(std::span<const Fragment> fragments, Uncovered uncovered) {
  const int samples = static_cast<int>(pattern_->count);
  if (std::all_of(fragments.begin(), fragments.end(), [](const Fragment& f) { return f.opaque(); })) {
    return opaque(fragments, samples, uncovered);
  }
  Mask covered = 0;
  for (const Fragment& f : fragments) covered |= f.mask;
  if (uncovered == Uncovered::background) covered = pattern_->full();
  Composed sum = {{}, 0};
  for (Mask left = covered; left != 0; left &= left - 1) {
    add_sample(fragments, static_cast<std::size_t>(std::countr_zero(left)), sum);
  }
  const double share = 1.0 / samples_in(covered);
  return {sum.rgb * share, sum.background * share};
}

}  // namespace blysk::antialias
