// blysk/image.h - pictures in memory and in files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "blysk/array.h"
#include "blysk/limits.h"
#include "blysk/result.h"

namespace blysk {

inline constexpr int kMaxPictureSide = 16384;                ///< pixels
inline constexpr std::uint64_t kMaxPixelsRead = 1ull << 26;  ///< of a picture file that is read

/// Eight bits a channel, RGBA, straight (not premultiplied) alpha, row 0 at the top, no padding.
struct Image {
  int width = 0, height = 0;    ///< pixels, 1..kMaxPictureSide
  Array<std::uint32_t> pixels;  ///< width * height; red in the low byte

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
  int compression = 1;  ///< 1..9
  int threads = 0;      ///< 0: one per processor
  bool alpha = true;    ///< false: PNG without alpha channel
};

/// The format that a file name's extension asks for, in either case; ErrorCode::usage with the known ones if
/// none.
/// "-", standard output, is PNG.
[[nodiscard]] Result<PictureFormat> picture_format(const std::string& path);

/// Reads a PNG of any kind or a PPM (P6), "-" is standard input; the content tells which. Bytes are taken as
/// they are, whatever the file says about gamma or colour profiles; 16 bits are rounded to 8. Broken files
/// are ErrorCode::input; more than kMaxPictureSide a side, kMaxPixelsRead in all, or limits.max_memory is
/// ErrorCode::limit. What a header claims is held against the file's bytes before memory is taken.
[[nodiscard]] Result<Image> read_picture(const std::string& path, const Limits& limits = {});
/// The same from memory; `name` stands in messages.
[[nodiscard]] Result<Image> read_picture(std::span<const std::byte> bytes, std::string_view name,
                                         const Limits& limits = {});

/// Writes to a temporary name in the same folder and renames: no half-written file is ever left, an existing
/// one stays until the new one is whole. Devices and pipes are written directly, "-" is standard output. PPM
/// drops alpha; PFM drops it too and stores each channel divided by 255, without decoding the transfer
/// function.
[[nodiscard]] Status write_picture(const Image& image, const std::string& path, PictureFormat format,
                                   const PictureOptions& options = {});

/// The same for floats, which PFM stores as they are. For PNG (without alpha) and PPM one channel is a depth,
/// shown as gray: of the finite values below 1 the nearest is white (255) and the farthest black (0),
/// linearly between; all others are black. Three channels are a normal: -1..1 becomes 0..255.
[[nodiscard]] Status write_picture(const FloatImage& image, const std::string& path, PictureFormat format,
                                   const PictureOptions& options = {});

/// Writes any bytes the way write_picture() does: a report beside its pictures, for example.
[[nodiscard]] Status write_file(std::string_view bytes, const std::string& path);

/// Removes the temporary files of the calls of write_picture that are under way (of 16 at once), which then
/// fail. For a handler of SIGINT or SIGTERM that ends the process: async-signal-safe.
void discard_unfinished_pictures() noexcept;

/// The bytes of a PNG file, independent of the number of threads; none if the image has no pixels or more
/// than kMaxPictureSide a side.
[[nodiscard]] Array<std::uint8_t> encode_png(const Image& image, const PictureOptions& options = {});

/// SHA-256 of bytes, as 64 hexadecimal digits.
[[nodiscard]] std::string sha256(std::span<const std::uint8_t> bytes);
/// SHA-256 of "WIDTHxHEIGHT\n" and the RGBA bytes: the hash that `--json` and `verify` give.
[[nodiscard]] std::string sha256(const Image& image);

}  // namespace blysk
