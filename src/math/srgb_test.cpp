#include "math/srgb.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using blysk::srgb_to_linear;

namespace {
double by_libm(double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); }
}  // namespace

TEST(srgb, agrees_with_libm) {
  for (int i = 0; i <= 100000; ++i) {
    const double v = i / 100000.0;
    ASSERT_NEAR(srgb_to_linear(v), by_libm(v), 1e-15) << v;
  }
}

TEST(srgb, codes) {
  for (int i = 0; i < 256; ++i) {
    EXPECT_EQ(srgb_to_linear(static_cast<std::uint8_t>(i)), static_cast<float>(srgb_to_linear(i / 255.0)));
    EXPECT_NEAR(static_cast<double>(srgb_to_linear(static_cast<std::uint8_t>(i))), by_libm(i / 255.0), 1e-6);
  }
  EXPECT_EQ(srgb_to_linear(std::uint8_t{0}), 0.0f);
  EXPECT_EQ(srgb_to_linear(std::uint8_t{255}), 1.0f);
}

TEST(srgb, outside) {
  EXPECT_EQ(srgb_to_linear(-0.5), 0);
  EXPECT_EQ(srgb_to_linear(7.0), 1);
  EXPECT_EQ(srgb_to_linear(std::numeric_limits<double>::quiet_NaN()), 0);
}
