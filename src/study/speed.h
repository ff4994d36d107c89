// study/speed.h - what shading costs here: kernels by size of triangle and length of span, whole frames, and
// the papers' programs without SIMD.
#pragma once

#include <string>
#include <vector>

#include "blysk/render.h"
#include "study/timing.h"

namespace blysk::study {

/// A picture wholly covered by equal triangles that bend gently, seen as the papers do: parallel projection,
/// light at infinity, attributes linear on the screen.
struct SpeedScene {
  std::string name;  ///< "100 pixels", "span 64"
  Scene scene;
  RenderOptions options;
};

/// Right triangles of so many pixels.
[[nodiscard]] SpeedScene triangles_of(double pixels, int side);
/// Right triangles of 32 rows whose rows have so many pixels on average.
[[nodiscard]] SpeedScene spans_of(int pixels, int width, int height);

/// Cycles per pixel of the shading stage alone on one thread, and gains over the first method.
struct ShadingCost {
  std::vector<double> cycles, gains;  ///< of each method
};
[[nodiscard]] ShadingCost shading_cost(const SpeedScene& scene, const std::vector<std::string>& methods,
                                       Isa isa, const Rounds& rounds);

/// The walks of study/operations.h in single precision over the average triangle, as the compiler translates
/// them.
struct WalkCost {
  std::vector<double> cycles, gains;  ///< of each walk
};
[[nodiscard]] WalkCost walk_cost(const Rounds& rounds);

/// Rows of 16 pixels by every QuadraticForm, in single precision as the compiler translates it: cycles per
/// pixel.
[[nodiscard]] std::vector<double> row_cost(const Rounds& rounds);

/// One vector made unit in a loop without SIMD of ours: cycles by every Normalisation but the recurrence.
[[nodiscard]] std::vector<double> normalisation_cost(const Rounds& rounds);

/// Lobes of shininess 50 over many cosines likewise: cycles by every CountedLobe.
[[nodiscard]] std::vector<double> plain_lobe_cost(const Rounds& rounds);

/// Specular lobes in the phong kernel at one shininess, best instruction set.
[[nodiscard]] ShadingCost lobe_cost(SpeedScene scene, float shininess, const std::vector<std::string>& lobes,
                                    const Rounds& rounds);

}  // namespace blysk::study
