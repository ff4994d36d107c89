// io/ply_header.h - the part of a PLY file that says what the rest is.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "io/reader.h"

namespace blysk::io {

enum class PlyFormat { ascii, little_endian, big_endian };
enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

[[nodiscard]] std::size_t size_of(PlyType type);
[[nodiscard]] bool is_integer(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::float32;  ///< of the value, or of a list's items
  bool is_list = false;
  PlyType count_type = PlyType::uint8;  ///< of a list's length
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;

  [[nodiscard]] bool has_lists() const;
  [[nodiscard]] std::size_t least_row_bytes(PlyFormat format) const;  ///< with every list empty
};

struct PlyHeader {
  PlyFormat format = PlyFormat::ascii;
  std::vector<PlyElement> elements;
  std::string texture;          ///< of a comment "TextureFile NAME"
  std::size_t data_offset = 0;  ///< of the first byte after the header
};

[[nodiscard]] Result<PlyHeader> read_ply_header(const Source& source);

}  // namespace blysk::io
