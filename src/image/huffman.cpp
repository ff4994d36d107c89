#include "image/huffman.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace blysk {
namespace {

constexpr std::size_t kMaxSymbols = 288;
constexpr int kMaxLength = 15;

struct Leaf {
  std::uint32_t frequency;
  std::uint16_t symbol;
};

// Lengths of an unlimited code for leaves in ascending order; returns the longest. The two queues of the
// classical construction are the leaves and the inner nodes, which come out in ascending order by themselves.
int unlimited_lengths(std::span<const Leaf> leaves, std::span<std::uint8_t> lengths) {
  const std::size_t count = leaves.size();
  std::array<std::uint64_t, kMaxSymbols> weight;
  std::array<std::uint16_t, 2 * kMaxSymbols> parent;  // of leaves, then of inner nodes
  std::size_t leaf = 0, inner = 0;
  for (std::size_t made = 0; made + 1 < count; ++made) {
    weight[made] = 0;
    for (int child = 0; child < 2; ++child) {
      const bool take_leaf = leaf < count && (inner == made || leaves[leaf].frequency <= weight[inner]);
      weight[made] += take_leaf ? leaves[leaf].frequency : weight[inner];
      parent[take_leaf ? leaf++ : count + inner++] = static_cast<std::uint16_t>(count + made);
    }
  }
  std::array<std::uint8_t, 2 * kMaxSymbols> depth;
  depth[2 * count - 2] = 0;
  for (std::size_t node = 2 * count - 2; node-- > 0;) {
    depth[node] = static_cast<std::uint8_t>(depth[parent[node]] + 1);
  }
  for (std::size_t i = 0; i < count; ++i) lengths[leaves[i].symbol] = depth[i];
  return depth[0];
}

}  // namespace

void huffman_lengths(std::span<const std::uint32_t> frequencies, int limit, std::span<std::uint8_t> lengths) {
  std::fill(lengths.begin(), lengths.end(), std::uint8_t{0});
  std::array<Leaf, kMaxSymbols> storage;
  std::size_t count = 0;
  for (std::size_t s = 0; s < frequencies.size(); ++s) {
    if (frequencies[s] != 0) storage[count++] = {frequencies[s], static_cast<std::uint16_t>(s)};
  }
  const std::span leaves(storage.data(), count);
  std::sort(leaves.begin(), leaves.end(), [](const Leaf& a, const Leaf& b) {
    return a.frequency != b.frequency ? a.frequency < b.frequency : a.symbol < b.symbol;
  });
  // Halving flattens the distribution, in the end to a balanced code; the order stays ascending.
  while (unlimited_lengths(leaves, lengths) > limit) {
    for (Leaf& l : leaves) l.frequency = l.frequency / 2 + 1;
  }
}

void huffman_codes(std::span<const std::uint8_t> lengths, std::span<std::uint16_t> codes) {
  std::array<unsigned, kMaxLength + 2> next{};
  for (const std::uint8_t length : lengths) next[length + 1u] += length != 0;
  for (std::size_t length = 1; length < next.size(); ++length)
    next[length] = (next[length] + next[length - 1]) << 1;
  for (std::size_t s = 0; s < lengths.size(); ++s) {
    const int length = lengths[s];
    unsigned code = length == 0 ? 0 : next[static_cast<std::size_t>(length)]++;
    unsigned reversed = 0;
    for (int bit = 0; bit < length; ++bit, code >>= 1) reversed = reversed << 1 | (code & 1);
    codes[s] = static_cast<std::uint16_t>(reversed);
  }
}

}  // namespace blysk
