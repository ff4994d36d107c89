// io/obj_parse.h - what an OBJ file says, before it is made into meshes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "blysk/array.h"
#include "blysk/result.h"
#include "blysk/vector.h"
#include "io/obj_text.h"
#include "io/reader.h"

namespace blysk::io {

/// A statement that says something about the faces that follow it.
struct ObjEvent {
  enum class Kind { material, smoothing, object, group, library };
  Kind kind = Kind::material;
  std::size_t face = 0;   ///< the first face it is said of
  std::string_view text;  ///< what follows the keyword, in the text of the file
};

/// Statements that are left out.
struct ObjOmissions {
  std::size_t short_faces = 0;       ///< fewer than three corners
  std::size_t first_short_face = 0;  ///< offset in the file, as the next one
  std::size_t points = 0;
  std::size_t lines = 0;
  std::size_t unknown = 0;  ///< keywords that nothing here knows
  std::size_t first_unknown = 0;
  std::string_view first_keyword;
  bool texcoords = false;  ///< faces name texture coordinates, the file has none at all
  bool normals = false;    ///< likewise
};

/// The file's lists, indices from 0.
struct ObjFile {
  static constexpr std::uint32_t kNone = 0xffffffff;

  Array<Vec3f> positions;
  Array<Vec4f> colors;  ///< one per position, linear; empty: the file has none
  Array<Vec2f> texcoords;
  Array<Vec3f> normals;       ///< unit; zero where the file's is none
  bool zero_normals = false;  ///< there is one of these

  std::size_t faces = 0;
  Array<std::uint32_t> face_sizes;        ///< corners of each face, 3 or more; empty: all are triangles
  Array<std::uint32_t> corner_positions;  ///< of all faces, one after the other
  Array<std::uint32_t> corner_texcoords;  ///< one per corner, kNone where there is none; empty: none at all
  Array<std::uint32_t> corner_normals;    ///< likewise
  std::vector<ObjEvent> events;           ///< in the order of the file
  ObjOmissions omissions;
};

/// Reads all statements, on several threads where the text is large. May mend `text`, which must stay.
[[nodiscard]] Result<ObjFile> parse_obj(const Source& source, ObjText& text);

}  // namespace blysk::io
