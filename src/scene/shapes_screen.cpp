#include "scene/shapes_screen.h"

#include <utility>

namespace blysk::shape {

void ScreenScene::add(std::array<Vec3d, 3> c, Vec3f color) {
  const double area = (c[1].x - c[0].x) * (c[2].y - c[0].y) - (c[2].x - c[0].x) * (c[1].y - c[0].y);
  if (area == 0) return;
  if (area > 0) std::swap(c[1], c[2]);  // y is down: clockwise in pixels is a back in the world
  constexpr Vec2f kCorners[] = {{0, 0}, {1, 0}, {0, 1}};
  for (std::size_t k = 0; k < 3; ++k) {
    mesh_.indices.push_back(static_cast<std::uint32_t>(mesh_.positions.size()));
    mesh_.positions.push_back(
        to_float({c[k].x * (2 / kScreen) - 1, 1 - c[k].y * (2 / kScreen), 1 - 2 * c[k].z}));
    mesh_.colors.push_back({color.x, color.y, color.z, 1});
    mesh_.texcoords.push_back(kCorners[k]);
  }
}

Scene ScreenScene::finish(std::string_view name) && {
  Material material;
  material.color = {1, 1, 1};
  material.specular = {0, 0, 0};
  material.unlit = true;
  Scene scene = scene_of(std::move(mesh_), name, material);
  Camera camera;
  camera.eye = {0, 0, 4};
  camera.height = 2;
  camera.name = "picture";
  scene.cameras.push_back(camera);
  return scene;
}

Vec3f random_color(Random& random) {
  const float red = random.unit(), green = random.unit(), blue = random.unit();
  return {red, green, blue};
}

double random_normal(Random& random) {
  double sum = -6;
  for (int i = 0; i < 12; ++i) sum += double{random.unit()};
  return sum;
}

}  // namespace blysk::shape
