// io/stl_layout.h - binary STL: 80 bytes of anything, a count, 50 bytes a triangle.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace blysk::io {

inline constexpr std::size_t kStlHeader = 84;
inline constexpr std::size_t kStlTriangle =
    50;  // normal, three corners (12 bytes each), 2 bytes of attributes

/// The count that a file of at least kStlHeader bytes gives.
inline std::uint32_t stl_count(std::span<const std::byte> bytes) {
  std::uint32_t count = 0;
  for (std::size_t i = 0; i < 4; ++i) count |= std::to_integer<std::uint32_t>(bytes[80 + i]) << (8 * i);
  return count;
}

/// Whether the count and the size agree: then it is binary whatever its header says.
inline bool has_stl_size(std::span<const std::byte> bytes) {
  return bytes.size() >= kStlHeader &&
         bytes.size() == kStlHeader + kStlTriangle * std::uint64_t{stl_count(bytes)};
}

}  // namespace blysk::io
