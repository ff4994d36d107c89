// outputs.h - the pictures that a frame is written as.
#pragma once

#include <cstdint>
#include <string>

#include "arguments.h"
#include "blysk/image.h"
#include "blysk/render.h"

namespace blysk::command {

/// Where a frame goes.
struct Outputs {
  std::string path;
  PictureFormat format = PictureFormat::png;
  bool depth = false, normal = false, id = false;
  bool to_stdout() const { return path == "-"; }
};

/// ErrorCode::output where no file can be written: a long work must not end in a folder that was never there.
[[nodiscard]] Status check_place(const std::string& path);

/// From --output, --format and --aov; tells wrong usage and folders that cannot be written before any work.
[[nodiscard]] Result<Outputs> outputs_of(const Arguments& arguments);

/// "name.depth.png" for "name.png".
[[nodiscard]] std::string aov_path(const Outputs& outputs, const std::string& aov);

/// ErrorCode::limit where more triangles are drawn than a picture of ids can tell apart.
[[nodiscard]] Status check_ids(std::uint64_t triangles, const Outputs& outputs);

/// Writes the picture and what stands beside it.
[[nodiscard]] Status write_outputs(const Frame& frame, const Outputs& outputs, const PictureOptions& options);

}  // namespace blysk::command
