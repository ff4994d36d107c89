// Spheres and tori of small triangles, each of its own gray, that stand in each other.
#include <algorithm>
#include <cmath>
#include <utility>

#include "scene/shapes_screen.h"

namespace blysk::shape {
namespace {

// Uniform among all rotations: a unit quaternion.
Mat4 random_rotation(Random& random) {
  for (;;) {
    const double x = double{random.signed_unit()}, y = double{random.signed_unit()},
                 z = double{random.signed_unit()}, w = double{random.signed_unit()};
    const double square = x * x + y * y + z * z + w * w;
    if (square > 1 || square < 0.01) continue;
    const double scale = 1 / std::sqrt(square);
    return rotation_from_quaternion({x * scale, y * scale, z * scale, w * scale});
  }
}

// An object's way into the picture: turned, then flattened to a share of the depths.
struct Placing {
  Mat4 rotation;
  double x, y, z, scale;
  Vec3f base;

  explicit Placing(Random& random) : rotation(random_rotation(random)) {
    x = kScreen * random_between(random, 0.2, 0.8);
    y = kScreen * random_between(random, 0.2, 0.8);
    z = random_between(random, 0.3, 0.7);
    scale = kScreen * random_between(random, 0.18, 0.38);
    const auto bright = [&] { return static_cast<float>(random_between(random, 60, 255) / 255); };
    base.x = bright();
    base.y = bright();
    base.z = bright();
  }

  // Of a triangle by how it faces a lamp; both sides are alike.
  void add(ScreenScene& scene, Vec3d a, Vec3d b, Vec3d c) const {
    const Vec3d pa = transform_point(rotation, a), pb = transform_point(rotation, b),
                pc = transform_point(rotation, c);
    const Vec3d normal = normalize(cross(pb - pa, pc - pa));
    const auto bright = static_cast<float>(0.25 + 0.75 * std::abs(dot(normal, Vec3d{0.4, 0.5, -0.77})));
    const auto placed = [&](Vec3d p) { return Vec3d{x + scale * p.x, y + scale * p.y, z + 0.15 * p.z}; };
    scene.add({placed(pa), placed(pb), placed(pc)},
              Vec3f{std::min(base.x * bright, 1.0f), std::min(base.y * bright, 1.0f),
                    std::min(base.z * bright, 1.0f)});
  }
};

// The cells of a surface over the unit square; flat ones leave nothing.
template <class Surface>
void add_cells(ScreenScene& scene, const Placing& placing, int columns, int rows, const Surface& point) {
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const Vec3d a = point(column, row), b = point(column + 1, row), c = point(column + 1, row + 1),
                  d = point(column, row + 1);
      if (!(a == b)) placing.add(scene, a, b, c);
      if (!(c == d)) placing.add(scene, a, c, d);
    }
  }
}

void add_sphere(ScreenScene& scene, const Placing& placing, double triangles) {
  const int rows = std::max(2, static_cast<int>(std::sqrt(triangles / 4)));
  const std::vector<Turn> around = full_circle(2 * rows);
  add_cells(scene, placing, 2 * rows, rows, [&](int column, int row) {
    const Turn& u = around[static_cast<std::size_t>(column)];
    const Turn& v = around[static_cast<std::size_t>(row)];  // half of the circle: from pole to pole
    const double ring = row == 0 || row == rows ? 0 : v.sine;
    return Vec3d{u.cosine * ring, u.sine * ring, v.cosine};
  });
}

void add_torus(ScreenScene& scene, const Placing& placing, double triangles) {
  constexpr double kTube = 0.4;
  const int cells = std::max(3, static_cast<int>(std::sqrt(triangles / 2)));
  const std::vector<Turn> around = full_circle(cells);
  add_cells(scene, placing, cells, cells, [&](int column, int row) {
    const Turn& u = around[static_cast<std::size_t>(column)];
    const Turn& v = around[static_cast<std::size_t>(row)];
    const double ring = 1 + kTube * v.cosine;
    return Vec3d{u.cosine * ring, u.sine * ring, kTube * v.sine};
  });
}

Scene make_meshes(const Arguments& arguments) {
  const int objects = arguments.whole("objects");
  Random random(static_cast<std::uint64_t>(arguments.real("seed")));
  const double each = arguments.real("triangles") / objects;
  ScreenScene scene;
  for (int i = 0; i < objects; ++i) {
    const Placing placing(random);
    if (i % 2 == 0) {
      add_sphere(scene, placing, each);
    } else {
      add_torus(scene, placing, each);
    }
  }
  return std::move(scene).finish("meshes");
}

}  // namespace

Entry meshes() {
  return {{"meshes",
           "spheres and tori in each other, of triangles each of one shade, a test of dense meshes; made for "
           "--camera 0 --size 128x128",
           {{"triangles", 100, 10'000'000, 36000, "about how many in all"},
            {"objects", 1, 100, 6, "how many spheres and tori"},
            {"seed", 0, 4294967295, 1, "which shapes, sizes and places"}}},
          make_meshes};
}

}  // namespace blysk::shape
