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

struct Faces {
  Array<std::uint32_t> sizes;    ///< corners of each face; empty: all are triangles
  Array<std::uint32_t> corners;  ///< indices of vertices, all in range, face after face
  Array<Vec4f> colors;           ///< linear RGBA of each face; empty: none

  [[nodiscard]] std::size_t count() const { return sizes.empty() ? corners.size() / 3 : sizes.size(); }

  /// Lets faces of other sizes follow.
  void begin_faces() {
    if (sizes.empty()) sizes.assign(corners.size() / 3, 3);
    ended_ = corners.size();
  }
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
                               std::vector<std::string>& problems, ThreadPool& pool);

/// "WHO uses vertex 9, but they count from 0 to 7": `text` is the index as the file has it.
[[nodiscard]] std::string no_such_vertex(const std::string& who, const std::string& text,
                                         std::uint64_t vertices);

/// "there are 8 vertices, but no faces", which a reader says of such a file.
[[nodiscard]] std::string no_faces(std::uint64_t vertices);

/// Puts the mesh into the scene, with a default material, unless it has no triangles.
void add_mesh(Scene& scene, Mesh mesh);

}  // namespace blysk::io
