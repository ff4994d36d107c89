// shading/testing.h - triangles and light for tests of shading methods.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "render/testing.h"

namespace blysk {

/// Triangles over each other whose corners lie on the grid of 1/256 pixel of pixel_camera(side).
struct Heap {
  int side, count;
  double size;    ///< of a triangle, half its width in pixels
  double spread;  ///< normals of each triangle lie in a cone of up to this times 90 degrees
  double shortest = 1, longest = 1;  ///< of the normals; those of a triangle are equally long
};

inline Mesh random_triangles(Random& random, const Heap& heap) {
  Mesh mesh;
  const auto snapped = [](double v) { return static_cast<float>(std::round(v * 256) / 256); };
  const double reach = heap.side / 2;
  for (int t = 0; t < heap.count; ++t) {
    const double x = uniform(random, -reach, reach), y = uniform(random, -reach, reach);
    const Vec3d axis = random_direction(random);
    const double cone = heap.spread * uniform(random, 0, 1);
    const double length =
        heap.shortest < heap.longest ? uniform(random, heap.shortest, heap.longest) : heap.shortest;
    for (int k = 0; k < 3; ++k) {
      const float px = snapped(x + uniform(random, -heap.size, heap.size)),
                  py = snapped(y + uniform(random, -heap.size, heap.size));
      mesh.indices.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
      mesh.positions.push_back({px, py, static_cast<float>(uniform(random, -0.9, 0.9))});
      mesh.normals.push_back(to_float(normalize(axis + random_direction(random) * cone) * length));
    }
  }
  return mesh;
}

/// Opposite normals, a normal of length 0, a needle; for pixel_camera(200).
inline Mesh hard_triangles() {
  Mesh mesh = mesh_of({{-90, -90, 0}, {90, -90, 0}, {0, 90, 0}, {-90, 95, 0}, {95, -90, 0}, {95, -89.99f, 0}},
                      {0, 1, 2, 3, 4, 5});
  mesh.normals = {{0, 0, 1}, {0, 0, -1}, {0, 0, 0}, {0, 0, 1}, {0, 1, 0}, {1, 0, 0}};
  return mesh;
}

/// Among the triangles of a shape, so that some are clipped. A height makes it orthographic.
inline Camera camera_inside(double height = 0) {
  Camera camera;
  camera.eye = {0.1, 0.5, 0.6};
  camera.target = {0, 0, -1};
  camera.fov_deg = 80;
  camera.height = height;
  return camera;
}

/// Diffuse 0.5 and specular 0.4 of one white light, a normal that is not quite unit, the viewer at +z.
inline double lit(Vec3d n, Vec3d light, double shininess) {
  if (n.z < 0) n = -n;
  const double n_l = dot(n, light);
  if (n_l <= 0) return 0;
  const double n_h = (n_l + n.z) / std::sqrt(2 + 2 * light.z);
  const double lobe =
      std::pow(std::clamp(n_h, 0.0, 1.0), shininess);  // deterministic: compared within half a code
  return 0.5 * n_l + 0.4 * lobe;
}

inline void expect_near(Vec3d a, Vec3d b, double tolerance = 6e-10) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(a.z, b.z, tolerance);
}

}  // namespace blysk
