#include <gtest/gtest.h>

#include <limits>
#include <set>
#include <vector>

#include "blysk/fragments.h"
#include "image/testing.h"

namespace blysk {
namespace {

TEST(fragment_picture, colours_by_count_beside_a_key) {
  const std::vector<std::uint32_t> counts = {0, 1, 2, 3, 4, 5, 6, 4000000000u};
  const Result<Image> picture = fragment_picture(counts, 4);
  ASSERT_TRUE(picture);
  EXPECT_EQ(at(*picture, 0, 0), 0xff000000u);
  const auto channel = [&](int x, int y, int c) { return at(*picture, x, y) >> 8 * c & 255; };
  EXPECT_GT(channel(1, 0, 2), 2 * channel(1, 0, 0));  // blue
  EXPECT_GT(channel(2, 0, 1), 2 * channel(2, 0, 0));  // green
  EXPECT_GT(channel(3, 0, 0), 200u);                  // yellow
  EXPECT_GT(channel(3, 0, 1), 200u);
  EXPECT_GT(channel(0, 1, 0), 200u);  // orange
  EXPECT_LT(channel(0, 1, 1), channel(3, 0, 1));
  EXPECT_GT(channel(1, 1, 0), 4 * channel(1, 1, 1));  // red
  EXPECT_EQ(at(*picture, 1, 1), at(*picture, 2, 1));
  EXPECT_EQ(at(*picture, 1, 1), at(*picture, 3, 1));

  EXPECT_GT(picture->height, 2);
  std::set<std::uint32_t> shown, key;
  for (int y = 0; y < picture->height; ++y) {
    for (int x = 0; x < picture->width; ++x) (x < 4 && y < 2 ? shown : key).insert(at(*picture, x, y));
  }
  EXPECT_EQ(shown.size(), 6u);
  for (const std::uint32_t color : shown) EXPECT_TRUE(key.contains(color)) << color;
  EXPECT_EQ(key.size(), 8u);  // ground and ink besides
}

TEST(fragment_picture, refuses_what_is_no_picture_or_too_wide) {
  const std::vector<std::uint32_t> row(static_cast<std::size_t>(kMaxPictureSide));
  EXPECT_EQ(fragment_picture({row.data(), 7}, 2).error().code, ErrorCode::usage);
  EXPECT_EQ(fragment_picture({}, 1).error().code, ErrorCode::usage);
  EXPECT_EQ(fragment_picture({row.data(), 7}, 0).error().code, ErrorCode::usage);
  EXPECT_EQ(fragment_picture(row, kMaxPictureSide).error().code, ErrorCode::limit);
  const int widest = widest_fragment_picture();
  const Result<Image> picture = fragment_picture({row.data(), static_cast<std::size_t>(widest)}, widest);
  ASSERT_TRUE(picture);
  EXPECT_EQ(picture->width, kMaxPictureSide);
}

TEST(coverage_picture, is_gray) {
  FloatImage coverage;
  coverage.width = 6;
  coverage.height = 1;
  const float shares[] = {0, 0.5f, 1, -1, 2, std::numeric_limits<float>::quiet_NaN()};
  coverage.values.assign(std::begin(shares), std::end(shares));
  const Image picture = coverage_picture(coverage);
  const std::vector<std::uint32_t> wanted = {0xff000000, 0xff808080, 0xffffffff,
                                             0xff000000, 0xffffffff, 0xff000000};
  EXPECT_EQ(std::vector<std::uint32_t>(picture.pixels.begin(), picture.pixels.end()), wanted);
}

TEST(fragment_histogram, sums_and_quantiles) {
  const FragmentHistogram none;
  EXPECT_EQ(none.pixels(), 0u);
  EXPECT_EQ(none.mean(), 0);
  EXPECT_EQ(none.p99(), 0u);
  EXPECT_EQ(none.most(), 0u);
  const FragmentHistogram some{{{0, 50}, {2, 49}, {7, 1}}};
  EXPECT_EQ(some.pixels(), 100u);
  EXPECT_EQ(some.total(), 105u);
  EXPECT_EQ(some.mean(), 1.05);
  EXPECT_EQ(some.p99(), 2u);
  EXPECT_EQ(some.most(), 7u);
  EXPECT_EQ((FragmentHistogram{{{1, 97}, {9, 3}}}).p99(), 9u);
  EXPECT_EQ((FragmentHistogram{{{4, 1}}}).p99(), 4u);
}

}  // namespace
}  // namespace blysk
