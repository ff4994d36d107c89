// blysk/image.h - pictures in memory and in files.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "blysk/array.h"
#include "blysk/result.h"

namespace blysk {

/// Eight bits a channel, RGBA, straight (not premultiplied) alpha, row 0 at the top, no padding.
struct Image {
  int width = 0, height = 0;             ///< pixels, 1..16384
  Array<std::uint32_t> pixels;           ///< width * height; red in the low byte

  void resize(int w, int h) {
    width = w;
    height = h;
    pixels.resize(static_cast<std::size_t>(w) * static_cast<std::size_t>(h));
  }
};

/// One or three floats a pixel (depth; normals), row 0 at the top.
struct FloatImage {
  int width = 0, height = 0, channels = 1;  ///< channels 1 or 3, interleaved
  Array<float> values;
};

/// Transfer function of 8-bit pictures.
enum class Transfer {
  srgb,  ///< linear light is encoded by IEC 61966-2-1
  none   ///< 0..1 maps straight to 0..255, the papers' display-referred arithmetic
};

enum class PictureFormat { png, ppm, pfm };

/// How hard PNG tries: 1 fast (default) ... 9 small.
struct PictureOptions {
  int compression = 1;
  int threads = 0;       ///< 0: one per processor
  bool alpha = true;     ///< false: PNG without alpha channel
};

/// The format that a file name's extension asks for; ErrorCode::usage with the known ones if none.
[[nodiscard]] Result<PictureFormat> picture_format(const std::string& path);

/// Writes to a temporary name and renames: no half-written file is ever left, an existing one stays until
/// the new one is whole. "-" is standard output. PPM drops alpha. PFM stores linear floats.
[[nodiscard]] Status write_picture(const Image& image, const std::string& path, PictureFormat format,
                                   const PictureOptions& options = {});
[[nodiscard]] Status write_picture(const FloatImage& image, const std::string& path, PictureFormat format,
                                   const PictureOptions& options = {});

/// The bytes of a picture file.
[[nodiscard]] Array<std::uint8_t> encode_png(const Image& image, const PictureOptions& options = {});

/// SHA-256 of bytes, as 64 hexadecimal digits.
[[nodiscard]] std::string sha256(std::span<const std::uint8_t> bytes);
/// SHA-256 of "WIDTHxHEIGHT\n" and the RGBA bytes: the hash that `--json` and `verify` give.
[[nodiscard]] std::string sha256(const Image& image);

}  // namespace blysk
