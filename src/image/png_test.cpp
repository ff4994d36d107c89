#include <gtest/gtest.h>
#include <libdeflate.h>

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "blysk/image.h"

namespace blysk {
namespace {

std::uint32_t get_u32(const std::uint8_t* p) {
  return std::uint32_t{p[0]} << 24 | std::uint32_t{p[1]} << 16 | std::uint32_t{p[2]} << 8 | p[3];
}

// The simplest decoder that takes nothing on trust: chunks, checksums, stream, filters. Empty on the first
// flaw.
Image decode(const Array<std::uint8_t>& file) {
  const std::uint8_t signature[8] = {137, 80, 78, 71, 13, 10, 26, 10};
  if (file.size() < 8 || std::memcmp(file.data(), signature, 8) != 0) return {};
  std::vector<std::uint8_t> header, stream;
  std::string order;
  for (std::size_t at = 8; at < file.size();) {
    if (file.size() - at < 12) return {};
    const std::size_t size = get_u32(&file[at]);
    if (file.size() - at - 12 < size) return {};
    if (libdeflate_crc32(0, &file[at + 4], size + 4) != get_u32(&file[at + 8 + size])) return {};
    const std::string type(reinterpret_cast<const char*>(&file[at + 4]), 4);
    order += type[1];
    auto& to = type == "IHDR" ? header : stream;
    to.insert(to.end(), file.begin() + static_cast<long>(at + 8),
              file.begin() + static_cast<long>(at + 8 + size));
    at += 12 + size;
  }
  if (order.size() < 3 || header.size() != 13) return {};
  std::string expected(order.size(), 'D');
  expected.front() = 'H';
  expected.back() = 'E';
  if (order != expected) return {};
  if (header[8] != 8 || (header[9] != 2 && header[9] != 6) || header[10] + header[11] + header[12] != 0)
    return {};
  const std::size_t width = get_u32(&header[0]), height = get_u32(&header[4]), bytes = header[9] == 6 ? 4 : 3;
  const std::size_t row = width * bytes;
  std::vector<std::uint8_t> raw((row + 1) * height);
  libdeflate_decompressor* decompressor = libdeflate_alloc_decompressor();
  std::size_t used = 0;
  const libdeflate_result result = libdeflate_zlib_decompress_ex(decompressor, stream.data(), stream.size(),
                                                                 raw.data(), raw.size(), &used, nullptr);
  libdeflate_free_decompressor(decompressor);
  if (result != LIBDEFLATE_SUCCESS || used != stream.size()) return {};
  Image image;
  image.resize(static_cast<int>(width), static_cast<int>(height));
  for (std::size_t y = 0; y < height; ++y) {
    std::uint8_t* line = &raw[y * (row + 1) + 1];
    if (line[-1] == 2) {
      for (std::size_t i = 0; i < row && y > 0; ++i)
        line[i] = static_cast<std::uint8_t>(line[i] + line[i - row - 1]);
    } else if (line[-1] != 0) {
      return {};
    }
    for (std::size_t x = 0; x < width; ++x) {
      std::uint32_t pixel = 0;
      std::memcpy(&pixel, line + x * bytes, bytes);
      image.pixels[y * width + x] = pixel;
    }
  }
  return image;
}

enum class Kind { flat, noise, ramps, stripes, mixed };

Image picture(Kind kind, int width, int height) {
  Image image;
  image.resize(width, height);
  std::uint32_t random = 1;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      random = random * 1664525 + 1013904223;
      const auto u = static_cast<std::uint32_t>(x), v = static_cast<std::uint32_t>(y);
      const std::uint32_t ramp = (u / 3 & 255) | (v / 2 & 255) << 8 | ((u + v) & 255) << 16 | 0xff000000;
      const std::uint32_t noise = random ^ random >> 15;
      std::uint32_t pixel = 0x80402010;
      if (kind == Kind::noise) pixel = noise;
      if (kind == Kind::ramps) pixel = ramp;
      if (kind == Kind::stripes) pixel = v % 2 == 0 ? 0xffffffff : u % 7 == 0 ? 0 : 0xff00ff00;
      if (kind == Kind::mixed) pixel = u * 3 < v ? 0 : noise % 11 == 0 ? noise : ramp;
      image.pixels[v * static_cast<std::uint32_t>(width) + u] = pixel;
    }
  }
  return image;
}

constexpr Kind kKinds[] = {Kind::flat, Kind::noise, Kind::ramps, Kind::stripes, Kind::mixed};

void expect_round_trip(const Image& image, const PictureOptions& options) {
  const Image back = decode(encode_png(image, options));
  ASSERT_EQ(back.width, image.width);
  ASSERT_EQ(back.height, image.height);
  const std::uint32_t mask = options.alpha ? 0xffffffff : 0x00ffffff;
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    ASSERT_EQ(back.pixels[i], image.pixels[i] & mask)
        << "pixel " << i << " of " << image.width << "x" << image.height;
  }
}

TEST(encode_png, gives_every_pixel_back) {
  const struct {
    int width, height;
  } sizes[] = {{1, 1},   {1, 300},   {2, 3},      {65, 2},    {86, 1},
               {300, 1}, {257, 129}, {1000, 200}, {16384, 9}, {1, 16384}};
  for (const auto [width, height] : sizes) {
    for (const Kind kind : kKinds) {
      const Image image = picture(kind, width, height);
      for (const bool alpha : {true, false}) expect_round_trip(image, {.alpha = alpha});
    }
  }
}

TEST(encode_png, every_compression_is_valid) {
  const Image image = picture(Kind::mixed, 300, 200);
  for (int compression = 1; compression <= 9; ++compression) {
    for (const bool alpha : {true, false})
      expect_round_trip(image, {.compression = compression, .alpha = alpha});
  }
}

// A run's length is cut into pieces of 3 to 258 bytes; no remainder may be left over.
TEST(encode_png, runs_of_every_length) {
  for (int width = 1; width <= 400; ++width) {
    Image image = picture(Kind::flat, width, 2);
    image.pixels[static_cast<std::size_t>(width) - 1] = 0x01020304;
    for (const bool alpha : {true, false}) expect_round_trip(image, {.alpha = alpha});
  }
}

TEST(encode_png, threads_do_not_show) {
  const Image image = picture(Kind::mixed, 1024, 700);
  for (const int compression : {1, 6}) {
    const Array<std::uint8_t> one = encode_png(image, {.compression = compression, .threads = 1});
    for (const int threads : {0, 2, 7}) {
      EXPECT_EQ(encode_png(image, {.compression = compression, .threads = threads}), one);
    }
  }
}

TEST(encode_png, sizes_stay_in_bounds) {
  EXPECT_LT(encode_png(picture(Kind::flat, 1920, 1080)).size(), 20'000u);
  // Noise is stored: 4 bytes a pixel, a byte a row, five a block of 65535, and chunks.
  EXPECT_LT(encode_png(picture(Kind::noise, 1000, 1000)).size(), 4'003'000u);
}

TEST(encode_png, nothing_for_no_picture) {
  EXPECT_TRUE(encode_png(Image{}).empty());
  Image torn = picture(Kind::flat, 4, 4);
  torn.pixels.pop_back();
  EXPECT_TRUE(encode_png(torn).empty());
  Image wide;
  wide.resize(kMaxPictureSide + 1, 1);
  EXPECT_TRUE(encode_png(wide).empty());
}

}  // namespace
}  // namespace blysk
