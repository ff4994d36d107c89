// planes.h - what is written beside a picture: one value a pixel each, as pictures or as numbers.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "blysk/render.h"

namespace blysk::command {

enum class PlaneFormat {
  png,  ///< to look at
  pfm,  ///< numbers as floats
  csv   ///< numbers as text: a line for each row of the picture
};
[[nodiscard]] std::string_view plane_format_name(PlaneFormat format);
[[nodiscard]] PlaneFormat plane_format(std::string_view name);  ///< one of the option table's

/// Writes one of the planes that --aov names, which the frame has.
[[nodiscard]] Status write_plane(const Frame& frame, std::string_view name, PlaneFormat format,
                                 const std::string& path, PictureOptions options);

}  // namespace blysk::command
