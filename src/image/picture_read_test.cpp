#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>
#include <vector>

#include "blysk/image.h"
#include "image/png_testing.h"

namespace blysk {
namespace {

using namespace std::string_literals;
using testing_png::chunk;
using testing_png::png;
using Pixels = std::vector<std::uint32_t>;

Result<Image> read(const std::string& bytes, const Limits& limits = {}) {
  return read_picture(std::as_bytes(std::span(bytes)), "x", limits);
}

Pixels pixels_of(const std::string& bytes) {
  const Result<Image> image = read(bytes);
  EXPECT_TRUE(image) << image.error().text();
  return image ? Pixels(image->pixels.begin(), image->pixels.end()) : Pixels();
}

void expect_error(const std::string& bytes, ErrorCode code, const std::string& words) {
  const Result<Image> image = read(bytes);
  ASSERT_FALSE(image);
  EXPECT_EQ(image.error().code, code) << image.error().text();
  EXPECT_NE(image.error().text().find(words), std::string::npos) << image.error().text();
}

std::string bytes_of(const Array<std::uint8_t>& bytes) { return {bytes.begin(), bytes.end()}; }

Image gradient(int width, int height) {
  Image image;
  image.resize(width, height);
  std::uint32_t value = 12345;
  for (std::uint32_t& pixel : image.pixels) pixel = value = value * 1664525 + 1013904223;
  return image;
}

TEST(read_picture, gives_back_what_encode_png_wrote) {
  const Image image = gradient(97, 61);
  for (const int compression : {1, 6}) {
    for (const bool alpha : {true, false}) {
      const Result<Image> back =
          read(bytes_of(encode_png(image, {.compression = compression, .alpha = alpha})));
      ASSERT_TRUE(back) << back.error().text();
      ASSERT_EQ(back->width, 97);
      ASSERT_EQ(back->height, 61);
      for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        ASSERT_EQ(back->pixels[i], alpha ? image.pixels[i] : image.pixels[i] | 0xff000000);
      }
    }
  }
}

TEST(read_picture, png_of_every_color_type_and_depth) {
  // Two pixels each; a row begins with its filter, 0.
  EXPECT_EQ(pixels_of(png({2, 1, 1, 0}, "\0\x40"s)), (Pixels{0xff000000, 0xffffffff}));
  EXPECT_EQ(pixels_of(png({2, 1, 2, 0}, "\0\x60"s)), (Pixels{0xff555555, 0xffaaaaaa}));
  EXPECT_EQ(pixels_of(png({2, 1, 4, 0}, "\0\x1f"s)), (Pixels{0xff111111, 0xffffffff}));
  EXPECT_EQ(pixels_of(png({2, 1, 8, 0}, "\0\x12\x34"s)), (Pixels{0xff121212, 0xff343434}));
  EXPECT_EQ(pixels_of(png({2, 1, 16, 0}, "\0\x12\x00\xff\xff"s)), (Pixels{0xff121212, 0xffffffff}));
  EXPECT_EQ(pixels_of(png({2, 1, 8, 2}, "\0\x01\x02\x03\x04\x05\x06"s)), (Pixels{0xff030201, 0xff060504}));
  EXPECT_EQ(pixels_of(png({1, 1, 16, 2}, "\0\x10\x00\x20\xff\x30\x7f"s)), (Pixels{0xff302110}));
  EXPECT_EQ(pixels_of(png({2, 1, 8, 4}, "\0\x01\x02\x03\x04"s)), (Pixels{0x02010101, 0x04030303}));
  EXPECT_EQ(pixels_of(png({1, 1, 8, 6}, "\0\x01\x02\x03\x04"s)), (Pixels{0x04030201}));
  const std::string palette = chunk("PLTE", "\x01\x02\x03\x04\x05\x06");
  EXPECT_EQ(pixels_of(png({2, 1, 8, 3}, "\0\x01\x00"s, palette)), (Pixels{0xff060504, 0xff030201}));
  EXPECT_EQ(pixels_of(png({2, 1, 1, 3}, "\0\x40"s, palette + chunk("tRNS", "\x09"))),
            (Pixels{0x09030201, 0xff060504}));
  EXPECT_EQ(pixels_of(png({2, 1, 8, 0}, "\0\x12\x34"s, chunk("tRNS", "\0\x34"s))),
            (Pixels{0xff121212, 0x00343434}));
}

TEST(read_picture, png_interlaced) {
  // Of 2x2 pixels the first, sixth and seventh pass have some: the corner, the right one, the lower row.
  EXPECT_EQ(pixels_of(png({2, 2, 8, 0, true}, "\0\x01\0\x02\0\x03\x04"s)),
            (Pixels{0xff010101, 0xff020202, 0xff030303, 0xff040404}));
}

TEST(read_picture, bytes_are_taken_as_they_are) {
  const std::string chunks = chunk("gAMA", "\0\x01\x86\xa0"s) + chunk("tEXt", "Title\0words"s);
  EXPECT_EQ(pixels_of(png({1, 1, 8, 0}, "\0\x80"s, chunks)), (Pixels{0xff808080}));
}

TEST(read_picture, ppm) {
  EXPECT_EQ(pixels_of("P6\n2 1\n255\n\x01\x02\x03\xff\x00\x80"s), (Pixels{0xff030201, 0xff8000ff}));
  EXPECT_EQ(pixels_of("P6 # words 9\n#more\n1\t1 65535 \x10\x00\x20\xff\xff\xff"s), (Pixels{0xffff2110}));
  EXPECT_EQ(pixels_of("P6 1 1 3 \x00\x01\x09"s), (Pixels{0xffff5500}));
}

TEST(read_picture, refuses_broken_ppm) {
  for (const char* const bad :
       {"P6", "P6 ", "P6 1", "P6 1 1 ", "P6 1 1 0 abc", "P6 1 1 65536 abc", "P6 -1 1 255 abc",
        "P6 1 99999999999 255 abc", "P6 1 1 255", "P6 1 1 255x", "P6#"}) {
    const Result<Image> image = read(bad);
    ASSERT_FALSE(image) << bad;
    EXPECT_EQ(image.error().code, ErrorCode::input) << bad;
  }
  expect_error("P6 2 2 255 abc", ErrorCode::input, "after 3 of 12 bytes");
  expect_error("P6 16384 4096 255 abc", ErrorCode::input, "ends after");
}

TEST(read_picture, refuses_what_is_no_picture) {
  expect_error("", ErrorCode::input, "x: the file is empty");
  expect_error("solid part", ErrorCode::input, "PNG or PPM");
  expect_error("P3 1 1 255 1 2 3", ErrorCode::input, "P6");
}

TEST(read_picture, refuses_every_truncation_of_a_png) {
  const std::string whole = bytes_of(encode_png(gradient(20, 9)));
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const Result<Image> image = read(whole.substr(0, size));
    ASSERT_FALSE(image) << size;
    ASSERT_EQ(image.error().code, ErrorCode::input) << size;
    ASSERT_EQ(image.error().message.find('\n'), std::string::npos);
  }
}

