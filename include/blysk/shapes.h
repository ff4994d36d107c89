// blysk/shapes.h - built-in models.
//
// Shapes stand around the origin, +Y up, most of them inside the cube from -1 to 1. Fronts are
// counter-clockwise; solids are closed once vertices of equal position are welded. Normals are unit and exact
// where the surface is smooth. Texture coordinates lie in 0..1, u to the right and v up as seen from the
// front.
#pragma once

#include <string_view>
#include <vector>

#include "blysk/result.h"
#include "blysk/scene.h"

namespace blysk {

/// One parameter of a shape.
struct ShapeParameter {
  std::string_view name;
  double minimum, maximum, initial;  ///< both ends belong to the range
  std::string_view help;
  bool whole = true;  ///< only whole numbers
};

/// One built-in shape.
struct ShapeInfo {
  std::string_view name;
  std::string_view help;
  std::vector<ShapeParameter> parameters;
};

/// All shapes, in the order of their documentation.
[[nodiscard]] const std::vector<ShapeInfo>& shapes();

/// Makes a shape from "NAME?key=value&key=value" ("shape:" in front is allowed). The same text gives
/// the same bytes everywhere. Unknown names and keys, keys given twice, and values out of range are
/// ErrorCode::usage. No shape has more than 50 million triangles.
[[nodiscard]] Result<Scene> make_shape(std::string_view text);

}  // namespace blysk
