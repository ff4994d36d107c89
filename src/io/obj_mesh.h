// io/obj_mesh.h - the lists of an OBJ file as meshes, one for each group and material.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "blysk/scene.h"
#include "io/obj_parse.h"

namespace blysk::io {

/// Faces that follow each other and share material and smoothing group.
struct ObjRun {
  std::size_t first_face = 0, end_face = 0;
  std::size_t first_corner = 0, end_corner = 0;
  std::uint32_t group = 0;  ///< smoothing group; 0: none
};

inline constexpr std::size_t kMostGroups = 1024;  ///< that are kept apart

/// What the last `o` before a face and the last `g` behind that say; empty: nothing.
struct ObjName {
  std::string_view object, group;
  friend auto operator<=>(const ObjName&, const ObjName&) = default;
};

/// The faces of one object's group that have one material.
struct ObjPart {
  ObjName name;
  std::string_view material;  ///< its name; empty: none was named
  std::vector<ObjRun> runs;
};

/// In the order of their first faces.
struct ObjParts {
  std::vector<ObjPart> parts;
  bool joined = false;  ///< there were more than kMostGroups groups: their names are forgotten
};
[[nodiscard]] ObjParts find_parts(const ObjFile& file);

/// Honours smoothing groups, in files that have any: corners without a normal get the mean of the faces of
/// their group around the vertex, weighted by area; faces outside all groups (`s off`, or before the first
/// `s`) get their own normal. Files that say `s off` only, or nothing, are left to make_normals().
void smooth_groups(ObjFile& file, const std::vector<ObjPart>& parts);

/// Normals as make_normals() gives them, but over all parts at once: a change of group or material is no
/// edge. For files of several parts without any normal; for others, and crease_deg 0, there are none. The
/// result has one index into file.normals for each corner of the parts' triangles.
[[nodiscard]] Array<std::uint32_t> crease_normals(ObjFile& file, const std::vector<ObjPart>& parts,
                                                  double crease_deg, int threads);

/// Meshes of the parts, without names. Vertices are the distinct combinations of indices; corners without a
/// normal in a mesh with normals get zero, for mend_normals(). `triangle_normals`: of crease_normals().
[[nodiscard]] std::vector<Mesh> make_meshes(ObjFile&& file, const std::vector<ObjPart>& parts,
                                            const Array<std::uint32_t>& triangle_normals);

}  // namespace blysk::io
