// Pictures to files: the choice of format, PPM, PFM, and floats made visible.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <new>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "blysk/image.h"
#include "image/atomic_file.h"
#include "image/png.h"

namespace blysk {
namespace {

static_assert(std::endian::native == std::endian::little, "PFM is written as the floats lie in memory");

using Bytes = Array<std::uint8_t>;

constexpr std::pair<std::string_view, PictureFormat> kExtensions[] = {
    {".png", PictureFormat::png}, {".ppm", PictureFormat::ppm}, {".pfm", PictureFormat::pfm}};

std::string lower(std::string_view text) {
  std::string t(text);
  for (char& c : t) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return t;
}

bool has_sides(int width, int height) {
  return width >= 1 && width <= kMaxPictureSide && height >= 1 && height <= kMaxPictureSide;
}

std::size_t area(int width, int height) {
  return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
}

Error bad_picture(int width, int height, const std::string& path) {
  return Error{.code = ErrorCode::usage,
               .message = "cannot write a picture of " + std::to_string(width) + " x " +
                          std::to_string(height) + " pixels; give it 1 to " +
                          std::to_string(kMaxPictureSide) + " a side, and all its pixels",
               .source = path};
}

Bytes with_header(const std::string& header, std::size_t size) {
  Bytes out(header.size() + size);
  std::memcpy(out.data(), header.data(), header.size());
  return out;
}

std::string sides(int width, int height) {
  return std::to_string(width) + " " + std::to_string(height) + "\n";
}

Bytes encode_ppm(const Image& image) {
  const std::string header = "P6\n" + sides(image.width, image.height) + "255\n";
  Bytes out = with_header(header, 3 * image.pixels.size());
  std::uint8_t* to = out.data() + header.size();
  for (const std::uint32_t pixel : image.pixels) {
    for (int shift = 0; shift < 24; shift += 8) *to++ = static_cast<std::uint8_t>(pixel >> shift);
  }
  return out;
}

// The scale of -1 says little endian; the first row in the file is the lowest.
Bytes encode_pfm(const FloatImage& image) {
  const std::string header =
      (image.channels == 3 ? "PF\n" : "Pf\n") + sides(image.width, image.height) + "-1.0\n";
  Bytes out = with_header(header, image.values.size() * sizeof(float));
  const std::size_t row = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.channels);
  std::uint8_t* to = out.data() + header.size();
  for (std::size_t y = static_cast<std::size_t>(image.height); y-- > 0; to += row * sizeof(float)) {
    std::memcpy(to, image.values.data() + y * row, row * sizeof(float));
  }
  return out;
}

FloatImage to_floats(const Image& image) {
  FloatImage out{.width = image.width, .height = image.height, .channels = 3, .values = {}};
  out.values.resize(3 * image.pixels.size());
  float* to = out.values.data();
  for (const std::uint32_t pixel : image.pixels) {
    for (int shift = 0; shift < 24; shift += 8) *to++ = static_cast<float>(pixel >> shift & 0xff) / 255;
  }
  return out;
}

Image depth_to_gray(const FloatImage& depth) {
  float nearest = std::numeric_limits<float>::infinity(), farthest = -nearest;
  const auto shown = [](float d) { return std::isfinite(d) && d < 1; };
  for (const float d : depth.values) {
    if (!shown(d)) continue;
    nearest = std::min(nearest, d);
    farthest = std::max(farthest, d);
  }
  // In double, where no difference of floats overflows.
  const double range = static_cast<double>(farthest) - static_cast<double>(nearest);
  Image out;
  out.resize(depth.width, depth.height);
  for (std::size_t i = 0; i < out.pixels.size(); ++i) {
    const float d = depth.values[i];
    const double white = range > 0 ? (static_cast<double>(farthest) - static_cast<double>(d)) / range : 1;
    const std::uint32_t gray = shown(d) ? static_cast<std::uint32_t>(255 * white + 0.5) : 0;
    out.pixels[i] = 0xff000000 | gray * 0x10101;
  }
  return out;
}

Image normals_to_colors(const FloatImage& normals) {
  Image out;
  out.resize(normals.width, normals.height);
  const float* from = normals.values.data();
  for (std::uint32_t& pixel : out.pixels) {
    pixel = 0xff000000;
    for (int shift = 0; shift < 24; shift += 8) {
      const float v = *from++;
      // In this order what is not a number becomes -1.
      const float clamped = v > -1 ? std::min(v, 1.0f) : -1;
      pixel |= static_cast<std::uint32_t>((clamped + 1) * 127.5f + 0.5f) << shift;
    }
  }
  return out;
}

std::vector<Bytes> encode(const Image& image, PictureFormat format, const PictureOptions& options) {
  std::vector<Bytes> pieces;
  switch (format) {
    case PictureFormat::png:
      return encode_png_pieces(image, options);
    case PictureFormat::ppm:
      pieces.push_back(encode_ppm(image));
      break;
    case PictureFormat::pfm:
      pieces.push_back(encode_pfm(to_floats(image)));
      break;
  }
  return pieces;
}

std::vector<Bytes> encode(const FloatImage& image, PictureFormat format, PictureOptions options) {
  if (format == PictureFormat::pfm) {
    std::vector<Bytes> pieces;
    pieces.push_back(encode_pfm(image));
    return pieces;
  }
  options.alpha = false;
  return encode(image.channels == 1 ? depth_to_gray(image) : normals_to_colors(image), format, options);
}

bool is_writable(const FloatImage& image) {
  return has_sides(image.width, image.height) && (image.channels == 1 || image.channels == 3) &&
         image.values.size() == area(image.width, image.height) * static_cast<std::size_t>(image.channels);
}

template <class Picture>
Status write_any(const Picture& image, const std::string& path, PictureFormat format,
                 const PictureOptions& options) {
  if (!is_writable(image)) return bad_picture(image.width, image.height, path);
  if (options.compression < 1 || options.compression > 9) {
    return Error{.code = ErrorCode::usage,
                 .message = "compression " + std::to_string(options.compression) +
                            " is not known; give 1 (fast) to 9 (small)",
                 .source = path};
  }
  try {
    const std::vector<Bytes> bytes = encode(image, format, options);
    const std::vector<ByteSpan> pieces(bytes.begin(), bytes.end());
    return write_whole_file(path, pieces);
  } catch (const std::bad_alloc&) {
    return Error{.code = ErrorCode::limit,
                 .message = "not enough memory to encode the picture; make it smaller",
                 .source = path};
  }
}

}  // namespace

bool is_writable(const Image& image) {
  return has_sides(image.width, image.height) && image.pixels.size() == area(image.width, image.height);
}

Result<PictureFormat> picture_format(const std::string& path) {
  if (path == "-") return PictureFormat::png;
  const std::string name = lower(path);
  for (const auto& [extension, format] : kExtensions) {
    if (name.ends_with(extension)) return format;
  }
  return Error{.code = ErrorCode::usage,
               .message = "the name does not tell the picture format; end it in .png, .ppm or .pfm",
               .source = path};
}

Status write_picture(const Image& image, const std::string& path, PictureFormat format,
                     const PictureOptions& options) {
  return write_any(image, path, format, options);
}

Status write_picture(const FloatImage& image, const std::string& path, PictureFormat format,
                     const PictureOptions& options) {
  return write_any(image, path, format, options);
}

Status write_file(std::string_view bytes, const std::string& path) {
  const ByteSpan piece(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  return write_whole_file(path, {&piece, 1});
}

void discard_unfinished_pictures() noexcept { remove_unfinished_files(); }

}  // namespace blysk
