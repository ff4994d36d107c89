// Spheres: by latitude and longitude, from an icosahedron, and the two of the shading thesis' experiment.
#include <cmath>
#include <utility>

#include "scene/shapes_internal.h"

namespace blysk::shape {
namespace {

// Unit sphere with poles on the Y axis. Slices begin where `start` half turns from +Z to +X lead.
Mesh globe(int slices, int stacks, int start) {
  std::vector<Turn> meridians;  // one more for the seam
  for (int slice = 0; slice <= slices; ++slice) {
    meridians.push_back(
        turn(2 * std::int64_t{slice} + std::int64_t{start} * slices, 2 * std::int64_t{slices}));
  }
  std::vector<Turn> parallels;
  for (int stack = 0; stack <= stacks; ++stack) parallels.push_back(turn(stack, 2 * std::int64_t{stacks}));

  Mesh mesh;
  add_sheet(mesh, {.columns = slices, .rows = stacks, .pole_first = true, .pole_last = true},
            [&](int row, int column, Vec2f texcoord) {
              const Turn& m = meridians[static_cast<std::size_t>(column)];
              const Turn& p = parallels[static_cast<std::size_t>(row)];
              const Vec3f at = to_float({m.sine * p.sine, p.cosine, m.cosine * p.sine});
              return Vertex{at, at, texcoord};
            });
  return mesh;
}

Scene make_sphere(const Arguments& arguments) {
  const int detail = arguments.whole("detail");
  return scene_of(globe(2 * detail, detail, 1), "sphere", solid_material());
}

// The icosahedron's corners: north pole, five below it, five above the south pole, south pole.
struct Icosahedron {
  Vec3d north{0, 1, 0}, south{0, -1, 0}, upper[5], lower[5];

  Icosahedron() {
    const double height = 1 / std::sqrt(5.0), radius = 2 * height;
    for (int i = 0; i < 5; ++i) {
      const Turn u = turn(2 * i + 5, 10), l = turn(2 * i + 6, 10);
      upper[i] = {u.sine * radius, height, u.cosine * radius};
      lower[i] = {l.sine * radius, -height, l.cosine * radius};
    }
  }
};

// Corners of a rhombus of two faces, cut along top_left - bottom_right.
struct Rhombus {
  Vec3d top_left, top_right, bottom_left, bottom_right;

  // The point of the lattice of n cells a side, drawn onto the sphere. On an edge its bits depend on the
  // edge's ends alone, so that neighbours meet.
  [[nodiscard]] Vec3d at(int column, int row, int n) const {
    const bool below = row > column;
    const Vec3d corner = below ? bottom_left : top_right;
    const double to_corner = below ? row - column : column - row;
    const double to_first = n - (below ? row : column), to_last = below ? column : row;
    return normalize(top_left * to_first + bottom_right * to_last + corner * to_corner);
  }
};

// Five strips from pole to pole, each a lattice of two rhombi; the texture is the flat net of them.
Scene make_icosphere(const Arguments& arguments) {
  const int n = arguments.whole("detail");
  const Icosahedron solid;
  Mesh mesh;
  for (int strip = 0; strip < 5; ++strip) {
    const int east = (strip + 1) % 5;
    const Rhombus north{solid.upper[strip], solid.north, solid.lower[strip], solid.upper[east]};
    const Rhombus south{solid.lower[strip], solid.upper[east], solid.south, solid.lower[east]};
    add_sheet(mesh, {.columns = n, .rows = 2 * n}, [&](int row, int column, Vec2f texcoord) {
      const Vec3f at = to_float(row <= n ? north.at(column, row, n) : south.at(column, row - n, n));
      return Vertex{at, at, Vec2f{(static_cast<float>(strip) + texcoord.x) / 5, texcoord.y}};
    });
  }
  return scene_of(std::move(mesh), "icosphere", solid_material());
}

// Based on: the experiment of the shading thesis, appendix C: two spheres whose poles lie on the Z axis.
Scene make_spheres(const Arguments& arguments) {
  const int detail = arguments.whole("detail");
  Mesh mesh = globe(detail, detail, 0);
  // Its slices turn from +Y to +X. Exchanging Y and Z does that, and mirrors the fronts.
  for (Vec3f& p : mesh.positions) std::swap(p.y, p.z);
  for (Vec3f& n : mesh.normals) std::swap(n.y, n.z);
  for (Vec2f& t : mesh.texcoords) t.x = 1 - t.x;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
    std::swap(mesh.indices[i + 1], mesh.indices[i + 2]);

  Material material = solid_material();
  material.color = {64 / 255.0f, 77 / 255.0f, 90 / 255.0f};
  material.specular = {1, 1, 1};
  material.shininess = 50;
  Scene scene = scene_of(std::move(mesh), "spheres", material);
  scene.instances.push_back(scene.instances[0]);
  scene.instances[0].transform = translation({-2, 0, 0});
  scene.instances[1].transform = translation({2, 0, 0});

  Light light;
  light.vector = {0, std::sqrt(0.5), std::sqrt(0.5)};
  light.name = "thesis";
  scene.lights.push_back(light);
  Camera camera;
  camera.fov_deg = 45;
  camera.eye = {0, 1, 4};
  camera.near_distance = 0.1;
  camera.far_distance = 100;
  camera.name = "thesis";
  scene.cameras.push_back(camera);
  return scene;
}

}  // namespace

Entry sphere() {
  return {{"sphere",
           "sphere of radius 1 by latitude and longitude",
           {{"detail", 2, 3500, 32, "segments from pole to pole, twice as many around"}}},
          make_sphere};
}

Entry icosphere() {
  return {{"icosphere",
           "sphere of radius 1 with triangles of nearly one size: an icosahedron, subdivided",
           {{"detail", 1, 1500, 8, "segments that each of its 30 edges is cut into"}}},
          make_icosphere};
}

Entry spheres() {
  return {
      {"spheres",
       "the shading thesis' experiment: two glossy spheres with their camera and light, for --size 1000x400, "
       "--ambient 0.196, --background 0.5,0.5,0.5 and --transfer none",
       {{"detail", 3, 3500, 50, "slices and stacks of each sphere"}}},
      make_spheres};
}

}  // namespace blysk::shape
