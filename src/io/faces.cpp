#include "io/faces.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "io/polygon.h"

namespace blysk::io {
namespace {

constexpr std::size_t kMostColorsSearched = 64;  // at one vertex; beyond it, copies are made without looking

// Writes the triangles of one face at `out`; returns their end.
class FaceCutter {
 public:
  explicit FaceCutter(const Array<Vec3f>& positions) : positions_(positions) {}

  std::uint32_t* cut(std::span<const std::uint32_t> face, std::uint32_t* out) {
    if (face.size() < 3) return out;
    if (face.size() == 3) return std::copy(face.begin(), face.end(), out);
    points_.clear();
    for (const std::uint32_t vertex : face) {
      points_.push_back(vertex < positions_.size() ? positions_[vertex] : Vec3f{});
    }
    local_.clear();
    triangulate({points_.data(), points_.size()}, local_);
    for (const std::uint32_t corner : local_) *out++ = face[corner];
    return out;
  }

 private:
  const Array<Vec3f>& positions_;
  Array<Vec3f> points_;
  Array<std::uint32_t> local_;
};

// Vertices of the old mesh in the colours of their faces: each pair once.
class Recolored {
 public:
  explicit Recolored(std::size_t vertices) { newest_.resize(vertices, kBadIndex); }

  Array<std::uint32_t> sources;  // per new vertex its old one
  Array<Vec4f> colors;

  std::uint32_t vertex(std::uint32_t old, const Vec4f& color) {
    std::size_t searched = 0;
    for (std::uint32_t v = newest_[old]; v != kBadIndex && searched < kMostColorsSearched;
         v = older_[v], ++searched) {
      if (colors[v] == color) return v;
    }
    const auto made = static_cast<std::uint32_t>(sources.size());
    sources.push_back(old);
    colors.push_back(color);
    older_.push_back(newest_[old]);
    newest_[old] = made;
    return made;
  }

 private:
  Array<std::uint32_t> newest_, older_;
};

template <class T>
void pick(Array<T>& values, const Array<std::uint32_t>& sources) {
  if (values.empty()) return;
  Array<T> picked;
  picked.resize(sources.size());
  for (std::size_t i = 0; i < sources.size(); ++i) picked[i] = values[sources[i]];
  values = std::move(picked);
}

void color_triangles(Mesh& mesh, const Faces& faces) {
  Recolored recolored(mesh.positions.size());
  std::uint32_t* corner = mesh.indices.data();
  for (std::size_t face = 0; face < faces.sizes.size(); ++face) {
    const std::uint32_t size = faces.sizes[face];
    for (std::uint32_t* end = corner + (size < 3 ? 0 : 3 * (std::size_t{size} - 2)); corner != end;
         ++corner) {
      if (*corner < mesh.positions.size()) {
        *corner = recolored.vertex(*corner, faces.colors[face]);
      } else {
        *corner = kBadIndex;
      }
    }
  }
  pick(mesh.positions, recolored.sources);
  pick(mesh.normals, recolored.sources);
  pick(mesh.texcoords, recolored.sources);
  mesh.colors = std::move(recolored.colors);
}

}  // namespace

Status add_faces(const Source& source, Faces faces, Mesh& mesh, std::vector<std::string>& problems) {
  std::uint64_t triangles = 0, too_small = 0;
  bool only_triangles = true;
  for (const std::uint32_t size : faces.sizes) {
    triangles += size < 3 ? 0 : size - 2;
    too_small += size < 3;
    only_triangles = only_triangles && size == 3;
  }
  const std::uint64_t per_corner = 4 + (faces.colors.empty() ? 0 : 64);
  if (Status s = check_limits(source, triangles, triangles * 3 * per_corner); !s) return s;
  if (too_small > 0) {
    problems.push_back("left out " + std::to_string(too_small) + " faces of fewer than three corners");
  }

  if (only_triangles) {
    mesh.indices = std::move(faces.corners);
  } else {
    mesh.indices.resize(3 * triangles);
    FaceCutter cutter(mesh.positions);
    std::uint32_t* out = mesh.indices.data();
    const std::uint32_t* face = faces.corners.data();
    for (const std::uint32_t size : faces.sizes) {
      out = cutter.cut({face, size}, out);
      face += size;
    }
  }
  if (!faces.colors.empty()) color_triangles(mesh, faces);
  drop_bad_triangles(mesh, problems);
  return Done{};
}

void add_mesh(Scene& scene, Mesh mesh) {
  if (mesh.indices.empty()) return;
  if (scene.materials.empty()) scene.materials.emplace_back();
  // Colours of vertices are the surface's whole colour.
  if (!mesh.colors.empty()) scene.materials[0].color = {1, 1, 1};
  Instance instance;
  instance.mesh = static_cast<std::uint32_t>(scene.meshes.size());
  instance.name = mesh.name;
  scene.meshes.push_back(std::move(mesh));
  scene.instances.push_back(std::move(instance));
}

}  // namespace blysk::io
