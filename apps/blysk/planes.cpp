#include "planes.h"

#include <algorithm>
#include <charconv>
#include <span>
#include <utility>

namespace blysk::command {
namespace {

constexpr std::pair<std::string_view, PlaneFormat> kFormats[] = {
    {"png", PlaneFormat::png}, {"pfm", PlaneFormat::pfm}, {"csv", PlaneFormat::csv}};

// Ids as colours, the lowest byte in red.
Image id_picture(const Frame& frame) {
  Image image;
  image.resize(frame.image.width, frame.image.height);
  std::ranges::transform(frame.id, image.pixels.begin(), [](std::uint32_t id) { return id | 0xff000000u; });
  return image;
}

FloatImage as_floats(std::span<const std::uint32_t> numbers, const Image& size) {
  FloatImage image;
  image.width = size.width;
  image.height = size.height;
  image.values.resize(numbers.size());
  std::ranges::transform(numbers, image.values.begin(),
                         [](std::uint32_t n) { return static_cast<float>(n); });
  return image;
}

// Numbers as short as they read back the same, `columns` of them a line.
template <class T>
std::string csv_of(std::span<const T> numbers, std::size_t columns) {
  std::string text;
  char number[32];
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    text.append(number, std::to_chars(number, number + sizeof number, numbers[i]).ptr);
    text += (i + 1) % columns == 0 ? '\n' : ',';
  }
  return text;
}

// A plane is floats or whole numbers.
const FloatImage* floats_of(const Frame& frame, std::string_view name) {
  if (name == "depth") return &frame.depth;
  if (name == "normal") return &frame.normal;
  return name == "coverage" ? &frame.coverage : nullptr;
}

const Array<std::uint32_t>& numbers_of(const Frame& frame, std::string_view name) {
  return name == "id" ? frame.id : frame.fragments;
}

Status write_png(const Frame& frame, std::string_view name, const std::string& path,
                 const PictureOptions& options) {
  if (name == "coverage") {
    return write_picture(coverage_picture(frame.coverage), path, PictureFormat::png, options);
  }
  if (name == "id") return write_picture(id_picture(frame), path, PictureFormat::png, options);
  if (name != "fragments") return write_picture(*floats_of(frame, name), path, PictureFormat::png, options);
  const Result<Image> picture = fragment_picture(frame.fragments, frame.image.width);
  return picture ? write_picture(*picture, path, PictureFormat::png, options) : Status(picture.error());
}

Status write_csv(const Frame& frame, std::string_view name, const std::string& path) {
  const auto width = static_cast<std::size_t>(frame.image.width);
  if (const FloatImage* floats = floats_of(frame, name)) {
    const std::size_t columns = width * static_cast<std::size_t>(floats->channels);
    return write_file(csv_of(std::span<const float>(floats->values), columns), path);
  }
  return write_file(csv_of(std::span<const std::uint32_t>(numbers_of(frame, name)), width), path);
}

}  // namespace

std::string_view plane_format_name(PlaneFormat format) {
  return std::ranges::find(kFormats, format, [](const auto& row) { return row.second; })->first;
}

PlaneFormat plane_format(std::string_view name) {
  return std::ranges::find(kFormats, name, [](const auto& row) { return row.first; })->second;
}

Status write_plane(const Frame& frame, std::string_view name, PlaneFormat format, const std::string& path,
                   PictureOptions options) {
  options.alpha = false;
  if (format == PlaneFormat::png) return write_png(frame, name, path, options);
  if (format == PlaneFormat::csv) return write_csv(frame, name, path);
  if (const FloatImage* floats = floats_of(frame, name)) {
    return write_picture(*floats, path, PictureFormat::pfm, options);
  }
  return write_picture(as_floats(numbers_of(frame, name), frame.image), path, PictureFormat::pfm, options);
}

}  // namespace blysk::command
