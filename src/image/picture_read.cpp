// Pictures out of memory: which format, how large, and PPM. PNG is in png_read.cpp.
#include "image/picture_read.h"

#include <algorithm>
#include <new>
#include <optional>
#include <utility>

namespace blysk {
namespace {

constexpr std::uint32_t kOpaque = 0xff000000;
constexpr std::size_t kLongestNumber = 9;  // digits, so that it fits into 32 bits

bool is_space(std::byte b) {
  const auto c = static_cast<char>(b);
  return c == ' ' || (c >= '\t' && c <= '\r');
}

bool looks_like_ppm(std::span<const std::byte> bytes) {
  return bytes.size() >= 3 && static_cast<char>(bytes[0]) == 'P' && static_cast<char>(bytes[1]) == '6' &&
         (is_space(bytes[2]) || static_cast<char>(bytes[2]) == '#');
}

// The numbers of a PPM's header, between which spaces and comments to the line's end may stand.
class Header {
 public:
  explicit Header(std::span<const std::byte> bytes) : bytes_(bytes) {}

  std::optional<std::uint32_t> number() {
    skip_spaces();
    std::uint32_t value = 0;
    std::size_t digits = 0;
    for (; at_ < bytes_.size() && digits <= kLongestNumber; ++at_, ++digits) {
      const auto c = static_cast<char>(bytes_[at_]);
      if (c < '0' || c > '9') break;
      value = value * 10 + static_cast<std::uint32_t>(c - '0');
    }
    if (digits == 0 || digits > kLongestNumber) return std::nullopt;
    return value;
  }

  // What follows the one space that ends the header.
  std::optional<std::span<const std::byte>> body() const {
    if (at_ >= bytes_.size() || !is_space(bytes_[at_])) return std::nullopt;
    return bytes_.subspan(at_ + 1);
  }

 private:
  void skip_spaces() {
    bool comment = false;
    for (; at_ < bytes_.size(); ++at_) {
      const auto c = static_cast<char>(bytes_[at_]);
      if (c == '#') comment = true;
      if (c == '\n' || c == '\r') comment = false;
      if (!comment && !is_space(bytes_[at_])) return;
    }
  }

  std::span<const std::byte> bytes_;
  std::size_t at_ = 2;  // behind "P6"
};

// One channel, rounded to 0..255.
std::uint32_t to_byte(std::uint32_t value, std::uint32_t most) {
  return (std::min(value, most) * 255 + most / 2) / most;
}

}  // namespace

Error broken_picture(const PictureSource& source, std::string message) {
  return {ErrorCode::input, std::move(message), source.name, 0};
}

Status check_picture_size(const PictureSource& source, std::uint64_t width, std::uint64_t height) {
  if (width == 0 || height == 0) return broken_picture(source, "the picture has no pixels");
  const std::string size = std::to_string(width) + "x" + std::to_string(height);
  if (std::max(width, height) > kMaxPictureSide || width * height > kMaxPixelsRead) {
    return Error{ErrorCode::limit,
                 "the picture is " + size + "; at most " + std::to_string(kMaxPictureSide) +
                     " pixels a side and " + std::to_string(kMaxPixelsRead) + " in all are read",
                 source.name, 0};
  }
  if (width * height * 4 > source.limits.max_memory) {
    return Error{ErrorCode::limit,
                 "the picture of " + size + " needs " + std::to_string(width * height * 4) +
                     " bytes of memory, more than the limit of " + std::to_string(source.limits.max_memory) +
                     "; raise --max-memory",
                 source.name, 0};
  }
  return Done{};
}

Result<Image> read_ppm(const PictureSource& source) {
  Header header(source.bytes);
  const auto width = header.number(), height = header.number(), most = header.number();
  const auto body = header.body();
  if (!width || !height || !most || !body || *most == 0 || *most > 65535) {
    return broken_picture(source,
                          "the PPM header is not \"P6 WIDTH HEIGHT MAXIMUM\", the maximum 1 to 65535");
  }
  if (const Status status = check_picture_size(source, *width, *height); !status) return status.error();
  const std::size_t channel_bytes = *most > 255 ? 2 : 1;
  const std::size_t needed = std::size_t{*width} * *height * 3 * channel_bytes;
  if (body->size() < needed) {
    return broken_picture(source, "the PPM ends after " + std::to_string(body->size()) + " of " +
                                      std::to_string(needed) + " bytes of pixels");
  }
  Image image;
  image.resize(static_cast<int>(*width), static_cast<int>(*height));
  const std::byte* from = body->data();
  for (std::uint32_t& pixel : image.pixels) {
    pixel = kOpaque;
    for (int shift = 0; shift < 24; shift += 8) {
      auto value = static_cast<std::uint32_t>(*from++);
      if (channel_bytes == 2) value = value << 8 | static_cast<std::uint32_t>(*from++);
      pixel |= to_byte(value, *most) << shift;
    }
  }
  return image;
}

Result<Image> read_picture(std::span<const std::byte> bytes, std::string_view name, const Limits& limits) {
  const PictureSource source = {.bytes = bytes, .name = std::string(name), .limits = limits};
  try {
    if (looks_like_png(bytes)) return read_png(source);
    if (looks_like_ppm(bytes)) return read_ppm(source);
  } catch (const std::bad_alloc&) {
    return Error{ErrorCode::limit, "there is not enough memory for the picture", source.name, 0};
  }
  return broken_picture(source, bytes.empty()
                                    ? "the file is empty"
                                    : "this is no picture that can be read; convert it to PNG or PPM (P6)");
}

}  // namespace blysk
