// image/png_testing.h - PNG files of any kind for the tests, uncompressed.
#pragma once

#include <libdeflate.h>

#include <cstdint>
#include <string>
#include <string_view>

namespace blysk::testing_png {

inline std::string be32(std::uint32_t value) {
  std::string text;
  for (int shift = 24; shift >= 0; shift -= 8) text += static_cast<char>(value >> shift & 0xff);
  return text;
}

inline std::string chunk(const std::string& type, const std::string& body) {
  const std::string all = type + body;
  return be32(static_cast<std::uint32_t>(body.size())) + all +
         be32(libdeflate_crc32(0, all.data(), all.size()));
}

/// One stored block of up to 65535 bytes in a zlib stream.
inline std::string stored(const std::string& raw) {
  const auto size = static_cast<std::uint32_t>(raw.size());
  std::string text = "\x78\x01\x01";
  for (const std::uint32_t v : {size, ~size}) {
    text += static_cast<char>(v & 0xff);
    text += static_cast<char>(v >> 8 & 0xff);
  }
  return text + raw + be32(libdeflate_adler32(1, raw.data(), raw.size()));
}

struct Kind {
  std::uint32_t width, height;
  int depth, color_type;
  bool interlaced = false;
};

/// `rows` are the filtered rows as the kind asks for them; `chunks` stand before the pixels.
inline std::string png(const Kind& kind, const std::string& rows, const std::string& chunks = {}) {
  std::string header = be32(kind.width) + be32(kind.height);
  for (const int v : {kind.depth, kind.color_type, 0, 0, kind.interlaced ? 1 : 0})
    header += static_cast<char>(v);
  return "\x89PNG\r\n\x1a\n" + chunk("IHDR", header) + chunks + chunk("IDAT", stored(rows)) +
         chunk("IEND", "");
}

}  // namespace blysk::testing_png
