#include "image/huffman.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <vector>

namespace blysk {
namespace {

std::vector<std::uint8_t> lengths_for(const std::vector<std::uint32_t>& frequencies, int limit) {
  std::vector<std::uint8_t> lengths(frequencies.size());
  huffman_lengths(frequencies, limit, lengths);
  return lengths;
}

// A complete code fills the unit interval: inflaters refuse others.
void expect_complete(const std::vector<std::uint8_t>& lengths, int limit) {
  unsigned used = 0;
  for (const std::uint8_t length : lengths) {
    ASSERT_LE(length, limit);
    if (length != 0) used += 1u << (limit - length);
  }
  EXPECT_EQ(used, 1u << limit);
}

TEST(huffman, optimal_where_the_limit_is_not_met) {
  EXPECT_EQ(lengths_for({5, 9, 0, 12, 13, 16, 45}, 15), (std::vector<std::uint8_t>{4, 4, 0, 3, 3, 3, 1}));
  EXPECT_EQ(lengths_for({1, 1}, 12), (std::vector<std::uint8_t>{1, 1}));
}

TEST(huffman, complete_within_the_limit) {
  for (const std::size_t symbols : {2u, 3u, 19u, 286u}) {
    for (const int limit : {9, 12, 15}) {
      std::vector<std::uint32_t> fibonacci(symbols, 1);  // the distribution of the longest codes
      for (std::size_t i = 2; i < symbols; ++i) {
        fibonacci[i] = std::min(fibonacci[i - 1] + fibonacci[i - 2], 1u << 31);
      }
      expect_complete(lengths_for(fibonacci, limit), limit);
      expect_complete(lengths_for(std::vector<std::uint32_t>(symbols, 7), limit), limit);
    }
  }
  std::vector<std::uint32_t> items(19, 1);
  for (std::size_t i = 0; i < items.size(); ++i) items[i] = 1u << i;
  expect_complete(lengths_for(items, 7), 7);
}

// RFC 1951, 3.2.2: the example with lengths (3, 3, 3, 3, 3, 2, 4, 4).
TEST(huffman, canonical_codes) {
  const std::vector<std::uint8_t> lengths = {3, 3, 3, 3, 3, 2, 4, 4};
  std::vector<std::uint16_t> codes(lengths.size());
  huffman_codes(lengths, codes);
  EXPECT_EQ(codes, (std::vector<std::uint16_t>{0b010, 0b110, 0b001, 0b101, 0b011, 0b00, 0b0111, 0b1111}));
}

}  // namespace
}  // namespace blysk
