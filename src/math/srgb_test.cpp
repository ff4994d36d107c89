#include "math/srgb.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace blysk {
namespace {

double curve(double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); }

TEST(srgb, follows_the_curve_to_the_last_place) {
  float before = 0;
  for (int i = 0; i <= 100'000; ++i) {
    const float code = static_cast<float>(i) / 100'000.0f;
    const float linear = srgb_to_linear(code);
    const auto exact = static_cast<float>(curve(static_cast<double>(code)));
    const int difference = std::bit_cast<int>(linear) - std::bit_cast<int>(exact);
    ASSERT_LE(std::abs(difference), 1) << code;
    ASSERT_GE(linear, before) << code;
    before = linear;
  }
}

// These bytes are a promise to every processor and compiler.
TEST(srgb, known_bits) {
  EXPECT_EQ(std::bit_cast<std::uint32_t>(srgb_to_linear(0.5f)), 0x3e5b2d9au);
  EXPECT_EQ(std::bit_cast<std::uint32_t>(srgb_to_linear(0.1f)), 0x3c2436c7u);
  EXPECT_EQ(std::bit_cast<std::uint32_t>(srgb_to_linear(0.02f)), 0x3acae5d8u);
}

TEST(srgb, clamps) {
  EXPECT_EQ(srgb_to_linear(-1), 0);
  EXPECT_EQ(srgb_to_linear(0), 0);
  EXPECT_EQ(srgb_to_linear(1), 1);
  EXPECT_EQ(srgb_to_linear(255), 1);
  EXPECT_EQ(srgb_to_linear(std::numeric_limits<float>::quiet_NaN()), 0);
  EXPECT_EQ(srgb_to_linear(std::numeric_limits<float>::infinity()), 1);
}

}  // namespace
}  // namespace blysk
