// io/faces.h - the faces of a file, polygons of any size, on their way into a mesh.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "blysk/array.h"
#include "blysk/scene.h"
#include "io/reader.h"

namespace blysk::io {

inline constexpr std::uint32_t kBadIndex = 0xffffffff;  ///< stands for what cannot be an index

struct Faces {
  Array<std::uint32_t> sizes;    ///< corners of each face
  Array<std::uint32_t> corners;  ///< indices of vertices, face after face
  Array<Vec4f> colors;           ///< linear RGBA of each face; empty: none

  /// Ends a face of the corners that were pushed since the last one.
  void end_face() {
    sizes.push_back(static_cast<std::uint32_t>(corners.size() - ended_));
    ended_ = corners.size();
  }

 private:
  std::size_t ended_ = 0;
};

/// Turns the faces into the mesh's triangles, with the caller's limits, and leaves the bad ones out. Where
/// faces have colours, vertices are copied so that each face shows its own.
[[nodiscard]] Status add_faces(const Source& source, Faces faces, Mesh& mesh,
                               std::vector<std::string>& problems);

/// Puts the mesh into the scene, with a default material, unless it has no triangles.
void add_mesh(Scene& scene, Mesh mesh);

}  // namespace blysk::io
