#include "study/picture_errors.h"

#include <filesystem>
#include <utility>

#include "blysk/model.h"
#include "blysk/shapes.h"

namespace blysk::study {
namespace {

Result<PictureScene> make(std::string name, Result<Scene> scene) {
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

Result<PictureScene> framed(Result<PictureScene> scene, bool small) {
  if (!scene) return scene;
  scene->options.width = small ? 320 : 1280;
  scene->options.height = small ? 180 : 720;
  return scene;
}

RenderOptions with_method(RenderOptions options, MethodKind kind, const std::string& method) {
  (kind == MethodKind::lobe ? options.lobe : options.shading) = method;
  return options;
}

}  // namespace

Result<PictureScene> thesis_spheres(int detail, bool small) {
  Result<PictureScene> scene =
      make("spheres " + std::to_string(detail), make_shape("spheres?detail=" + std::to_string(detail)));
  if (!scene) return scene.error();
  scene->options.width = small ? 250 : 1000;
  scene->options.height = small ? 100 : 400;
  scene->options.ambient = 50.0f / 255;
  return scene;
}

Result<PictureScene> teapot(bool small) {
  return framed(make("teapot", make_shape("teapot?detail=32")), small);
}

Result<PictureScene> model_picture(const std::string& model, const Limits& limits, bool small) {
  ModelOptions options;
  options.limits = limits;
  Result<Scene> scene = load_model(model, options);
  if (scene && scene->triangles() == 0) {
    return Error{.code = ErrorCode::input, .message = "there are no triangles to draw", .source = model};
  }
  const bool shape = model.starts_with("shape:");
  return framed(
      make(shape ? model.substr(6) : std::filesystem::path(model).stem().string(), std::move(scene)), small);
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
  if (rounds.most == 0) return errors;
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
