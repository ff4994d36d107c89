// Loose coloured triangles of random place, for tests of hidden surfaces and for measurements.
#include <numeric>
#include <utility>

#include "core/random.h"
#include "scene/shapes_internal.h"

namespace blysk::shape {
namespace {

struct Triangle {
  Vec3f a, b, c;
};

// A triangle in a cube of side `size` somewhere in the cube from -1 to 1; flat ones are drawn again.
Triangle random_triangle(Random& random, float size) {
  const auto point = [&](float reach) {
    const float x = random.signed_unit(), y = random.signed_unit(), z = random.signed_unit();
    return Vec3f{x, y, z} * reach;
  };
  for (;;) {
    const Vec3f middle = point(1 - size / 2);
    const Vec3f a = middle + point(size / 2), b = middle + point(size / 2), c = middle + point(size / 2);
    const Vec3d front = cross(to_double(b - a), to_double(c - a));
    const double flat = 1e-3 * static_cast<double>(size) * static_cast<double>(size);
    if (front.z * front.z > flat * flat) return front.z > 0 ? Triangle{a, b, c} : Triangle{a, c, b};
  }
}

// Depths of parallel triangles: layers of equal distance, each half as thick as its share of the cube, and
// inside it every triangle at a depth of its own. Layers take turns; inside one, depths are scattered.
class Layers {
 public:
  Layers(std::int64_t count, std::int64_t layers)
      : layers_(layers), slots_((count + layers - 1) / layers), stride_(slots_ * 5 / 8 + 1) {
    while (std::gcd(stride_, slots_) != 1) ++stride_;
  }

  [[nodiscard]] float depth(std::int64_t triangle) const {
    const std::int64_t layer = triangle % layers_, slot = triangle / layers_ * stride_ % slots_;
    const double inside = (static_cast<double>(slot) + 0.5) / static_cast<double>(slots_);
    return static_cast<float>(
        2 * (static_cast<double>(layer) + 0.25 + inside / 2) / static_cast<double>(layers_) - 1);
  }

 private:
  std::int64_t layers_, slots_, stride_;
};

Scene make_triangles(const Arguments& arguments) {
  const auto count = static_cast<std::size_t>(arguments.whole("count"));
  const auto size = static_cast<float>(arguments.real("size"));
  const bool parallel = arguments.whole("intersecting") == 0;
  const Layers layers(arguments.whole("count"), arguments.whole("layers"));
  Random random(static_cast<std::uint64_t>(arguments.real("seed")));

  Mesh mesh;
  mesh.positions.resize(3 * count);
  mesh.colors.resize(3 * count);
  mesh.texcoords.resize(3 * count);
  mesh.indices.resize(3 * count);
  std::iota(mesh.indices.begin(), mesh.indices.end(), 0u);
  for (std::size_t i = 0; i < count; ++i) {
    Triangle t = random_triangle(random, size);
    if (parallel) t.a.z = t.b.z = t.c.z = layers.depth(static_cast<std::int64_t>(i));
    const float red = random.unit(), green = random.unit(), blue = random.unit();
    const std::size_t at = 3 * i;
    mesh.positions[at] = t.a;
    mesh.positions[at + 1] = t.b;
    mesh.positions[at + 2] = t.c;
    for (std::size_t k = 0; k < 3; ++k) mesh.colors[at + k] = {red, green, blue, 1};
    mesh.texcoords[at] = {0, 0};
    mesh.texcoords[at + 1] = {1, 0};
    mesh.texcoords[at + 2] = {0, 1};
  }
  Material material;
  material.color = {1, 1, 1};
  Scene scene = scene_of(std::move(mesh), "triangles", material);
  Camera camera;
  camera.fov_deg = 45;
  camera.name = "front";
  scene.cameras.push_back(camera);
  return scene;
}

}  // namespace

Entry triangles() {
  return {
      {"triangles",
       "random coloured triangles in the cube from -1 to 1, fronts towards +Z, with a camera that sees them "
       "all",
       {{"count", 1, 10'000'000, 1000, "how many"},
        {"size", 0.0001, 2, 0.1, "side of the cube that holds one triangle", false},
        {"layers", 1, 10'000, 1, "groups of depths when they do not intersect"},
        {"seed", 0, 4294967295, 1, "which triangles"},
        {"intersecting", 0, 1, 1, "0: parallel to the XY plane, each at its own depth; 1: any direction"}}},
      make_triangles};
}

}  // namespace blysk::shape
