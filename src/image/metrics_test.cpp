#include "blysk/metrics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>
#include <limits>

namespace blysk {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Rgb {
  std::uint32_t r, g, b;
};

Image picture_of(std::initializer_list<Rgb> pixels, std::uint32_t alpha = 255) {
  Image image;
  image.resize(static_cast<int>(pixels.size()), 1);
  std::size_t i = 0;
  for (const Rgb& p : pixels) image.pixels[i++] = p.r | p.g << 8 | p.b << 16 | alpha << 24;
  return image;
}

// Values of the specification, section 13, R12.
TEST(compare, nmse_of_known_pictures) {
  const Image reference = picture_of({{255, 255, 255}, {64, 77, 90}, {128, 128, 128}, {10, 200, 30}});
  const struct {
    Image candidate;
    double nmse;
    const char* likeness;
  } cases[] = {
      {picture_of({{255, 254, 253}, {64, 78, 90}, {128, 128, 128}, {12, 199, 30}}), 3.62615048e-05,
       "look the same"},
      {picture_of({{250, 250, 250}, {64, 77, 90}, {128, 120, 128}, {10, 200, 33}}), 0.000487882064,
       "noticeably different"},
      {picture_of({{255, 255, 255}, {64, 77, 90}, {128, 128, 128}, {10, 195, 30}}), 8.24125109e-05,
       "look the same"},
      {picture_of({{255, 248, 255}, {64, 77, 90}, {128, 128, 128}, {10, 200, 30}}), 0.000161528521,
       "slight differences"},
      {picture_of({{255, 235, 255}, {64, 77, 90}, {128, 128, 128}, {10, 200, 30}}), 0.00131860017,
       "completely different"},
  };
  for (const auto& c : cases) {
    const Result<Difference> found = compare(reference, c.candidate);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->nmse, c.nmse, c.nmse * 1e-8);
    EXPECT_EQ(nmse_class(found->nmse), c.likeness);
  }
}

TEST(compare, counts_and_psnr) {
  const Image reference = picture_of({{100, 150, 200}, {0, 255, 10}});
  const Result<Difference> found = compare(reference, picture_of({{101, 150, 199}, {1, 254, 10}}));
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->nmse, 2.90644868e-5, 1e-13);
  EXPECT_NEAR(found->psnr_db, 10 * std::log10(255.0 * 255.0 * 6 / 4), 1e-12);
  EXPECT_EQ(found->max_difference, 1);
  EXPECT_EQ(found->different_pixels, 2u);
}

TEST(compare, equal_and_black_pictures) {
  const Image black = picture_of({{0, 0, 0}}), gray = picture_of({{9, 9, 9}});
  for (const Image& image : {black, gray}) {
    EXPECT_EQ(compare(image, image)->nmse, 0);
    EXPECT_EQ(compare(image, image)->psnr_db, kInfinity);
    EXPECT_EQ(compare(image, image)->different_pixels, 0u);
  }
  EXPECT_EQ(compare(black, gray)->nmse, kInfinity);
  EXPECT_EQ(nmse_class(kInfinity), "completely different");
}

TEST(compare, alpha_shows_in_the_difference_alone) {
  const Result<Difference> found = compare(picture_of({{1, 2, 3}}), picture_of({{1, 2, 3}}, 55));
  EXPECT_EQ(found->nmse, 0);
  EXPECT_EQ(found->max_difference, 200);
  EXPECT_EQ(found->different_pixels, 1u);
}

TEST(compare, refuses_other_sizes) {
  const Result<Difference> found = compare(picture_of({{1, 2, 3}}), picture_of({{1, 2, 3}, {1, 2, 3}}));
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().code, ErrorCode::input);
  EXPECT_NE(found.error().message.find("1x1"), std::string::npos);
  EXPECT_NE(found.error().message.find("2x1"), std::string::npos);
}

TEST(nmse_class, limits_belong_to_the_better_class) {
  EXPECT_EQ(nmse_class(0), "look the same");
  EXPECT_EQ(nmse_class(0.0001), "look the same");
  EXPECT_EQ(nmse_class(0.00025), "slight differences");
  EXPECT_EQ(nmse_class(0.001), "noticeably different");
  EXPECT_EQ(nmse_class(0.0010001), "completely different");
}

}  // namespace
}  // namespace blysk
