// Points that share no bit of a small table with another one differ from all others. The rest, a tenth where
// all differ, tries once more with other bits, and only what is left goes through the hash table of weld.cpp.
#include "scene/first_equals.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <numeric>
#include <vector>

#include "scene/weld.h"

namespace blysk {
namespace {

constexpr std::size_t kMostTables = 4;         // each has tables of its own
constexpr std::size_t kPointsPerPart = 50000;  // fewer are not worth a thread
constexpr std::size_t kPointBlock = std::size_t{1} << 15;
constexpr std::size_t kBitsPerPoint = 8;
constexpr std::uint64_t kFactors[] = {0x9e3779b97f4a7c15u, 0xc2b2ae3d27d4eb4fu};

// One bit for each value of a hash.
class Bits {
 public:
  Bits() = default;
  explicit Bits(std::size_t count) { words_.resize(count / 64, std::uint64_t{0}); }

  [[nodiscard]] bool has(std::size_t i) const { return (words_[i / 64] >> (i % 64) & 1) != 0; }
  // Whether the bit was set before.
  bool set(std::size_t i) {
    const std::uint64_t bit = std::uint64_t{1} << (i % 64), word = words_[i / 64];
    words_[i / 64] = word | bit;
    return (word & bit) != 0;
  }
  std::uint64_t* words() { return words_.data(); }

 private:
  Array<std::uint64_t> words_;
};

// The hashes that some points of a run have, and those that several have.
struct EqualsPart {
  std::size_t begin, end;
  Bits seen, shared;
};

class Hash {
 public:
  Hash(std::size_t points, std::uint64_t factor)
      : factor_(factor),
        bits_(static_cast<int>(std::bit_width(std::max<std::size_t>(points, 64) * kBitsPerPoint - 1))) {}

  [[nodiscard]] std::size_t values() const { return std::size_t{1} << bits_; }
  [[nodiscard]] std::size_t operator()(const Vec3f& p) const {
    // -0 + 0 is 0
    const std::uint64_t x = std::bit_cast<std::uint32_t>(p.x + 0.0f);
    const std::uint64_t y = std::bit_cast<std::uint32_t>(p.y + 0.0f);
    const std::uint64_t z = std::bit_cast<std::uint32_t>(p.z + 0.0f);
    std::uint64_t h = (x | y << 32) * factor_;
    h = (h ^ (h >> 32) ^ z) * 0xd6e8feb86659fd93u;
    return static_cast<std::size_t>(h >> (64 - bits_));
  }

 private:
  std::uint64_t factor_;
  int bits_;
};

Bits shared_hashes(const Array<Vec3f>& points, const Hash& hash, ThreadPool& pool) {
  const std::size_t count = std::clamp<std::size_t>(
      points.size() / kPointsPerPart, 1, std::min(static_cast<std::size_t>(pool.size()), kMostTables));
  std::vector<EqualsPart> parts;
  for (std::size_t i = 0; i < count; ++i) {
    parts.push_back({points.size() * i / count, points.size() * (i + 1) / count, {}, {}});
  }
  pool.for_each(count, [&](int, std::size_t i) {
    EqualsPart& part = parts[i];
    part.seen = part.shared = Bits(hash.values());
    for (std::size_t k = part.begin; k < part.end; ++k) {
      const std::size_t h = hash(points[k]);
      if (part.seen.set(h)) part.shared.set(h);
    }
  });
  for (std::size_t i = 1; i < count; ++i) {
    std::uint64_t *seen = parts[0].seen.words(), *shared = parts[0].shared.words();
    const std::uint64_t *more = parts[i].seen.words(), *more_shared = parts[i].shared.words();
    for (std::size_t w = 0; w < hash.values() / 64; ++w) {
      shared[w] |= more_shared[w] | (seen[w] & more[w]);
      seen[w] |= more[w];
    }
  }
  return std::move(parts[0].shared);
}

// The points whose hash another one has, ascending.
Array<std::uint32_t> suspects(const Array<Vec3f>& points, std::uint64_t factor, ThreadPool& pool) {
  const Hash hash(points.size(), factor);
  const Bits shared = shared_hashes(points, hash, pool);
  std::vector<Array<std::uint32_t>> found((points.size() + kPointBlock - 1) / kPointBlock);
  pool.for_each(found.size(), [&](int, std::size_t block) {
    const std::size_t end = std::min(points.size(), (block + 1) * kPointBlock);
    for (std::size_t i = block * kPointBlock; i < end; ++i) {
      if (shared.has(hash(points[i]))) found[block].push_back(static_cast<std::uint32_t>(i));
    }
  });
  std::size_t count = 0;
  for (const Array<std::uint32_t>& some : found) count += some.size();
  Array<std::uint32_t> all;
  all.reserve(count);
  for (const Array<std::uint32_t>& some : found) all.insert(all.end(), some.begin(), some.end());
  return all;
}

template <class T>
Array<T> pick(const Array<T>& values, const Array<std::uint32_t>& which) {
  Array<T> picked(which.size());
  for (std::size_t i = 0; i < which.size(); ++i) picked[i] = values[which[i]];
  return picked;
}

}  // namespace

Array<std::uint32_t> first_equals(const Array<Vec3f>& points, ThreadPool& pool) {
  Array<std::uint32_t> suspected = suspects(points, kFactors[0], pool);
  Array<Vec3f> places = pick(points, suspected);
  const Array<std::uint32_t> again = suspects(places, kFactors[1], pool);
  suspected = pick(suspected, again);
  places = pick(places, again);
  const WeldedIds welded = weld_ids(places, pool);
  if (welded.count == suspected.size()) return {};

  Array<std::uint32_t> first(points.size());
  std::iota(first.begin(), first.end(), 0u);
  Array<std::uint32_t> first_of_id;  // ids count first appearances
  for (std::size_t i = 0; i < suspected.size(); ++i) {
    if (welded.ids[i] == first_of_id.size()) first_of_id.push_back(suspected[i]);
    first[suspected[i]] = first_of_id[welded.ids[i]];
  }
  return first;
}

}  // namespace blysk
