#include "io/decimal.h"

#include <gtest/gtest.h>

#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>

namespace blysk::io {
namespace {

struct Decimal {
  bool ok = false;
  float value = 0;
  std::size_t length = 0;
};

Decimal decimal(const std::string& text) {
  const std::string padded = text + "\n" + std::string(kTextPadding, '7');
  const char* at = padded.c_str();
  Decimal r;
  r.ok = read_float(at, r.value);
  r.length = static_cast<std::size_t>(at - padded.c_str());
  return r;
}

void expect_like_from_chars(const std::string& text) {
  float expected = 0;
  const auto got = std::from_chars(text.data(), text.data() + text.size(), expected);
  if (got.ec != std::errc()) return;
  const Decimal r = decimal(text);
  ASSERT_TRUE(r.ok) << text;
  ASSERT_EQ(std::bit_cast<std::uint32_t>(r.value), std::bit_cast<std::uint32_t>(expected)) << text;
  ASSERT_EQ(r.length, text.size()) << text;
}

std::string random_decimal(std::mt19937_64& random) {
  const auto below = [&](std::uint64_t n) { return random() % n; };
  std::string s = below(2) == 0 ? "-" : "";
  const std::uint64_t shape = below(8);
  const std::uint64_t before = shape == 0 ? 0 : shape == 1 ? below(24) : below(5);
  const std::uint64_t behind = shape == 2 ? 0 : shape == 3 ? below(24) : shape == 4 ? 17 : 1 + below(9);
  for (std::uint64_t i = 0; i < before; ++i) s += static_cast<char>('0' + below(10));
  if (behind > 0) s += '.';
  for (std::uint64_t i = 0; i < behind; ++i)
    s += static_cast<char>('0' + below(shape == 5 && i < 5 ? 1 : 10));
  if (before + behind == 0) s += '0';
  if (below(4) == 0) {
    s += below(2) == 0 ? "e" : "E";
    s += below(2) == 0 ? "-" : "";
    s += std::to_string(below(below(2) == 0 ? 8 : 50));
  }
  return s;
}

TEST(decimal, digits_of_every_length) {
  for (int count = 0; count <= 8; ++count) {
    for (const char behind : {'\n', ' ', '/', ':', '.', '\xff', '\x8a', '\0'}) {
      const std::string text =
          std::string("12345678").substr(0, static_cast<std::size_t>(count)) + behind + "99999999";
      const Digits d = read_digits(text.c_str());
      EXPECT_EQ(d.count, count);
      EXPECT_EQ(d.value, count == 0 ? 0u : static_cast<std::uint32_t>(std::stoul(text.substr(0, d.count))));
    }
  }
}

TEST(decimal, a_million_random_numbers_are_those_of_from_chars) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 1'000'000; ++i) expect_like_from_chars(random_decimal(random));
}

// Middles between two floats and their neighbours: where rounding twice goes wrong.
TEST(decimal, ties_round_once) {
  std::mt19937_64 random(2);
  char text[64];
  for (int i = 0; i < 100'000; ++i) {
    const auto bits = static_cast<std::uint32_t>(0x34000000 + random() % 0x20000000);
    const double middle = (static_cast<double>(std::bit_cast<float>(bits)) +
                           static_cast<double>(std::bit_cast<float>(bits + 1))) /
                          2;
    for (const double d : {middle, std::nextafter(middle, 0.0), std::nextafter(middle, 1e30)}) {
      for (const int precision : {15, 16, 17, 25}) {
        const auto end =
            std::to_chars(text, text + sizeof text, d, std::chars_format::general, precision).ptr;
        expect_like_from_chars(std::string(text, end));
      }
    }
  }
}

TEST(decimal, edges_of_the_range) {
  for (const char* text : {"0",
                           "-0",
                           "0.0",
                           "00000000.00000000",
                           "16777217",
                           "9007199254740993",
                           "340282346638528859811704183484516925440",
                           "1.17549435e-38",
                           "1.1754942e-38",
                           "1e-45",
                           "1.4e-45",
                           "3.4028235e38",
                           "5.",
                           ".5",
                           "1e22",
                           "1e-22",
                           "1e23",
                           "123456789012345678",
                           "12345678",
                           "123456789",
                           "0.12345678",
                           "0.123456789",
                           "0.000000000000000000000000001",
                           "1e+05",
                           "8e-001"}) {
    if (std::string(text).find('+') == std::string::npos) expect_like_from_chars(text);
    EXPECT_TRUE(decimal(text).ok) << text;
  }
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  EXPECT_EQ(decimal("1e40").value, kInfinity);
  EXPECT_EQ(decimal("-1e400").value, -kInfinity);
  EXPECT_EQ(decimal("1e99999999999999999999").value, kInfinity);
  EXPECT_EQ(decimal(std::string(400, '9')).value, kInfinity);
  EXPECT_EQ(decimal("1e-60").value, 0);
  EXPECT_EQ(decimal("1e-99999999999999999999").value, 0);
  EXPECT_EQ(decimal("0." + std::string(400, '0') + "1").value, 0);
  EXPECT_EQ(decimal("0." + std::string(400, '0') + "1e400").value, 0.1f);
  EXPECT_TRUE(std::signbit(decimal("-0.0").value));
}

TEST(decimal, words_for_numbers_that_are_none) {
  EXPECT_TRUE(std::isnan(decimal("nan").value));
  EXPECT_TRUE(std::isnan(decimal("-NaN").value));
  EXPECT_TRUE(std::isnan(decimal("1.#IND").value));
  EXPECT_TRUE(std::isnan(decimal("-1.#QNAN").value));
  EXPECT_EQ(decimal("inf").value, std::numeric_limits<float>::infinity());
  EXPECT_EQ(decimal("-Infinity").value, -std::numeric_limits<float>::infinity());
  EXPECT_EQ(decimal("-1.#INF").value, -std::numeric_limits<float>::infinity());
  EXPECT_EQ(decimal("-1.#INF00").length, 9u);
}

TEST(decimal, a_plus_sign_is_read) {
  EXPECT_EQ(decimal("+1.5").value, 1.5f);
  EXPECT_EQ(decimal("+1.5").length, 4u);
}

TEST(decimal, what_is_no_number) {
  for (const char* text : {"", " ", "-", "+", "+-1", "-+1", "--1", ".", "-.", "e5", ".e5", "x", "/1", "#"}) {
    const Decimal r = decimal(text);
    EXPECT_FALSE(r.ok) << text;
    EXPECT_EQ(r.length, 0u) << text;
  }
  EXPECT_EQ(decimal("1,5").length, 1u);
  EXPECT_EQ(decimal("1e").length, 1u);
  EXPECT_EQ(decimal("1.5.5").length, 3u);
  EXPECT_EQ(decimal("1.5e+").length, 3u);
}

}  // namespace
}  // namespace blysk::io
