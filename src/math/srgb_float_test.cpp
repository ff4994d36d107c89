#include "math/srgb_float.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "math/srgb.h"

namespace blysk {
namespace {

TEST(srgb_float, follows_the_curve_to_the_last_place) {
  float before = 0;
  // Every 97th float of 2^-30..1.
  for (std::uint32_t bits = std::bit_cast<std::uint32_t>(0x1p-30f); bits < 0x3f800000u; bits += 97) {
    const auto value = std::bit_cast<float>(bits);
    const float linear = srgb_to_linear(value);
    const auto exact = static_cast<float>(srgb_to_linear(static_cast<double>(value)));
    ASSERT_LE(std::abs(std::bit_cast<int>(linear) - std::bit_cast<int>(exact)), 1) << value;
    ASSERT_GE(linear, before) << value;
    before = linear;
  }
}

TEST(srgb_float, codes_are_exact) {
  for (int code = 0; code < 256; ++code) {
    const float linear = srgb_to_linear(static_cast<float>(code) / 255.0f);
    const float exact = srgb_to_linear(static_cast<std::uint8_t>(code));
    EXPECT_LE(std::abs(std::bit_cast<int>(linear) - std::bit_cast<int>(exact)), 2) << code;
  }
}

// These bits are a promise to every processor and compiler.
TEST(srgb_float, known_bits) {
  EXPECT_EQ(std::bit_cast<std::uint32_t>(srgb_to_linear(0.5f)), 0x3e5b2d9au);
  EXPECT_EQ(std::bit_cast<std::uint32_t>(srgb_to_linear(0.1f)), 0x3c2436c7u);
  EXPECT_EQ(std::bit_cast<std::uint32_t>(srgb_to_linear(0.02f)), 0x3acae5d8u);
}

TEST(srgb_float, clamps) {
  EXPECT_EQ(srgb_to_linear(-1.0f), 0);
  EXPECT_EQ(srgb_to_linear(0.0f), 0);
  EXPECT_EQ(srgb_to_linear(1.0f), 1);
  EXPECT_EQ(srgb_to_linear(255.0f), 1);
  EXPECT_EQ(srgb_to_linear(std::numeric_limits<float>::quiet_NaN()), 0);
  EXPECT_EQ(srgb_to_linear(std::numeric_limits<float>::infinity()), 1);
}

}  // namespace
}  // namespace blysk