TEST(read_picture, survives_every_flipped_byte) {
  const std::string whole = bytes_of(encode_png(gradient(9, 7)));
  for (std::size_t i = 0; i < whole.size(); ++i) {
    for (const int flip : {1, 0x80, 0xff}) {
      std::string bytes = whole;
      bytes[i] = static_cast<char>(bytes[i] ^ flip);
      const Result<Image> image = read(bytes);
      if (image) {
        EXPECT_EQ(image->pixels.size(), 63u);
      }
    }
  }
}

TEST(read_picture, limits_are_asked_before_memory) {
  expect_error(png({20000, 1, 8, 0}, "\0"s), ErrorCode::limit, "20000x1");
  expect_error(png({16384, 8192, 8, 0}, "\0"s), ErrorCode::limit, "16384x8192");
  expect_error(png({0x7fffffff, 0x7fffffff, 8, 0}, "\0"s), ErrorCode::limit, "at most 16384");
  expect_error(png({8192, 8192, 8, 6}, "\0"s), ErrorCode::input, "cannot hold 8192x8192");
  expect_error("P6 20000 1 255 abc", ErrorCode::limit, "20000x1");
  expect_error("P6 0 1 255 ", ErrorCode::input, "no pixels");
  const Result<Image> image = read(png({2, 1, 8, 0}, "\0\x12\x34"s), {.max_memory = 7});
  ASSERT_FALSE(image);
  EXPECT_EQ(image.error().code, ErrorCode::limit);
}

