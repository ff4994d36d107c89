// image/picture_read.h - the decoders behind read_picture(), one file each.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "blysk/image.h"

namespace blysk {

/// A picture file in memory.
struct PictureSource {
  std::span<const std::byte> bytes;
  std::string name;  ///< for messages
  Limits limits;
};

[[nodiscard]] bool looks_like_png(std::span<const std::byte> bytes);
[[nodiscard]] Result<Image> read_png(const PictureSource& source);
[[nodiscard]] Result<Image> read_ppm(const PictureSource& source);

/// "NAME: message", ErrorCode::input.
[[nodiscard]] Error broken_picture(const PictureSource& source, std::string message);
/// The size that a header claims, asked before memory is taken: ErrorCode::limit where it is too large.
[[nodiscard]] Status check_picture_size(const PictureSource& source, std::uint64_t width,
                                        std::uint64_t height);

}  // namespace blysk
