// Loose triangles that cover a picture in many layers and run through each other.
#include <cmath>
#include <string_view>
#include <utility>

#include "math/trig.h"
#include "scene/shapes_screen.h"

namespace blysk::shape {
namespace {

// A triangle about a random place in and around the picture; its area in `area`. Slivers are drawn again.
std::array<Vec3d, 3> random_corners(Random& random, double size, double& area) {
  for (;;) {
    const double x = random_between(random, -size, kScreen + size),
                 y = random_between(random, -size, kScreen + size);
    std::array<Vec3d, 3> c;
    for (Vec3d& corner : c) {
      const double angle = 2 * kPi * double{random.unit()}, radius = size * random_between(random, 0.3, 1);
      corner = {x + radius * cosine(angle), y + radius * sine(angle), 0};
    }
    area = std::abs((c[1].x - c[0].x) * (c[2].y - c[0].y) - (c[2].x - c[0].x) * (c[1].y - c[0].y)) / 2;
    if (area <= 0.02 * size * size) continue;
    const double z = random_between(random, 0.1, 0.9);
    const double zx = random_normal(random) * 0.2 / size, zy = random_normal(random) * 0.2 / size;
    for (Vec3d& corner : c) corner.z = z + zx * (corner.x - x) + zy * (corner.y - y);
    return c;
  }
}

Scene make_layers(const Arguments& arguments, std::string_view name) {
  const double size = arguments.real("size");
  Random random(static_cast<std::uint64_t>(arguments.real("seed")));
  const double side = kScreen + 2 * size, wanted = arguments.real("layers") * side * side;
  ScreenScene scene;
  for (double covered = 0; covered < wanted;) {
    double area = 0;
    const std::array<Vec3d, 3> corners = random_corners(random, size, area);
    scene.add(corners, random_color(random));
    covered += area;
  }
  return std::move(scene).finish(name);
}

Scene make_soup(const Arguments& arguments) { return make_layers(arguments, "soup"); }
Scene make_micro(const Arguments& arguments) { return make_layers(arguments, "micro"); }

std::vector<ShapeParameter> parameters(double size) {
  return {
      {"layers", 1, 100, 20, "triangles over each place, hidden ones too"},
      {"size", 1, 64, size, "radius of the largest triangles, in pixels of a picture of 128 pixels", false},
      {"seed", 0, 4294967295, 1, "which triangles"}};
}

}  // namespace

Entry soup() {
  return {{"soup",
           "layers of flat coloured triangles that cut each other, a test of hidden surfaces; made for "
           "--camera 0 --size 128x128",
           parameters(12)},
          make_soup};
}

Entry micro() {
  return {{"micro",
           "the same of triangles of a few pixels, a test of crowded pixels; made for --camera 0 --size "
           "128x128",
           parameters(4)},
          make_micro};
}

}  // namespace blysk::shape
