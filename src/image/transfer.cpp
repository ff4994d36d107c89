#include "image/transfer.h"

#include <algorithm>
#include <bit>
#include <iterator>

namespace blysk {

#include "image/srgb_table.inc"

std::uint8_t encode_srgb(float linear) {
  const auto* above = std::partition_point(std::begin(kSrgbThresholds), std::end(kSrgbThresholds),
                                           [linear](float threshold) { return linear >= threshold; });
  return static_cast<std::uint8_t>(above - std::begin(kSrgbThresholds));
}

std::uint8_t encode_srgb_fast(float linear) {
  // In this order the comparisons send what is not a number to the lowest value.
  const float clamped = std::min(linear > kSrgbLowest ? linear : kSrgbLowest, kSrgbHighest);
  const std::uint32_t bits = std::bit_cast<std::uint32_t>(clamped);
  const std::uint32_t segment = kSrgbSegments[(bits - kSrgbLowestBits) >> 20];
  return static_cast<std::uint8_t>(((segment >> 16 << 9) + (segment & 0xffff) * (bits >> 12 & 0xff)) >> 16);
}

}  // namespace blysk
