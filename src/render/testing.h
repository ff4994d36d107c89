// render/testing.h - what tests of pictures share.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <initializer_list>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "blysk/render.h"
#include "blysk/shapes.h"
#include "core/random.h"

namespace blysk {

/// One sample a pixel, at its centre: what a method does is measured there.
inline RenderOptions center_options() {
  RenderOptions o;
  o.antialias = "none";
  return o;
}

/// Those of this size.
inline RenderOptions sized(int width, int height) {
  RenderOptions o = center_options();
  o.width = width;
  o.height = height;
  return o;
}

/// Kept for the whole program: a renderer's memory and threads are its costly part.
inline Renderer& shared_renderer(Isa isa, int threads = 1) {
  static std::map<std::pair<Isa, int>, std::unique_ptr<Renderer>> all;
  auto& renderer = all[{isa, threads}];
  if (!renderer) renderer = std::make_unique<Renderer>(RendererOptions{.threads = threads, .isa = isa});
  return *renderer;
}

/// Renders, and fails the test if there is no picture.
inline void render_to(Frame& frame, const Scene& scene, const RenderOptions& options, Isa isa = Isa::best,
                      int threads = 1) {
  const Status status = shared_renderer(isa, threads).render(scene, options, frame);
  ASSERT_TRUE(status) << status.error().text();
}

inline Frame render_frame(const Scene& scene, const RenderOptions& options, Isa isa = Isa::best,
                          int threads = 1) {
  Frame frame;
  render_to(frame, scene, options, isa, threads);
  return frame;
}

template <class T>
bool same_bytes(const Array<T>& a, const Array<T>& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

inline bool same(const Image& a, const Image& b) { return same_bytes(a.pixels, b.pixels); }

inline Scene shape_scene(const char* text) {
  Result<Scene> scene = make_shape(text);
  EXPECT_TRUE(scene) << scene.error().text();
  return scene ? std::move(*scene) : Scene{};
}

/// The same triangles in the opposite order: other runs, other lanes.
inline Scene turned(Scene scene) {
  for (Mesh& mesh : scene.meshes) {
    for (std::size_t a = 0, b = mesh.triangles(); a + 1 < b; ++a) {
      --b;
      for (std::size_t k = 0; k < 3; ++k) std::swap(mesh.indices[3 * a + k], mesh.indices[3 * b + k]);
    }
  }
  return scene;
}

inline Mesh mesh_of(const std::vector<Vec3f>& positions, const std::vector<std::uint32_t>& indices) {
  Mesh mesh;
  mesh.positions.assign(positions.begin(), positions.end());
  mesh.indices.assign(indices.begin(), indices.end());
  return mesh;
}

inline Scene scene_of(Mesh mesh, const Material& material = {}) {
  Scene scene;
  scene.add(std::move(mesh), material);
  return scene;
}

/// Orthographic, one world unit a pixel, the origin in the middle of the picture, world z -1..1 from far to
/// near.
inline Camera pixel_camera(int height) {
  Camera camera;
  camera.eye = {0, 0, 2};
  camera.target = {0, 0, 0};
  camera.height = height;
  camera.near_distance = 1;
  camera.far_distance = 3;
  return camera;
}

inline double uniform(Random& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random.unit());
}

/// Uniform in low..high, both included.
inline std::int64_t whole(Random& random, std::int64_t low, std::int64_t high) {
  return low + static_cast<std::int64_t>(random.next() % static_cast<std::uint64_t>(high - low + 1));
}

inline Vec3d random_direction(Random& random) {
  for (;;) {
    const Vec3d v = {uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1)};
    const double square = dot(v, v);
    if (square > 1e-3 && square <= 1) return v * (1 / std::sqrt(square));
  }
}

}  // namespace blysk
