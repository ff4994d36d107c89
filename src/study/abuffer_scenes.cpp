#include "study/abuffer_scenes.h"

#include <filesystem>
#include <utility>

#include "blysk/model.h"
#include "blysk/shapes.h"
#include "study/flat_scene.h"

namespace blysk::study {
namespace {

// Specification of the A-buffer, A.11 and A.12: mean fragments generated and live, NMSE of the z-buffer; D1,
// D4, D5, M0, M1, M3, M5 for N = 3; memory ratios 1+1, 1+2, 1+3, 1+5, 1+7, 2+1, 2+2, 2+6, 3+5; spread of
// seeds.
constexpr SceneRow kScenes[] = {
    {"soup-5",
     "soup?layers=5",
     128,
     128,
     true,
     {7.4,
      1.94,
      4.3e-2,
      {3.7e-3, 2.7e-4, 2.2e-3, 4.0e-3, 2.9e-4, 1.5e-4, 7.4e-5},
      {1.16, 1.43, 1.74, 2.34, 2.84, 1.28, 1.57, 2.64, 2.23},
      1.5}},
    {"soup-20",
     "soup?layers=20",
     128,
     128,
     true,
     {29.3,
      2.16,
      5.1e-2,
      {6.1e-3, 8.8e-4, 3.4e-3, 6.7e-3, 5.4e-4, 4.4e-4, 2.1e-4},
      {1.11, 1.32, 1.58, 2.12, 2.58, 1.23, 1.50, 2.52, 2.17},
      1.5}},
    {"soup-60",
     "soup?layers=60",
     128,
     128,
     true,
     {87.7,
      2.36,
      5.7e-2,
      {8.0e-3, 1.5e-3, 4.6e-3, 1.0e-2, 7.5e-4, 4.4e-4, 2.3e-4},
      {1.08, 1.25, 1.48, 1.98, 2.43, 1.19, 1.42, 2.37, 2.13},
      1.5}},
    {"micro-20",
     "micro?layers=20&size=4",
     128,
     128,
     false,
     {47.9, 4.19, 1.3e-1, {4.8e-2, 1.0e-2, 2.5e-2, 6.2e-2, 5.0e-3, 3.5e-3, 2.1e-3}, {}, 1.2}},
    {"micro-60",
     "micro?layers=60&size=3",
     128,
     128,
     false,
     {172.5, 5.77, 1.8e-1, {9.8e-2, 2.5e-2, 4.8e-2, 1.2e-1, 8.4e-3, 6.8e-3, 3.8e-3}, {}, 1.2}},
    {"mesh-2k",
     "meshes?triangles=2000&objects=3",
     128,
     128,
     false,
     {2.9, 0.93, 1.8e-3, {2.7e-3, 1.9e-4, 4.3e-4, 2.6e-3, 1.9e-4, 1.1e-5, 8.9e-6}, {}, 4}},
    {"mesh-36k",
     "meshes?triangles=36000",
     128,
     128,
     true,
     {10.0,
      2.33,
      1.2e-3,
      {2.2e-2, 2.5e-3, 9.3e-4, 2.0e-2, 1.7e-3, 2.1e-4, 1.4e-4},
      {1.05, 1.21, 1.40, 1.80, 2.19, 1.17, 1.35, 2.16, 1.93},
      4}},
    {"mesh-120k",
     "meshes?triangles=120000",
     128,
     128,
     false,
     {15.7, 3.20, 3.2e-3, {9.4e-2, 1.4e-2, 4.9e-3, 9.6e-2, 1.0e-2, 1.9e-3, 1.5e-3}, {}, 4}},
    {"grass",
     "grass",
     128,
     128,
     true,
     {9.8,
      3.57,
      4.0e-2,
      {3.8e-2, 2.6e-3, 5.5e-3, 4.3e-2, 1.1e-3, 5.3e-4, 3.2e-4},
      {0.96, 0.99, 1.09, 1.41, 1.75, 1.03, 1.13, 1.81, 1.80},
      1.5}},
    {"fans",
     "fans",
     128,
     128,
     true,
     {52.7,
      1.10,
      4.9e-3,
      {1.1e-6, 7.9e-7, 5.1e-7, 5.5e-6, 5.2e-7, 2.1e-8, 0},
      {1.68, 2.32, 2.87, 3.77, 4.48, 1.46, 1.88, 3.36, 2.59},
      100}},
    {"xfighter", "xfighter", 640, 480, true, {}},
    {"trefoil-37k", "trefoil?detail=384", 640, 480, true, {}},
    {"terrain-131k", "terrain?detail=256", 640, 480, true, {}},
};

Result<StudyScene> study_scene(std::string name, const Scene& scene, int width, int height) {
  Result<std::vector<FlatTriangle>> triangles =
      flat_triangles(scene, study_camera(scene, width, height), width, height);
  if (!triangles) return triangles.error();
  return StudyScene{.name = std::move(name),
                    .width = width,
                    .height = height,
                    .triangles_in = scene.triangles(),
                    .triangles = std::move(*triangles)};
}

}  // namespace

std::span<const SceneRow> scene_rows() { return kScenes; }

Result<StudyScene> make_scene(const SceneRow& row) {
  const Result<Scene> scene = make_shape(row.shape);
  if (!scene) return scene.error();
  Result<StudyScene> made = study_scene(std::string(row.name), *scene, row.width, row.height);
  if (made) made->common_memory = row.common_memory;
  return made;
}

Result<StudyScene> model_scene(const std::string& model, const Limits& limits) {
  ModelOptions options;
  options.limits = limits;
  const Result<Scene> scene = load_model(model, options);
  if (!scene) return scene.error();
  const bool shape = model.starts_with("shape:");
  return study_scene(shape ? model.substr(6) : std::filesystem::path(model).stem().string(), *scene, 640,
                     480);
}

}  // namespace blysk::study
