#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <set>

#include "blysk/metrics.h"
#include "image/testing.h"

namespace blysk {
namespace {

Image plain(int width, int height, std::uint32_t color) {
  Image image;
  image.resize(width, height);
  std::fill(image.pixels.begin(), image.pixels.end(), color);
  return image;
}

int lightness(std::uint32_t color) {
  return static_cast<int>(299 * (color & 0xff) + 587 * (color >> 8 & 0xff) + 114 * (color >> 16 & 0xff));
}

TEST(difference_picture, maps_the_largest_channel_to_rising_lightness) {
  const Image reference = plain(5, 3, 0xff646464);
  Image candidate = reference;
  candidate.pixels[1] = 0xff646465;
  candidate.pixels[2] = 0xff643c63;
  candidate.pixels[3] = 0x9b646464;
  candidate.pixels[4] = 0x37646464;
  const Result<Image> map = difference_picture(reference, candidate);
  ASSERT_TRUE(map);
  EXPECT_GT(map->width, 5);
  EXPECT_GE(map->height, 3);
  EXPECT_EQ(at(*map, 0, 0), 0xff000000);
  for (int x = 0; x < 4; ++x) EXPECT_LT(lightness(at(*map, x, 0)), lightness(at(*map, x + 1, 0))) << x;
  EXPECT_EQ(at(*map, 3, 2), 0xff000000);
}

TEST(difference_picture, every_level_has_its_own_colour) {
  const Image reference = plain(256, 2, 0);
  Image candidate = reference;
  for (int x = 0; x < 256; ++x) candidate.pixels[static_cast<std::size_t>(x)] = static_cast<std::uint32_t>(x);
  const Result<Image> map = difference_picture(reference, candidate);
  ASSERT_TRUE(map);
  std::set<std::uint32_t> colors;
  for (int x = 0; x < 256; ++x) colors.insert(at(*map, x, 0));
  EXPECT_EQ(colors.size(), 256u);
}

TEST(difference_picture, a_given_scale_compares_maps) {
  const Image black = plain(1, 1, 0), gray = plain(1, 1, 0x00090909), white = plain(1, 1, 0x00ffffff);
  EXPECT_EQ(at(*difference_picture(black, gray), 0, 0), at(*difference_picture(black, white), 0, 0));
  EXPECT_LT(lightness(at(*difference_picture(black, gray, 100), 0, 0)),
            lightness(at(*difference_picture(black, white, 100), 0, 0)));
  EXPECT_EQ(at(*difference_picture(black, gray, 9), 0, 0), at(*difference_picture(black, white, 9), 0, 0));
}

TEST(difference_picture, the_bar_holds_all_colours_and_labels) {
  for (const int difference : {1, 2, 3, 7, 40, 255}) {
    const Image reference = plain(30, 400, 0);
    const Result<Image> map =
        difference_picture(reference, plain(30, 400, static_cast<std::uint32_t>(difference)));
    ASSERT_TRUE(map);
    std::set<std::uint32_t> bar;
    for (int y = 8; y < 392; ++y) bar.insert(at(*map, 40, y));
    EXPECT_EQ(bar.size(), static_cast<std::size_t>(difference) + 1);
    EXPECT_EQ(at(*map, 40, 8), at(*map, 0, 0));
    EXPECT_EQ(at(*map, 40, 391), 0xff000000);
    EXPECT_GT(std::ranges::count(map->pixels, 0xffe8e8e8), 50);
  }
}

TEST(difference_picture, equal_and_tiny_pictures_have_a_bar_too) {
  const Result<Image> map = difference_picture(plain(1, 1, 7), plain(1, 1, 7));
  ASSERT_TRUE(map);
  EXPECT_EQ(at(*map, 0, 0), 0xff000000);
  EXPECT_GT(map->height, 60);
}

TEST(difference_picture, refuses_what_does_not_fit) {
  EXPECT_EQ(difference_picture(plain(2, 1, 0), plain(1, 2, 0)).error().code, ErrorCode::input);
  const Image wide = plain(kMaxPictureSide, 1, 0);
  EXPECT_EQ(difference_picture(wide, wide).error().code, ErrorCode::limit);
}

}  // namespace
}  // namespace blysk
