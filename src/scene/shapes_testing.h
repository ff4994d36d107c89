// scene/shapes_testing.h - what the tests of shapes ask of a mesh.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "blysk/scene.h"

namespace blysk::shape {

/// A mesh after vertices of equal position are made one.
struct Topology {
  std::size_t vertices = 0, edges = 0, triangles = 0;
  std::size_t border_edges = 0;  ///< of one triangle only
  std::size_t bad_edges = 0;     ///< of more than two, or of two that run the same way

  [[nodiscard]] bool closed() const { return border_edges == 0 && bad_edges == 0; }
  [[nodiscard]] long long euler() const {
    return static_cast<long long>(vertices) - static_cast<long long>(edges) +
           static_cast<long long>(triangles);
  }
};

inline Topology topology(const Mesh& mesh) {
  std::map<std::tuple<float, float, float>, std::uint32_t> welded;
  std::vector<std::uint32_t> vertex;
  for (const Vec3f& p : mesh.positions) {
    const auto next = static_cast<std::uint32_t>(welded.size());
    vertex.push_back(welded.try_emplace({p.x, p.y, p.z}, next).first->second);
  }
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::pair<int, int>> edges;  // uses upwards, downwards
  Topology t;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = vertex[mesh.indices[i + k]], b = vertex[mesh.indices[i + (k + 1) % 3]];
      auto& uses = edges[{std::min(a, b), std::max(a, b)}];
      (a < b ? uses.first : uses.second) += 1;
    }
  }
  for (const auto& [edge, uses] : edges) {
    t.border_edges += uses.first + uses.second == 1 ? 1 : 0;
    t.bad_edges += uses.first > 1 || uses.second > 1 ? 1 : 0;
  }
  t.vertices = welded.size();
  t.edges = edges.size();
  t.triangles = mesh.triangles();
  return t;
}

/// Triangles with two corners in one place.
inline std::size_t flat_triangles(const Mesh& mesh) {
  std::size_t flat = 0;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const auto at = [&](std::size_t k) { return mesh.positions[mesh.indices[i + k]]; };
    flat += at(0) == at(1) || at(1) == at(2) || at(2) == at(0) ? 1 : 0;
  }
  return flat;
}

/// FNV-1a, 64 bits, of the positions' and indices' bytes.
inline std::uint64_t hash(const Scene& scene) {
  std::uint64_t h = 0xCBF29CE484222325u;
  const auto add = [&h](const auto& values) {
    for (const std::byte b : std::as_bytes(std::span(values)))
      h = (h ^ std::to_integer<unsigned>(b)) * 0x100000001B3u;
  };
  for (const Mesh& mesh : scene.meshes) {
    add(mesh.positions);
    add(mesh.indices);
  }
  return h;
}

inline double area(const Mesh& mesh) {
  double sum = 0;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const auto at = [&](std::size_t k) { return to_double(mesh.positions[mesh.indices[i + k]]); };
    sum += length(cross(at(1) - at(0), at(2) - at(0))) / 2;
  }
  return sum;
}

/// Positive where fronts look outwards.
inline double volume(const Mesh& mesh) {
  double sum = 0;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const auto at = [&](std::size_t k) { return to_double(mesh.positions[mesh.indices[i + k]]); };
    sum += dot(at(0), cross(at(1), at(2))) / 6;
  }
  return sum;
}

/// Smallest cosine between a triangle's front and the normals at its corners.
inline double worst_normal(const Mesh& mesh) {
  double worst = 1;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const auto at = [&](std::size_t k) { return to_double(mesh.positions[mesh.indices[i + k]]); };
    const Vec3d front = normalize(cross(at(1) - at(0), at(2) - at(0)));
    for (std::size_t k = 0; k < 3; ++k) {
      worst = std::min(worst, dot(front, to_double(mesh.normals[mesh.indices[i + k]])));
    }
  }
  return worst;
}

}  // namespace blysk::shape
