// blysk/model.h - reading model files: OBJ (MTL), STL, PLY, OFF, glTF 2.0 and GLB.
//
// The content tells the format; the extension only decides where content cannot.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "blysk/limits.h"
#include "blysk/result.h"
#include "blysk/scene.h"

namespace blysk {

struct ModelOptions {
  static constexpr double kCreaseDeg = 60;

  /// For files without normals, see make_normals(). Not given: kCreaseDeg, but faces of STL and glTF stay
  /// flat, as these formats mean them.
  std::optional<double> crease_deg = std::nullopt;
  bool may_be_empty =
      false;        ///< a file without triangles is a Scene too; Scene::problems says what it has instead
  int threads = 0;  ///< 0: one per processor
  Limits limits;
};

/// Reads a file; "-" is standard input; "shape:..." a built-in shape. Triangles that are degenerate or
/// not finite are left out and counted in Scene::problems. A broken file is ErrorCode::input with the
/// place, and so is one without a triangle, unless it may be empty; time and memory stay in proportion to the
/// file's size whatever it says of itself.
[[nodiscard]] Result<Scene> load_model(const std::string& path, const ModelOptions& options = {});

/// The same from memory. `name` stands in messages and gives the extension; `folder` is where files
/// named by the model (MTL, glTF buffers) are looked for; empty: they are not read.
[[nodiscard]] Result<Scene> load_model(std::span<const std::byte> bytes, std::string_view name,
                                       const std::filesystem::path& folder, const ModelOptions& options = {});

}  // namespace blysk
