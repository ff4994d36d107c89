// SHA-256 (FIPS 180-4).
#include "image/sha256.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "blysk/image.h"

namespace blysk {
namespace {

constexpr std::size_t kBlock = 64;

// FIPS 180-4, 5.3.3: the fractional parts of the square roots of the first eight primes.
constexpr Sha256State kInitial = {0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                  0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};

std::uint32_t load_big_endian(const std::uint8_t* from) {
  return std::uint32_t{from[0]} << 24 | std::uint32_t{from[1]} << 16 | std::uint32_t{from[2]} << 8 | from[3];
}

// The words of the message schedule are made as they are needed, sixteen at a time: w[i] of round t is W(t)
// for the last t with t % 16 = i.
std::uint32_t next_word(const std::uint32_t* w, std::size_t i) {
  const std::uint32_t w15 = w[(i + 1) % 16], w2 = w[(i + 14) % 16];
  const std::uint32_t s0 = std::rotr(w15, 7) ^ std::rotr(w15, 18) ^ w15 >> 3;
  const std::uint32_t s1 = std::rotr(w2, 17) ^ std::rotr(w2, 19) ^ w2 >> 10;
  return w[i] + s0 + w[(i + 9) % 16] + s1;
}

void add_block(Sha256State& state, const std::uint8_t* block) {
  std::uint32_t w[16];
  for (std::size_t i = 0; i < 16; ++i) w[i] = load_big_endian(block + 4 * i);
  auto [a, b, c, d, e, f, g, h] = state;
  for (std::size_t t = 0; t < 64; t += 16) {
#pragma GCC unroll 16
    for (std::size_t i = 0; i < 16; ++i) {
      if (t != 0) w[i] = next_word(w, i);
      const std::uint32_t s1 = std::rotr(e, 6) ^ std::rotr(e, 11) ^ std::rotr(e, 25);
      const std::uint32_t s0 = std::rotr(a, 2) ^ std::rotr(a, 13) ^ std::rotr(a, 22);
      const std::uint32_t t1 = h + s1 + ((e & f) ^ (~e & g)) + kSha256Rounds[t + i] + w[i];
      const std::uint32_t t2 = s0 + ((a & b) ^ (a & c) ^ (b & c));
      h = g;
      g = f;
      f = e;
      e = d + t1;
      d = c;
      c = b;
      b = a;
      a = t1 + t2;
    }
  }
  const Sha256State sum = {a, b, c, d, e, f, g, h};
  for (std::size_t i = 0; i < sum.size(); ++i) state[i] += sum[i];
}

class Hasher {
 public:
  void add(std::span<const std::uint8_t> bytes) {
    total_ += bytes.size();
    if (used_ != 0) {
      const std::size_t taken = std::min(bytes.size(), kBlock - used_);
      std::copy_n(bytes.begin(), taken, block_.begin() + static_cast<std::ptrdiff_t>(used_));
      used_ += taken;
      bytes = bytes.subspan(taken);
      if (used_ < kBlock) return;
      sha256_blocks(state_, block_.data(), 1);
    }
    const std::size_t whole = bytes.size() / kBlock;
    sha256_blocks(state_, bytes.data(), whole);
    used_ = bytes.size() % kBlock;
    std::copy_n(bytes.end() - static_cast<std::ptrdiff_t>(used_), used_, block_.begin());
  }

  // FIPS 180-4, 5.1.1: a one bit, zeros, and the length in bits as 64 bits fill the last block.
  std::string hex() {
    const std::uint64_t bits = total_ * 8;
    std::array<std::uint8_t, kBlock + 8> tail{0x80};
    const std::size_t zeros = (2 * kBlock - 9 - used_) % kBlock;
    for (std::size_t i = 0; i < 8; ++i) tail[1 + zeros + i] = static_cast<std::uint8_t>(bits >> (56 - 8 * i));
    add(std::span(tail).first(zeros + 9));
    std::string text;
    for (const std::uint32_t word : state_) {
      for (int shift = 28; shift >= 0; shift -= 4) text += "0123456789abcdef"[word >> shift & 15];
    }
    return text;
  }

 private:
  Sha256State state_ = kInitial;
  std::array<std::uint8_t, kBlock> block_;
  std::size_t used_ = 0;
  std::uint64_t total_ = 0;
};

std::span<const std::uint8_t> bytes_of(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

}  // namespace

void sha256_blocks_portable(Sha256State& state, const std::uint8_t* blocks, std::size_t count) {
  for (; count > 0; --count, blocks += kBlock) add_block(state, blocks);
}

void sha256_blocks(Sha256State& state, const std::uint8_t* blocks, std::size_t count) {
  static const bool fast = has_sha256_instructions();
  (fast ? sha256_blocks_native : sha256_blocks_portable)(state, blocks, count);
}

std::string sha256(std::span<const std::uint8_t> bytes) {
  Hasher hasher;
  hasher.add(bytes);
  return hasher.hex();
}

std::string sha256(const Image& image) {
  static_assert(std::endian::native == std::endian::little, "pixels are hashed as they lie in memory");
  Hasher hasher;
  hasher.add(bytes_of(std::to_string(image.width) + "x" + std::to_string(image.height) + "\n"));
  hasher.add({reinterpret_cast<const std::uint8_t*>(image.pixels.data()), image.pixels.size() * 4});
  return hasher.hex();
}

}  // namespace blysk
