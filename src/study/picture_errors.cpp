#include "study/picture_errors.h"

#include <utility>

#include "blysk/shapes.h"

namespace blysk::study {
namespace {

Result<PictureScene> make(std::string name, const std::string& shape) {
  Result<Scene> scene = make_shape(shape);
  if (!scene) return scene.error();
  PictureScene made;
  made.name = std::move(name);
  made.scene = std::move(*scene);
  if (!made.scene.cameras.empty()) made.options.camera = made.scene.cameras[0];
  made.options.interpolation = Interpolation::screen;
  made.options.transfer = Transfer::none;
  made.options.antialias = "none";  // errors are those of the method at pixel centres
  made.options.background = {0.5f, 0.5f, 0.5f, 1};
  return made;
}

RenderOptions with_method(RenderOptions options, MethodKind kind, const std::string& method) {
  (kind == MethodKind::lobe ? options.lobe : options.shading) = method;
  return options;
}

}  // namespace

Result<PictureScene> thesis_spheres(int detail, bool small) {
  Result<PictureScene> scene =
      make("spheres " + std::to_string(detail), "spheres?detail=" + std::to_string(detail));
  if (!scene) return scene.error();
  scene->options.width = small ? 250 : 1000;
  scene->options.height = small ? 100 : 400;
  scene->options.ambient = 50.0f / 255;
  return scene;
}

Result<PictureScene> teapot(bool small) {
  Result<PictureScene> scene = make("teapot", "teapot?detail=32");
  if (!scene) return scene.error();
  scene->options.width = small ? 320 : 1280;
  scene->options.height = small ? 180 : 720;
  return scene;
}

Result<PictureErrors> picture_errors(const PictureScene& scene, MethodKind kind,
                                     const std::vector<std::string>& methods, const Rounds& rounds) {
  Renderer renderer({.threads = 1, .isa = Isa::best});
  PictureErrors errors;
  Frame reference, frame;
  for (const std::string& method : methods) {
    Frame& drawn = errors.differences.empty() ? reference : frame;
    const RenderOptions options = with_method(scene.options, kind, method);
    if (const Status s = renderer.render(scene.scene, options, drawn); !s) return s.error();
    const Result<Difference> difference = compare(reference.image, drawn.image);
    if (!difference) return difference.error();
    errors.differences.push_back(*difference);
  }
  if (rounds.count == 0) return errors;
  std::vector<std::function<void()>> runs;
  for (const std::string& method : methods) {
    runs.emplace_back([&renderer, &scene, &frame, options = with_method(scene.options, kind, method)] {
      static_cast<void>(renderer.render(scene.scene, options, frame));  // it was drawn before
    });
  }
  for (const Timing& t : time_in_turn(runs, rounds)) {
    errors.frame_ms.push_back(t.ns * 1e-6);
    errors.gains.push_back(t.gain);
  }
  return errors;
}

}  // namespace blysk::study
