// fuzz/load.h - loads hostile bytes and holds what comes of them to the promises of scene.h.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <string_view>

#include "blysk/model.h"

namespace blysk::fuzz {

inline void require(bool promise) {
  if (!promise) std::abort();
}

inline bool finite(Vec3f v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

inline void check(const Mesh& mesh) {
  const std::size_t vertices = mesh.positions.size();
  require(mesh.indices.size() % 3 == 0);
  for (const std::uint32_t index : mesh.indices) require(index < vertices);
  for (const std::size_t size : {mesh.normals.size(), mesh.colors.size(), mesh.texcoords.size(),
                                 mesh.texcoords1.size(), mesh.tangents.size()}) {
    require(size == 0 || size == vertices);
  }
  for (const Vec3f& p : mesh.positions) require(finite(p));
  for (const Vec3f& n : mesh.normals) require(std::abs(length(n) - 1) < 1e-2f);
}

inline int load(std::string_view name, const std::uint8_t* data, std::size_t size) {
  const std::span bytes(reinterpret_cast<const std::byte*>(data), size);
  Result<Scene> scene = load_model(bytes, name, {});
  if (!scene) {
    require(!scene.error().message.empty() && scene.error().message.find('\n') == std::string::npos);
    return 0;
  }
  require(scene->triangles() > 0);
  for (Mesh& mesh : scene->meshes) {
    check(mesh);
    make_normals(mesh, 30);
    check(mesh);
  }
  for (const Instance& instance : scene->instances) {
    require(instance.mesh < scene->meshes.size() && instance.material < scene->materials.size());
  }
  return 0;
}

}  // namespace blysk::fuzz
