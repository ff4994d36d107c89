#include "study/abuffer_truth.h"

#include <algorithm>

#include "blysk/metrics.h"
#include "blysk/model.h"
#include "blysk/shapes.h"
#include "math/trig.h"
#include "study/cells.h"
#include "study/flat_scene.h"
#include "study/multisampled.h"

namespace blysk::study {
namespace {

struct Sampler {
  std::string_view name;
  Multisampling sampling;
};
constexpr Sampler kSamplers[] = {{"4x", {&kRotated4, ShadeAt::centre}},
                                 {"16x", {&antialias::kGrid16, ShadeAt::centre}},
                                 {"16x centroid", {&antialias::kGrid16, ShadeAt::centroid}}};
constexpr std::string_view kRendered[] = {"none", "abuffer", "abuffer:samples=32"};

Scene fan_of_slivers() {
  constexpr std::uint32_t kSlivers = 360;
  Mesh mesh;
  const auto add = [&](double x, double y) {
    mesh.positions.push_back({static_cast<float>(x), static_cast<float>(y), 0});
    mesh.normals.push_back({0, 0, 1});
    mesh.indices.push_back(static_cast<std::uint32_t>(mesh.indices.size()));
  };
  for (std::uint32_t i = 0; i < kSlivers; ++i) {
    add(0, 0);
    for (const double edge : {0.0, 0.5}) {
      const double angle = radians(360.0 * (i + edge) / kSlivers + 0.1);
      add(cosine(angle), sine(angle));
    }
  }
  Scene scene;
  Material material;
  material.color = {0.8f, 0.7f, 0.3f};
  scene.add(std::move(mesh), material);
  return scene;
}

}  // namespace

Result<TruthScene> truth_scene(const std::string& name, const Limits& limits) {
  TruthScene t;
  t.name = name.substr(name.find_last_of('/') + 1);  // npos + 1 is 0
  if (name == "slivers") {
    t.scene = fan_of_slivers();
  } else {
    Result<Scene> scene = load_model(name == "xfighter" ? "shape:xfighter" : name, {.limits = limits});
    if (!scene) return scene.error();
    t.scene = std::move(*scene);
  }
  for (Material& m : t.scene.materials)
    m.alpha_mode = AlphaMode::opaque;  // multisampling has no answer to glass
  RenderOptions& o = t.options;
  o.width = 320;
  o.height = 240;
  o.camera = name == "slivers" ? frame_camera(t.scene, {.view = View::front, .aspect = 4.0 / 3})
                               : study_camera(t.scene, o.width, o.height);
  Light& light = o.lights.emplace_back();
  light.vector = {0.4, 0.6, 0.7};
  light.color = {0.85f, 0.85f, 0.85f};
  o.cull = Cull::none;
  o.transfer = Transfer::none;
  o.background = {32 / 255.0f, 32 / 255.0f, 64 / 255.0f, 1};
  return t;
}

double TruthResult::nmse(std::string_view method) const {
  return std::ranges::find(rows, method, &TruthRow::method)->nmse;
}

std::vector<std::string> truth_methods() {
  std::vector<std::string> names(std::begin(kRendered), std::end(kRendered));
  for (const Sampler& s : kSamplers) names.emplace_back(s.name);
  return names;
}

Result<TruthResult> measure_truth(const TruthScene& scene, const std::string& truth, int threads) {
  Renderer renderer({.threads = threads});
  RenderOptions options = scene.options;
  options.antialias = truth;
  const Result<Frame> wanted = renderer.render(scene.scene, options);
  if (!wanted) return wanted.error();
  TruthResult result = {.name = scene.name, .rows = {}};
  const auto add = [&](std::string_view method, const Image& image) {
    result.rows.push_back({std::string(method), compare(wanted->image, image)->nmse});
  };
  for (const std::string_view method : kRendered) {
    options.antialias = method;
    const Result<Frame> frame = renderer.render(scene.scene, options);
    if (!frame) return frame.error();
    add(method, frame->image);
  }
  for (const Sampler& s : kSamplers) {
    const Result<Image> image = multisampled(scene.scene, options, s.sampling);
    if (!image) return image.error();
    add(s.name, *image);
  }
  return result;
}

StudySection truth_section(const std::vector<TruthResult>& results) {
  StudyTable table = {"NMSE against 256 samples a pixel (supersample:n=4)", {"scene"}, {}};
  for (std::string& method : truth_methods()) table.columns.push_back(std::move(method));
  table.columns.emplace_back("abuffer, times less than 4x");
  for (const TruthResult& r : results) {
    std::vector<StudyCell> row = {word(r.name)};
    for (const TruthRow& of : r.rows) row.push_back(scientific(of.nmse));
    row.push_back(fixed(r.nmse("4x") / r.nmse("abuffer"), 1));
    table.rows.push_back(std::move(row));
  }
  return {
      "Against the truth",
      {"Lit pictures of 320 x 240, Phong shading, in linear light. 4x and 16x are multisampling with one "
       "shading a triangle and pixel, at the pixel's centre even where the triangle does not cover it, as "
       "hardware does; centroid: at that of the samples that it covers. 4x has the usual rotated grid, 16x "
       "the samples of abuffer."},
      {std::move(table)},
      {}};
}

}  // namespace blysk::study
