// antialias/fragment.h - what one triangle contributes to one pixel.
//
// Depth here is smaller where nearer, 0 near and 1 far; the pipeline's `nearness` n enters as z = 1 - n with
// its slopes negated.
#pragma once

#include <cstdint>

#include "antialias/sample_patterns.h"
#include "blysk/vector.h"

namespace blysk::antialias {

struct Fragment {
  Mask mask = 0;    ///< samples that are covered and not known to be hidden
  Vec3f rgb;        ///< linear; any scale
  float z = 0;      ///< of its plane at the pixel's centre, which may lie outside the triangle: not clamped
  float zx = 0;     ///< dz/dx a pixel
  float zy = 0;     ///< dz/dy a pixel, y down
  float alpha = 1;  ///< opacity
  std::uint32_t id = 0;      ///< number of submission: unique in a pixel, decides ties
  std::uint32_t object = 0;  ///< the classic A-buffer merges fragments of one object
  bool lit = true;           ///< false: rgb is still to be asked for (Colours)

  [[nodiscard]] bool opaque() const { return alpha >= 1; }
};

/// Depth at a sample. One expression everywhere: rounding it in another way could put three planes in a ring.
[[nodiscard]] inline float depth_at(const Fragment& f, const SamplePattern& pattern, std::size_t sample) {
  return (f.z + pattern.a[sample] * f.zx) + pattern.b[sample] * f.zy;
}

/// Who is seen where two depths are equal.
enum class Tie {
  existing,  ///< the one stored first
  newer,     ///< the one that comes later
  lower_id   ///< the lower id, whatever the order of arrival
};

/// Samples of the whole pixel at which `g` is nearer than `f`; where they tie, if `ties`.
[[nodiscard]] Mask visibility(const Fragment& g, const Fragment& f, const SamplePattern& pattern,
                              bool ties = true);

}  // namespace blysk::antialias
