#include "outputs.h"

#include <unistd.h>

#include <algorithm>
#include <filesystem>

#include "text.h"

namespace blysk::command {
namespace {

constexpr std::uint64_t kMaxId = (1u << 24) - 1;  // 24 bits of colour, and whole numbers that a float holds

Error output_error(const std::string& path, std::string message) {
  return {.code = ErrorCode::output, .message = std::move(message), .source = path};
}

bool may_write(const std::filesystem::path& path) { return ::access(path.c_str(), W_OK) == 0; }

Result<PictureFormat> format_of(const Arguments& arguments, const std::string& path) {
  if (!arguments.has("format")) return picture_format(path);
  const std::string name = arguments.text("format");
  return name == "png" ? PictureFormat::png : name == "ppm" ? PictureFormat::ppm : PictureFormat::pfm;
}

// From --aov and --aov-format.
Status read_planes(const Arguments& arguments, Outputs& outputs) {
  const Value* planes = arguments.find("aov");
  if (planes == nullptr) {
    return arguments.has("aov-format")
               ? Status(usage_error("--aov-format", "says how --aov is written; give it"))
               : Done{};
  }
  if (outputs.to_stdout()) return usage_error("--aov", "stands beside a file, not beside standard output");
  for (const std::string& name : split(planes->text, ',')) {
    if (!outputs.wants(name)) outputs.planes.push_back(name);
  }
  if (!arguments.has("aov-format")) {
    outputs.plane_formats = {outputs.format == PictureFormat::pfm ? PlaneFormat::pfm : PlaneFormat::png};
    return Done{};
  }
  for (const std::string& name : split(arguments.text("aov-format"), ',')) {
    if (!outputs.wants(plane_format(name))) outputs.plane_formats.push_back(plane_format(name));
  }
  return Done{};
}

}  // namespace

Status check_place(const std::string& path) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  const fs::path target = fs::weakly_canonical(fs::absolute(path, ignored), ignored);  // where a link leads
  if (target.empty()) return Done{};                                                   // writing will tell
  const fs::path folder = target.parent_path();
  if (fs::is_directory(target, ignored)) return output_error(path, "this is a folder; name a file in it");
  if (!fs::is_directory(folder, ignored)) {
    return output_error(path, "the folder " + folder.string() + " does not exist; create it first");
  }
  const bool there = fs::exists(target, ignored);
  const bool replaced = !there || fs::is_regular_file(target, ignored);  // else a device or a pipe
  if ((there && !may_write(target)) || (replaced && !may_write(folder))) {
    return output_error(path, "no permission to write there; choose another place");
  }
  return Done{};
}

// Calls with every plane's name, format and path, until one fails.
template <class Work>
Status for_each_plane(const Outputs& outputs, const Work& work) {
  for (const std::string& plane : outputs.planes) {
    for (const PlaneFormat format : outputs.plane_formats) {
      if (const Status s = work(plane, format, plane_path(outputs, plane, format)); !s) return s;
    }
  }
  return Done{};
}

Result<Outputs> outputs_of(const Arguments& arguments) {
  Outputs outputs;
  if (!arguments.has("output")) {
    return usage_error("blysk render", "where shall the picture go? for example: -o picture.png");
  }
  outputs.path = arguments.text("output");
  const Result<PictureFormat> format = format_of(arguments, outputs.path);
  if (!format) return format.error();
  outputs.format = *format;

  if (const Status status = read_planes(arguments, outputs); !status) return status.error();
  if (outputs.to_stdout()) {
    if (arguments.has("json")) return usage_error("--json", "cannot share standard output with the picture");
    return outputs;
  }
  if (const Status status = check_place(outputs.path); !status) return status.error();
  const Status planes = for_each_plane(
      outputs, [](const auto&, PlaneFormat, const std::string& path) { return check_place(path); });
  if (!planes) return planes.error();
  return outputs;
}

bool Outputs::wants(std::string_view plane) const { return std::ranges::find(planes, plane) != planes.end(); }

bool Outputs::wants(PlaneFormat plane_format) const {
  return std::ranges::find(plane_formats, plane_format) != plane_formats.end();
}

std::string plane_path(const Outputs& outputs, std::string_view plane, PlaneFormat format) {
  std::filesystem::path path = outputs.path;
  path.replace_extension();
  return path.string() + "." + std::string(plane) + "." + std::string(plane_format_name(format));
}

void want_planes(const Outputs& outputs, RenderOptions& options) {
  options.want_depth = outputs.wants("depth");
  options.want_normal = outputs.wants("normal");
  options.want_id = outputs.wants("id");
  options.want_fragments = outputs.wants("fragments");
  options.want_coverage = outputs.wants("coverage");
}

Status check_planes(std::uint64_t triangles, const RenderOptions& options, const Outputs& outputs) {
  const bool picture = outputs.wants(PlaneFormat::png);
  if (outputs.wants("id") && triangles > kMaxId && (picture || outputs.wants(PlaneFormat::pfm))) {
    return Error{.code = ErrorCode::limit,
                 .message = "pictures of ids hold " + count_text(kMaxId) + " triangles, the models have " +
                            count_text(triangles) + "; --aov-format csv holds them all",
                 .source = "--aov id"};
  }
  if (outputs.wants("fragments") && picture && options.width > widest_fragment_picture()) {
    return Error{.code = ErrorCode::limit,
                 .message = "beside a picture wider than " + std::to_string(widest_fragment_picture()) +
                            " there is no room for the key; take --aov-format csv or pfm",
                 .source = "--aov fragments"};
  }
  return Done{};
}

Status write_outputs(const Frame& frame, const Outputs& outputs, const PictureOptions& options) {
  // The picture last: where a plane cannot be written, an existing picture is as it was.
  const Status planes = for_each_plane(outputs, [&](const auto& plane, PlaneFormat format, const auto& path) {
    return write_plane(frame, plane, format, path, options);
  });
  if (!planes) return planes;
  return write_picture(frame.image, outputs.path, outputs.format, options);
}

}  // namespace blysk::command
