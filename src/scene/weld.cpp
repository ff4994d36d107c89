// Every chunk of the points is welded for itself in an open hash table; then each chunk looks its distinct
// points up in the tables of the chunks before it. Ids count first appearances, so that chunks leave no
// trace.
#include "scene/weld.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <numeric>
#include <vector>

namespace blysk {
namespace {

constexpr std::size_t kBatch = 64;              // points whose slots are fetched ahead
constexpr std::size_t kMostChunks = 8;          // a chunk looks into all tables before its own
constexpr std::size_t kPointsPerChunk = 50000;  // fewer are not worth a thread
constexpr std::size_t kMostProbes = 1024;       // far beyond what honest points need at half load
constexpr std::uint32_t kEmpty = 0xffffffff;

Vec3f load_point(const Vec3f& p) { return {p.x + 0.0f, p.y + 0.0f, p.z + 0.0f}; }  // -0 + 0 is 0

// Equal bits, so that a NaN finds itself.
bool same(const Vec3f& a, const Vec3f& b) {
  const auto bits = [](float f) { return std::bit_cast<std::uint32_t>(f); };
  return bits(a.x) == bits(b.x) && bits(a.y) == bits(b.y) && bits(a.z) == bits(b.z);
}

std::uint32_t hash(const Vec3f& p) {
  const std::uint64_t xy =
      std::bit_cast<std::uint32_t>(p.x) | std::uint64_t{std::bit_cast<std::uint32_t>(p.y)} << 32;
  std::uint64_t h = (xy ^ (xy >> 29)) * 0x9e3779b97f4a7c15u;
  h = (h ^ (h >> 32) ^ std::bit_cast<std::uint32_t>(p.z)) * 0xd6e8feb86659fd93u;
  return static_cast<std::uint32_t>(h >> 32);
}

// Distinct points, found by their hash.
class PointTable {
 public:
  explicit PointTable(std::size_t expected) {
    resize(std::bit_ceil(std::max<std::size_t>(expected * 2, 64)));
    points_.reserve(expected);
  }

  const Array<Vec3f>& points() const { return points_; }
  bool defeated() const { return defeated_; }
  void prefetch(std::uint32_t h) const { __builtin_prefetch(&slots_[h & mask_]); }

  std::uint32_t find(const Vec3f& p, std::uint32_t h) const {
    for (std::size_t at = h & mask_;; at = (at + 1) & mask_) {
      const Slot& slot = slots_[at];
      if (slot.id == kEmpty || (slot.hash == h && same(points_[slot.id], p))) return slot.id;
    }
  }

  std::uint32_t insert(const Vec3f& p, std::uint32_t h) {
    std::size_t at = h & mask_;
    for (std::size_t probes = 0;; at = (at + 1) & mask_, ++probes) {
      const Slot& slot = slots_[at];
      if (slot.id == kEmpty) break;
      if (slot.hash == h && same(points_[slot.id], p)) return slot.id;
      if (probes == kMostProbes) {
        defeated_ = true;
        return 0;
      }
    }
    const auto id = static_cast<std::uint32_t>(points_.size());
    slots_[at] = {h, id};
    points_.push_back(p);
    if (points_.size() * 2 > slots_.size()) resize(slots_.size() * 2);
    return id;
  }

 private:
  struct Slot {
    std::uint32_t hash, id;
  };

  void resize(std::size_t capacity) {
    Array<Slot> old = std::move(slots_);
    slots_ = {};
    slots_.resize(capacity);
    std::memset(static_cast<void*>(slots_.data()), 0xff, capacity * sizeof(Slot));
    mask_ = capacity - 1;
    for (const Slot& slot : old) {
      if (slot.id == kEmpty) continue;
      std::size_t at = slot.hash & mask_;
      while (slots_[at].id != kEmpty) at = (at + 1) & mask_;
      slots_[at] = slot;
    }
  }

  Array<Slot> slots_;
  Array<Vec3f> points_;
  std::size_t mask_ = 0;
  bool defeated_ = false;
};

struct Chunk {
  std::size_t begin = 0, end = 0;
  PointTable table;
  std::vector<std::uint32_t> earlier_chunk;  // per distinct point, where it stood first; kEmpty: here
  Array<std::uint32_t> final_ids;  // per distinct point; while looking up: its id in the earlier chunk
  std::uint32_t first_id = 0;      // id of this chunk's first new point