TEST(read_picture, files_that_are_not_there) {
  const Result<Image> missing = read_picture("/no/such/picture.png");
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().code, ErrorCode::input);
  EXPECT_EQ(read_picture("/").error().code, ErrorCode::input);
}

TEST(write_file, gives_the_bytes) {
  const std::string path = testing::TempDir() + "blysk-write-file.html";
  ASSERT_TRUE(write_file("<p>words\n", path));
  std::ifstream file(path, std::ios::binary);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(file), {}), "<p>words\n");
  std::filesystem::remove(path);
  EXPECT_EQ(write_file("", "/no/such/folder/x").error().code, ErrorCode::output);
}

// Willem van Schaik's PngSuite: files that come in pairs must give the same pixels.
class PngSuite : public testing::Test {
 protected:
  void SetUp() override {
    const std::filesystem::path models = BLYSK_MODELS;
    if (models.empty()) GTEST_SKIP() << "configure with -DBLYSK_MODELS=FOLDER to read PngSuite";
    folder_ = models / "textures" / "pngsuite";
  }
  Image picture(const std::string& name) const {
    Result<Image> image = read_picture((folder_ / (name + ".png")).string());
    EXPECT_TRUE(image) << image.error().text();
    return image ? std::move(*image) : Image();
  }
  std::filesystem::path folder_;
};

TEST_F(PngSuite, every_file_is_read) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder_)) {
    if (entry.path().extension() != ".png") continue;
    ++count;
    const Image image = picture(entry.path().stem().string());
    EXPECT_GE(image.width, 1);
    EXPECT_EQ(image.pixels.size(),
              static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
  }
  EXPECT_GT(count, 50);
}

TEST_F(PngSuite, interlacing_does_not_show) {
  for (const char* const kind :
       {"0g01", "0g02", "0g04", "0g08", "2c08", "3p01", "3p02", "3p04", "3p08", "4a08", "6a08"}) {
    EXPECT_EQ(picture("basi"s + kind).pixels, picture("basn"s + kind).pixels) << kind;
  }
  for (const char* const size : {"01", "02", "03", "04"}) {
    EXPECT_EQ(picture("s"s + size + "i3p01").pixels, picture("s"s + size + "n3p01").pixels) << size;
  }
  for (const char* const size : {"32", "33", "34", "35", "36", "37", "38", "39", "40"}) {
    EXPECT_EQ(picture("s"s + size + "i3p04").pixels, picture("s"s + size + "n3p04").pixels) << size;
  }
}

TEST_F(PngSuite, compression_does_not_show) {
  const Image stored = picture("z00n2c08");
  for (const char* const name : {"z03n2c08", "z06n2c08", "z09n2c08"})
    EXPECT_EQ(picture(name).pixels, stored.pixels);
}

TEST_F(PngSuite, backgrounds_do_not_show) {
  EXPECT_EQ(picture("bgan6a08").pixels, picture("bgwn6a08").pixels);
  EXPECT_EQ(picture("bgai4a08").pixels, picture("bgbn4a08").pixels);
}

TEST_F(PngSuite, transparent_colors) {
  const auto transparent = [](const Image& image) {
    return std::ranges::count_if(image.pixels, [](std::uint32_t p) { return p >> 24 == 0; });
  };
  EXPECT_EQ(transparent(picture("tp0n2c08")), 0);
  EXPECT_GT(transparent(picture("tbrn2c08")), 0);
  EXPECT_GT(transparent(picture("tp1n3p08")), 0);
  EXPECT_GT(transparent(picture("tbbn0g04")), 0);
}

}  // namespace
}  // namespace blysk
