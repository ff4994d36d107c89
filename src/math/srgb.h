// math/srgb.h - the sRGB transfer function for colours of model files, without libm (IEC 61966-2-1).
#pragma once

#include <array>
#include <cstdint>

namespace blysk {

/// Linear light of an sRGB value 0..1; values outside are clamped, not a number gives 0.
/// Max error: 1e-15. Constant expressions and running programs give the same bits.
constexpr double srgb_to_linear(double value) {
  if (!(value > 0)) return 0;
  if (value >= 1) return 1;
  if (value <= 0.04045) return value / 12.92;
  // x^2.4 = x^2 * (x^2)^(1/5). Newton's method comes down to the fifth root from above.
  const double x = (value + 0.055) / 1.055;
  const double square = x * x;
  double root = 1;
  for (int i = 0; i < 60; ++i) {
    const double fourth = root * root * root * root;
    const double next = root - (root * fourth - square) / (5 * fourth);
    if (!(next < root)) break;
    root = next;
  }
  return square * root;
}

/// Linear light of an 8-bit sRGB code.
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