  Chunk(std::size_t b, std::size_t e) : begin(b), end(e), table((e - b) / 6 + 1) {}
};

// Local ids of a chunk's points.
void weld_chunk(const Array<Vec3f>& points, Chunk& chunk, std::uint32_t* ids) {
  Vec3f batch[kBatch];
  std::uint32_t hashes[kBatch];
  for (std::size_t begin = chunk.begin; begin < chunk.end && !chunk.table.defeated(); begin += kBatch) {
    const std::size_t count = std::min(kBatch, chunk.end - begin);
    for (std::size_t i = 0; i < count; ++i) {
      batch[i] = load_point(points[begin + i]);
      hashes[i] = hash(batch[i]);
      chunk.table.prefetch(hashes[i]);
    }
    for (std::size_t i = 0; i < count; ++i) ids[begin + i] = chunk.table.insert(batch[i], hashes[i]);
  }
}

// Looks the distinct points of chunk `c` up in the chunks before it.
void find_earlier(std::vector<Chunk>& chunks, std::size_t c) {
  Chunk& chunk = chunks[c];
  const Array<Vec3f>& points = chunk.table.points();
  chunk.earlier_chunk.assign(points.size(), kEmpty);
  chunk.final_ids.resize(points.size());
  for (std::size_t begin = 0; begin < points.size(); begin += kBatch) {
    const std::size_t end = std::min(points.size(), begin + kBatch);
    for (std::size_t j = 0; j < c; ++j) {
      for (std::size_t i = begin; i < end; ++i) chunks[j].table.prefetch(hash(points[i]));
      for (std::size_t i = begin; i < end; ++i) {
        if (chunk.earlier_chunk[i] != kEmpty) continue;
        const std::uint32_t id = chunks[j].table.find(points[i], hash(points[i]));
        if (id == kEmpty) continue;
        chunk.earlier_chunk[i] = static_cast<std::uint32_t>(j);
        chunk.final_ids[i] = id;
      }
    }
  }
}

// Counts the new points of each chunk behind those of the chunks before it; gives the number of all.
std::uint32_t number(std::vector<Chunk>& chunks) {
  std::uint32_t next = 0;
  for (Chunk& chunk : chunks) {
    chunk.first_id = next;
    for (std::size_t i = 0; i < chunk.final_ids.size(); ++i) {
      const std::uint32_t earlier = chunk.earlier_chunk[i];
      chunk.final_ids[i] = earlier == kEmpty ? next++ : chunks[earlier].final_ids[chunk.final_ids[i]];
    }
  }
  return next;
}

void finish_ids(const Chunk& chunk, Array<std::uint32_t>& ids) {
  if (chunk.begin == 0) return;  // the first chunk's ids are final
  for (std::size_t i = chunk.begin; i < chunk.end; ++i) ids[i] = chunk.final_ids[ids[i]];
}

// For points whose hashes somebody made collide.
WeldedIds weld_by_sorting(const Array<Vec3f>& points) {
  Array<std::uint32_t> order;
  order.resize(points.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    const Vec3f p = load_point(points[a]), q = load_point(points[b]);
    const int difference = std::memcmp(&p, &q, sizeof p);
    return difference != 0 ? difference < 0 : a < b;
  });
  WeldedIds welded;
  welded.ids.resize(points.size());
  // First the first of the equals, in its own place; then the ids in the order of the points.
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool repeats = i > 0 && same(load_point(points[order[i]]), load_point(points[order[i - 1]]));
    welded.ids[order[i]] = repeats ? welded.ids[order[i - 1]] : order[i];
  }
  for (std::uint32_t i = 0; i < order.size(); ++i) {
    const bool first = welded.ids[i] == i;
    welded.ids[i] = first ? static_cast<std::uint32_t>(welded.count++) : welded.ids[welded.ids[i]];
  }
  return welded;
}

}  // namespace

WeldedIds weld_ids(const Array<Vec3f>& points, ThreadPool& pool) {
  const std::size_t count = std::clamp<std::size_t>(points.size() / kPointsPerChunk, 1,
                                                    std::min<std::size_t>(pool.size(), kMostChunks));
  std::vector<Chunk> chunks;
  for (std::size_t c = 0; c < count; ++c) {
    chunks.emplace_back(points.size() * c / count, points.size() * (c + 1) / count);
  }
  WeldedIds welded;
  Array<std::uint32_t>& ids = welded.ids;
  ids.resize(points.size());
  pool.for_each(count, [&](int, std::size_t c) { weld_chunk(points, chunks[c], ids.data()); });
  if (std::any_of(chunks.begin(), chunks.end(), [](const Chunk& c) { return c.table.defeated(); })) {
    return weld_by_sorting(points);
  }
  pool.for_each(count, [&](int, std::size_t c) { find_earlier(chunks, c); });
  welded.count = number(chunks);
  pool.for_each(count, [&](int, std::size_t c) { finish_ids(chunks[c], ids); });
  return welded;
}

}  // namespace blysk
