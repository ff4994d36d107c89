// blysk/shapes.h - built-in models.
#pragma once

#include <string_view>
#include <vector>

#include "blysk/result.h"
#include "blysk/scene.h"

namespace blysk {

/// One parameter of a shape.
struct ShapeParameter {
  std::string_view name;
  double minimum, maximum, initial;
  std::string_view help;
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
/// the same bytes everywhere. Unknown names and keys, and values out of range, are ErrorCode::usage.
[[nodiscard]] Result<Scene> make_shape(std::string_view text);

}  // namespace blysk
