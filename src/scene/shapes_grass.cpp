// Blades and fans: thin things in front of each other, and planes that meet in one line.
#include <utility>

#include "math/trig.h"
#include "scene/shapes_screen.h"

namespace blysk::shape {
namespace {

Vec3f green(Random& random) {
  const auto between = [&](double low, double high) {
    return static_cast<float>(random_between(random, low, high));
  };
  const float red = between(0.08, 0.4), leaf = between(0.32, 0.94), blue = between(0.08, 0.24);
  return {red, leaf, blue};
}

// Blades stand on a ground that runs away from the viewer: the higher in the picture, the farther.
Scene make_grass(const Arguments& arguments) {
  const int count = arguments.whole("count");
  Random random(static_cast<std::uint64_t>(arguments.real("seed")));
  ScreenScene scene;
  for (int i = 0; i < count; ++i) {
    const double x = random_between(random, 0, kScreen), y = random_between(random, 0, kScreen),
                 half_width = random_between(random, 0.3, 1.5), height = random_between(random, 10, 60),
                 lean = 12 * random_normal(random), z = 1 - 0.81 * y / kScreen;
    scene.add({{{x - half_width, y, z}, {x + half_width, y, z}, {x + lean, y - height, z}}}, green(random));
  }
  return std::move(scene).finish("grass");
}

// Rectangles that turn about one axis, which lies in the plane of the picture.
void add_sheaf(ScreenScene& scene, Random& random) {
  constexpr int kLeaves = 12;
  const double x = random_between(random, 0, kScreen), y = random_between(random, 0, kScreen),
               z = random_between(random, 0.3, 0.7), angle = 2 * kPi * double{random.unit()},
               half_length = random_between(random, 40, 100);
  const Vec3d middle = {x, y, z};
  const Vec3d along = Vec3d{cosine(angle), sine(angle), 0} * half_length;
  const Vec3d across = Vec3d{-sine(angle), cosine(angle), 0} * (0.8 * half_length);
  const Vec3d deep = {0, 0, 0.25};
  for (int leaf = 0; leaf < kLeaves; ++leaf) {
    const double turned = kPi * (leaf + 0.5) / kLeaves;
    const Vec3d side = across * cosine(turned) + deep * sine(turned);
    const Vec3d a = middle - along - side, b = middle + along - side, c = middle + along + side,
                d = middle - along + side;
    const Vec3f color = random_color(random);
    scene.add({a, b, c}, color);
    scene.add({a, c, d}, color);
  }
}

Scene make_fans(const Arguments& arguments) {
  const int count = arguments.whole("count");
  Random random(static_cast<std::uint64_t>(arguments.real("seed")));
  ScreenScene scene;
  for (int i = 0; i < count; ++i) add_sheaf(scene, random);
  return std::move(scene).finish("fans");
}

}  // namespace

Entry grass() {
  return {{"grass",
           "blades of grass as thin as a pixel, a test of edges; made for --camera 0 --size 128x128",
           {{"count", 1, 1'000'000, 3000, "how many blades"}, {"seed", 0, 4294967295, 1, "which blades"}}},
          make_grass};
}

Entry fans() {
  return {{"fans",
           "sheaves of twelve rectangles that turn about one line and cut each other, a test of "
           "intersections; made for --camera 0 --size 128x128",
           {{"count", 1, 100'000, 12, "how many sheaves"}, {"seed", 0, 4294967295, 1, "which sheaves"}}},
          make_fans};
}

}  // namespace blysk::shape
