// study/picture_errors.h - how far the methods' pictures are from phong's, and how long their frames take.
#pragma once

#include <string>
#include <vector>

#include "blysk/methods.h"
#include "blysk/metrics.h"
#include "blysk/render.h"
#include "study/timing.h"

namespace blysk::study {

struct PictureScene {
  std::string name;  ///< "spheres 50"
  Scene scene;
  RenderOptions options;
};

/// The thesis' two spheres with its camera, light, material and size (section 11 of the specification),
/// linear on the screen.
[[nodiscard]] Result<PictureScene> thesis_spheres(int detail, bool small);
[[nodiscard]] Result<PictureScene> teapot(bool small);
/// A file or "shape:..." as it is framed by default.
[[nodiscard]] Result<PictureScene> model_picture(const std::string& model, const Limits& limits, bool small);

/// A picture's error by method of `kind`, against the first of them; all else as the scene says.
struct PictureErrors {
  std::vector<Difference> differences;  ///< of each method
  std::vector<double> frame_ms, gains;  ///< one thread; empty without rounds
};
[[nodiscard]] Result<PictureErrors> picture_errors(const PictureScene& scene, MethodKind kind,
                                                   const std::vector<std::string>& methods,
                                                   const Rounds& rounds);

}  // namespace blysk::study
