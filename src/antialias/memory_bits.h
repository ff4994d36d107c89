// antialias/memory_bits.h - memory of an A-buffer in the paper's layout, in bits.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

namespace blysk::antialias {

/// Mask, three colours of 8 bits, depth and two slopes of 24 bits (M_fr).
constexpr std::uint64_t fragment_bits(std::size_t samples) { return samples + 3 * 8 + 3 * 24; }

/// Of a slot among `pool` ones (M_adr).
constexpr std::uint64_t address_bits(std::uint64_t pool) {
  return pool <= 1 ? 0 : static_cast<std::uint64_t>(std::bit_width(pool - 1));
}

struct BufferShape {
  std::uint64_t pixels = 0;
  std::uint64_t main = 1, extra = 0;  ///< fragments of a pixel, and its addresses into the pool
  std::uint64_t pool = 0;             ///< slots that all pixels share
  std::size_t samples = 16;
};

/// With a common pool (M_pool).
constexpr std::uint64_t pooled_bits(const BufferShape& b) {
  const std::uint64_t fragment = fragment_bits(b.samples);
  return b.pixels * (b.main * fragment + b.extra * address_bits(b.pool)) + b.pool * fragment;
}

/// With room for as many fragments in every pixel (M_fix).
constexpr std::uint64_t fixed_bits(const BufferShape& b) {
  return b.pixels * (b.main + b.extra) * fragment_bits(b.samples);
}

/// What the common pool saves, as a factor; below 1 it costs.
constexpr double memory_ratio(const BufferShape& b) {
  return static_cast<double>(fixed_bits(b)) / static_cast<double>(pooled_bits(b));
}

/// Multisampling: a colour and a depth of 24 bits each for every sample.
constexpr std::uint64_t multisample_bits(std::uint64_t pixels, std::size_t samples) {
  return pixels * samples * 48;
}

}  // namespace blysk::antialias
