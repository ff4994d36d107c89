// bench/model_files.h - a mesh as the bytes of a model file, positions and triangles alone.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "blysk/scene.h"

namespace blysk::bench {

/// Format "obj", "stl" (binary), "ply" (binary) or "glb"; "shuffled.stl" has its triangles in no order,
/// "apart.stl" no two corners at one place, "colors.ply" colours of faces.
[[nodiscard]] std::vector<std::byte> model_file(const Mesh& mesh, std::string_view format);

}  // namespace blysk::bench
