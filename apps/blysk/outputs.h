// outputs.h - the pictures that a frame is written as.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "arguments.h"
#include "blysk/image.h"
#include "blysk/render.h"
#include "planes.h"

namespace blysk::command {

/// Where a frame goes.
struct Outputs {
  std::string path;
  PictureFormat format = PictureFormat::png;
  std::vector<std::string> planes;  ///< of --aov, each once
  std::vector<PlaneFormat> plane_formats;
  [[nodiscard]] bool to_stdout() const { return path == "-"; }
  [[nodiscard]] bool wants(std::string_view plane) const;
  [[nodiscard]] bool wants(PlaneFormat format) const;
};

/// ErrorCode::output where no file can be written: a long work must not end in a folder that was never there.
[[nodiscard]] Status check_place(const std::string& path);

/// From --output, --format and --aov; tells wrong usage and folders that cannot be written before any work.
[[nodiscard]] Result<Outputs> outputs_of(const Arguments& arguments);

/// "name.depth.png" for "name.png".
[[nodiscard]] std::string plane_path(const Outputs& outputs, std::string_view plane, PlaneFormat format);

/// Asks the renderer for what is to be written.
void want_planes(const Outputs& outputs, RenderOptions& options);

/// ErrorCode::limit where a plane cannot be written: more triangles than a picture of ids can tell apart, or
/// no room for the key of the fragments.
[[nodiscard]] Status check_planes(std::uint64_t triangles, const RenderOptions& options,
                                  const Outputs& outputs);

/// Writes the picture and what stands beside it.
[[nodiscard]] Status write_outputs(const Frame& frame, const Outputs& outputs, const PictureOptions& options);

}  // namespace blysk::command
