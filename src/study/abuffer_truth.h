// study/abuffer_truth.h - the renderer's antialiasing and common multisampling, against a picture with
// hundreds of samples a pixel.
#pragma once

#include <string>
#include <vector>

#include "blysk/render.h"
#include "blysk/study.h"

namespace blysk::study {

/// A lit scene with its camera and lights set.
struct TruthScene {
  std::string name;
  Scene scene;
  RenderOptions options;
};

/// "xfighter", "slivers" (a fan of 360 triangles, half a degree wide and half a degree apart), or a model's
/// file or shape; all of it opaque. Pictures of 320 x 240.
[[nodiscard]] Result<TruthScene> truth_scene(const std::string& name, const Limits& limits);

struct TruthRow {
  std::string method;
  double nmse = 0;
};

struct TruthResult {
  std::string name;
  std::vector<TruthRow> rows;  ///< in the order of truth_methods()

  [[nodiscard]] double nmse(std::string_view method) const;
};

/// What is measured: methods of the renderer, and "4x", "16x" multisampling, shaded at the centre, and "16x
/// centroid".
[[nodiscard]] std::vector<std::string> truth_methods();

/// `truth`: an antialiasing method.
[[nodiscard]] Result<TruthResult> measure_truth(const TruthScene& scene, const std::string& truth,
                                                int threads);

[[nodiscard]] StudySection truth_section(const std::vector<TruthResult>& results);

}  // namespace blysk::study
