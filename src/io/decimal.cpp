#include "io/decimal.h"

#include <charconv>
#include <cmath>
#include <limits>
#include <string_view>
#include <system_error>

namespace blysk::io {
namespace {

constexpr double kPowersOfTen[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                   1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
constexpr int kLargestExactPower = 22;
constexpr std::uint32_t kPowersOfTen32[] = {1, 10, 100, 1000, 10000, 100000, 1000000, 10000000, 100000000};
// As many digits always fit a signed 64-bit integer.
constexpr int kMostDigits = 18;

bool ends_word(char c) { return static_cast<unsigned char>(c) <= ' '; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

// Nearest float to digits * 10^power; false where that is in doubt.
//
// Both roundings to double together err by at most 2 units in the last place, so the float is right
// unless the double lies within 2 units of the middle between two floats; 4 are kept clear of.
bool scale(std::uint64_t digits, int power, float& value) {
  if (power < -kLargestExactPower || power > kLargestExactPower) return false;
  double d = static_cast<double>(static_cast<std::int64_t>(digits));
  d = power < 0 ? d / kPowersOfTen[-power] : d * kPowersOfTen[power];
  constexpr std::uint64_t kBelowFloat = (1u << 29) - 1, kMiddle = 1u << 28, kClear = 4;
  const std::uint64_t below = std::bit_cast<std::uint64_t>(d) & kBelowFloat;
  if (below - (kMiddle - kClear) <= 2 * kClear) return false;
  if (!(d >= 0x1p-126 && d < 0x1p127) && digits != 0) return false;
  value = static_cast<float>(d);
  return true;
}

// Exponent of ten of the first digit of a number that is not zero: 0 for 1..9.99. Saturates.
long long order_of_magnitude(std::string_view number) {
  constexpr long long kFar = 1'000'000'000;
  long long place = 0;
  bool point = false, started = false;
  std::size_t i = 0;
  for (; i < number.size() && (is_digit(number[i]) || number[i] == '.'); ++i) {
    if (number[i] == '.') {
      point = true;
    } else if (started) {
      place += point ? 0 : 1;
    } else {
      started = number[i] != '0';
      place -= point ? 1 : 0;
    }
  }
  long long exponent = 0;
  if (i < number.size()) {
    bool negative = false;
    for (++i; i < number.size(); ++i) {
      if (number[i] == '-') negative = true;
      if (is_digit(number[i]) && exponent < kFar) exponent = exponent * 10 + (number[i] - '0');
    }
    if (negative) exponent = -exponent;
  }
  return place + exponent;
}

// "1.#INF", "1.#IND", "1.#QNAN", "1.#SNAN": what is left behind the number 1. once it has been read.
bool read_windows_special(std::string_view rest, float& value) {
  if (!rest.starts_with('#')) return false;
  value = rest.starts_with("#INF") ? std::numeric_limits<float>::infinity()
                                   : std::numeric_limits<float>::quiet_NaN();
  return true;
}

bool read_slowly(const char*& at, float& value) {
  const char* begin = at;
  const bool negative = *begin == '-';
  if (negative || *begin == '+') ++begin;
  if (*begin == '-') return false;
  const char* end = begin;
  while (!ends_word(*end)) ++end;
  float read = 0;
  const std::from_chars_result got = std::from_chars(begin, end, read);
  if (got.ec == std::errc::invalid_argument) return false;
  if (got.ec == std::errc::result_out_of_range) {
    const std::string_view number(begin, static_cast<std::size_t>(got.ptr - begin));
    read = order_of_magnitude(number) > 0 ? std::numeric_limits<float>::infinity() : 0.0f;
  }
  at = got.ptr;
  if (read_windows_special({got.ptr, static_cast<std::size_t>(end - got.ptr)}, read)) at = end;
  value = negative ? -read : read;
  return true;
}

}  // namespace

bool read_float(const char*& at, float& value) {
  const char* p = at;
  const bool negative = *p == '-';
  p += negative ? 1 : 0;
  Digits part = read_digits(p);
  std::uint64_t digits = part.value;
  int count = digits == 0 ? 0 : part.count, power = 0;
  p += part.count;
  bool any = part.count > 0;
  if (part.count == 8 && is_digit(*p)) return read_slowly(at, value);
  if (*p == '.') {
    ++p;
    do {
      part = read_digits(p);
      if (count + part.count > kMostDigits) return read_slowly(at, value);
      digits = digits * kPowersOfTen32[part.count] + part.value;
      count += part.count;
      power -= part.count;
      p += part.count;
    } while (part.count == 8);
    any |= power < 0;
  }
  if ((*p | 0x20) == 'e') {
    const bool shrinks = p[1] == '-';
    p += shrinks || p[1] == '+' ? 2 : 1;
    const Digits exponent = read_digits(p);
    if (exponent.count == 0 || exponent.count == 8) return read_slowly(at, value);
    power += static_cast<int>(shrinks ? -exponent.value : exponent.value);
    p += exponent.count;
  }
  if (!any || !ends_word(*p)) return read_slowly(at, value);
  float magnitude = 0;
  if (!scale(digits, power, magnitude)) return read_slowly(at, value);
  value = negative ? -magnitude : magnitude;
  at = p;
  return true;
}

}  // namespace blysk::io
