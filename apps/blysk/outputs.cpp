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

// Ids as colours, the lowest byte in red.
Image id_image(const Frame& frame) {
  Image image;
  image.resize(frame.image.width, frame.image.height);
  std::ranges::transform(frame.id, image.pixels.begin(), [](std::uint32_t id) { return id | 0xff000000u; });
  return image;
}

FloatImage id_numbers(const Frame& frame) {
  FloatImage image;
  image.width = frame.image.width;
  image.height = frame.image.height;
  image.values.resize(frame.id.size());
  std::ranges::transform(frame.id, image.values.begin(),
                         [](std::uint32_t id) { return static_cast<float>(id); });
  return image;
}

Status write_id(const Frame& frame, const Outputs& outputs, PictureOptions options) {
  const std::string path = aov_path(outputs, "id");
  if (outputs.format == PictureFormat::pfm) {
    return write_picture(id_numbers(frame), path, PictureFormat::pfm, options);
  }
  options.alpha = false;
  return write_picture(id_image(frame), path, PictureFormat::png, options);
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

Result<Outputs> outputs_of(const Arguments& arguments) {
  Outputs outputs;
  if (!arguments.has("output")) {
    return usage_error("blysk render", "where shall the picture go? for example: -o picture.png");
  }
  outputs.path = arguments.text("output");
  const Result<PictureFormat> format = format_of(arguments, outputs.path);
  if (!format) return format.error();
  outputs.format = *format;

  if (const Value* aov = arguments.find("aov")) {
    for (const std::string& name : split(aov->text, ',')) {
      outputs.depth |= name == "depth";
      outputs.normal |= name == "normal";
      outputs.id |= name == "id";
    }
    if (outputs.to_stdout()) return usage_error("--aov", "stands beside a file, not beside standard output");
  }
  if (outputs.to_stdout()) {
    if (arguments.has("json")) return usage_error("--json", "cannot share standard output with the picture");
    return outputs;
  }
  if (const Status status = check_place(outputs.path); !status) return status.error();
  return outputs;
}

std::string aov_path(const Outputs& outputs, const std::string& aov) {
  std::filesystem::path path = outputs.path;
  path.replace_extension();
  return path.string() + "." + aov + (outputs.format == PictureFormat::pfm ? ".pfm" : ".png");
}

Status check_ids(std::uint64_t triangles, const Outputs& outputs) {
  if (!outputs.id || triangles <= kMaxId) return Done{};
  return Error{.code = ErrorCode::limit,
               .message = "pictures of ids hold " + count_text(kMaxId) + " triangles, the models have " +
                          count_text(triangles),
               .source = "--aov id"};
}

Status write_outputs(const Frame& frame, const Outputs& outputs, const PictureOptions& options) {
  const PictureFormat beside = outputs.format == PictureFormat::pfm ? PictureFormat::pfm : PictureFormat::png;
  if (const Status s = write_picture(frame.image, outputs.path, outputs.format, options); !s) return s;
  if (outputs.depth) {
    if (const Status s = write_picture(frame.depth, aov_path(outputs, "depth"), beside, options); !s)
      return s;
  }
  if (outputs.normal) {
    if (const Status s = write_picture(frame.normal, aov_path(outputs, "normal"), beside, options); !s)
      return s;
  }
  return outputs.id ? write_id(frame, outputs, options) : Status(Done{});
}

}  // namespace blysk::command
