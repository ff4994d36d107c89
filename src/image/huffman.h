// image/huffman.h - prefix codes of limited length, as deflate (RFC 1951) writes them.
#pragma once

#include <cstdint>
#include <span>

namespace blysk {

/// Code lengths for symbols of the given frequencies: 0 for those that do not occur, else 1..limit. At most
/// 288 symbols, of which at least two occur; 2^limit must exceed their number. Optimal unless the limit is
/// met.
void huffman_lengths(std::span<const std::uint32_t> frequencies, int limit, std::span<std::uint8_t> lengths);

/// The canonical codes of the lengths, bits reversed: deflate's streams take the first bit lowest.
void huffman_codes(std::span<const std::uint8_t> lengths, std::span<std::uint16_t> codes);

}  // namespace blysk
