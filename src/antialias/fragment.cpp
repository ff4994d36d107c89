#include "antialias/fragment.h"

namespace blysk::antialias {
namespace {

constexpr std::size_t kGroup = 16;  // samples that are compared at once

// Loops of a known length without branches: compilers make vectors of them.
Mask visible_group(const Fragment& g, const Fragment& f, const float* a, const float* b, bool ties) {
  Mask nearer = 0, equal = 0;
  for (std::size_t s = 0; s < kGroup; ++s) {
    const float zg = (g.z + a[s] * g.zx) + b[s] * g.zy, zf = (f.z + a[s] * f.zx) + b[s] * f.zy;
    const Mask bit = Mask{1} << s;
    nearer |= zg < zf ? bit : 0;
    equal |= zg == zf ? bit : 0;
  }
  return ties ? nearer | equal : nearer;
}

}  // namespace

Mask visibility(const Fragment& g, const Fragment& f, const SamplePattern& pattern, bool ties) {
  Mask all = visible_group(g, f, pattern.a.data(), pattern.b.data(), ties);
  if (pattern.count > kGroup) {
    all |= visible_group(g, f, pattern.a.data() + kGroup, pattern.b.data() + kGroup, ties) << kGroup;
  }
  return all & pattern.full();
}

}  // namespace blysk::antialias
