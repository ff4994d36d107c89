#include "math/srgb_float.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "math/srgb.h"

namespace blysk {
namespace {

// The codes below lie on the straight part of the curve.
constexpr int kFirstCode = 11;

constexpr std::array<double, 256> kLinearOfCode = [] {
  std::array<double, 256> table{};
  for (std::size_t i = 0; i < table.size(); ++i) table[i] = srgb_to_linear(static_cast<double>(i) / 255);
  return table;
}();

}  // namespace

float srgb_to_linear(float value) {
  if (!(value > 0)) return 0;
  if (value >= 1) return 1;
  const double v = static_cast<double>(value);
  if (v <= 0.04045) return static_cast<float>(v / 12.92);
  // ((v + 0.055) / 1.055)^2.4 is the value at the nearest code times (1 + e)^2.4, whose series is cut where
  // terms stay below 2e-10.
  const int code = std::max(static_cast<int>(v * 255 + 0.5), kFirstCode);
  const double near = code / 255.0;
  const double e = (v - near) / (near + 0.055);
  const double factor = 1 + e * (2.4 + e * (1.68 + e * (0.224 + e * -0.0336)));
  return static_cast<float>(kLinearOfCode[static_cast<std::size_t>(code)] * factor);
}

}  // namespace blysk
