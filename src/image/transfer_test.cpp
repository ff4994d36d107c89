#include "image/transfer.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "math/srgb.h"

namespace blysk {
namespace {

constexpr std::uint32_t kOneBits = 0x3f800000;

float float_of(std::uint32_t bits) { return std::bit_cast<float>(bits); }

double curve(double x) { return 255 * (x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055); }

// A stride that is no divisor of the table's steps visits all of them at changing places.
template <class Visit>
void for_floats_to_one(std::uint32_t from, std::uint32_t stride, Visit visit) {
  for (std::uint32_t bits = from; bits < kOneBits; bits += stride) visit(float_of(bits));
  visit(1.0f);
}

TEST(encode_srgb, is_the_rounded_curve) {
  for_floats_to_one(0, 997, [](float x) {
    const double exact = curve(static_cast<double>(x));
    ASSERT_LE(std::abs(encode_srgb(x) - exact), 0.5 + 1e-6) << x;
  });
}

TEST(encode_srgb, corners) {
  for (const auto encode : {encode_srgb, encode_srgb_fast}) {
    EXPECT_EQ(encode(0), 0);
    EXPECT_EQ(encode(-0.0f), 0);
    EXPECT_EQ(encode(-1), 0);
    EXPECT_EQ(encode(1), 255);
    EXPECT_EQ(encode(2), 255);
    EXPECT_EQ(encode(std::numeric_limits<float>::denorm_min()), 0);
    EXPECT_EQ(encode(std::numeric_limits<float>::infinity()), 255);
    EXPECT_EQ(encode(-std::numeric_limits<float>::infinity()), 0);
    EXPECT_EQ(encode(std::numeric_limits<float>::quiet_NaN()), 0);
    EXPECT_EQ(encode(0.5f), 188);
  }
}

TEST(encode_srgb_fast, stays_near_the_curve_and_rises) {
  int last = 0;
  for_floats_to_one(0x38000000, 61, [&](float x) {
    const int code = encode_srgb_fast(x);
    ASSERT_LE(std::abs(code - curve(static_cast<double>(x))), 0.5401) << x;
    ASSERT_LE(std::abs(code - encode_srgb(x)), 1) << x;
    ASSERT_GE(code, last) << x;
    last = code;
  });
}

TEST(encode_srgb_fast, is_exact_below_the_table) {
  for (std::uint32_t bits = 0; bits < kSrgbLowestBits; bits += 100003) {
    ASSERT_EQ(encode_srgb(float_of(bits)), 0);
    ASSERT_EQ(encode_srgb_fast(float_of(bits)), 0);
  }
}

TEST(encode_srgb, is_the_inverse_of_decoding) {
  EXPECT_EQ(srgb_to_linear(std::uint8_t{0}), 0);
  EXPECT_EQ(srgb_to_linear(std::uint8_t{255}), 1);
  for (int code = 0; code < 256; ++code) {
    const float linear = srgb_to_linear(static_cast<std::uint8_t>(code));
    EXPECT_NEAR(curve(static_cast<double>(linear)), code, 1e-4);
    EXPECT_EQ(encode_srgb(linear), code);
    EXPECT_EQ(encode_srgb_fast(linear), code);
  }
}

}  // namespace
}  // namespace blysk
