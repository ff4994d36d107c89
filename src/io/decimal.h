// io/decimal.h - decimal numbers out of text: fast, and exactly what std::from_chars gives.
//
// The functions look at whole words of memory: behind the text there must stand a byte that belongs to no
// number (a line feed, say) and kTextPadding readable bytes.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace blysk::io {

inline constexpr std::size_t kTextPadding = 16;

/// Up to eight digits and what they mean.
struct Digits {
  std::uint32_t value = 0;
  int count = 0;  ///< 0..8
};

inline constexpr std::uint64_t every_byte(std::uint64_t byte) { return byte * 0x0101010101010101u; }

inline std::uint64_t load_little_endian(const char* at) {
  std::uint64_t word;
  std::memcpy(&word, at, sizeof word);
  if constexpr (std::endian::native == std::endian::big) word = __builtin_bswap64(word);
  return word;
}

/// The digits at `at`, all eight bytes judged at once.
inline Digits read_digits(const char* at) {
  std::uint64_t word = load_little_endian(at) ^ every_byte('0');  // a digit becomes 0..9
  // The high bit of every byte that is no digit; a carry only disturbs bytes behind the first of those.
  const std::uint64_t others = ((word + every_byte(0x80 - 10)) | word) & every_byte(0x80);
  const int count = others == 0 ? 8 : std::countr_zero(others) / 8;
  if (count == 0) return {};
  word <<= 64 - 8 * count;  // leading zeros in place of what follows the digits
  word = word * 10 + (word >> 8);
  const std::uint64_t even = (word & 0x000000ff000000ffu) * (100 + (std::uint64_t{1'000'000} << 32));
  const std::uint64_t odd = (word >> 16 & 0x000000ff000000ffu) * (1 + (std::uint64_t{10'000} << 32));
  return {static_cast<std::uint32_t>((even + odd) >> 32), count};
}

/// Reads a number at `at` and moves `at` behind it: an optional sign, digits with an optional point, an
/// optional exponent; also nan, inf and the 1.#IND, 1.#INF of old Windows programs. Rounded to the nearest
/// float; beyond the range of float infinity or zero. False, with `at` where it was: there is no number.
bool read_float(const char*& at, float& value);

}  // namespace blysk::io
