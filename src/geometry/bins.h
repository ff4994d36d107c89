// geometry/bins.h - what touches a tile, as lists that a thread writes and a tile reads.
//
// A thread takes chunks of triangles in ascending order, so every list ascends in submission order; the depth
// test breaks ties by triangle id, so the order in which lists are read cannot show. Lists live in the
// thread's arena, which is kept from frame to frame.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "geometry/screen_vertex.h"

namespace blysk {

inline constexpr int kTileBits = 6;
inline constexpr int kTileSize =
    1 << kTileBits;  // 64 x 64: depth, id and colour of a tile are 48 KB, a first-level cache
inline constexpr int kTilePixels = kTileSize * kTileSize;

/// A pixel centre that a very small triangle covers: nothing is left to do but the depth test.
struct DotEntry {
  std::uint32_t id;  ///< triangle, counted over all instances
  float nearness;
  std::uint32_t at;  ///< row * 64 + column in the tile
};

/// A triangle whose bounding box is under 128 pixels wide and high.
struct SmallEntry {
  std::uint32_t id;
  std::uint32_t vertex[3];  ///< of the frame's screen vertices, in the order that makes the area positive
};

/// Any other triangle, or a piece of one that was clipped.
struct LargeEntry {
  std::uint32_t id;
  std::int32_t x[3], y[3];  ///< 1/256 pixel, positive area
  float nearness[3];
};

/// Small triangles seen from behind have a list of their own where pixels are sampled: drawn after the others
/// they are mostly hidden. So have transparent ones, which are drawn when all others are.
enum class Stream { dot, small, small_away, large, glass_small, glass_large };
inline constexpr int kStreams = 6;

struct BinBlock {
  static constexpr std::size_t kBytes = 1024;
  BinBlock* next;
  std::size_t used;  ///< bytes of entries; of the last block see Bin::cursor
  std::byte entries[kBytes - sizeof(BinBlock*) - sizeof(std::size_t)];
};
static_assert(sizeof(BinBlock) == BinBlock::kBytes);

/// One list. All zero is an empty one.
struct Bin {
  std::byte* cursor;  ///< where the next entry goes
  std::byte* end;
  BinBlock* first;
  BinBlock* last;
};

constexpr std::size_t bin_index(std::size_t tile, Stream stream) {
  return tile * kStreams + static_cast<std::size_t>(stream);
}

/// The lists of one thread: kStreams per tile. Nothing here is inline: kernels are compiled for processors
/// that the rest must not need (tools/check-kernels).
class ThreadBins {
 public:
  /// Empties all lists; no more than `max_bytes` will go into new ones.
  void reset(std::size_t tiles, std::size_t max_bytes);
  [[nodiscard]] Bin* bins();  ///< of tile t and stream s at bin_index(t, s)
  /// Appends an empty block to a list; std::bad_alloc beyond max_bytes.
  void grow(Bin& bin);
  [[nodiscard]] std::size_t memory() const;

 private:
  static constexpr std::size_t kChunkBlocks = 1024;
  std::vector<Bin> bins_;
  std::vector<std::unique_ptr<BinBlock[]>> chunks_;
  std::size_t used_blocks_ = 0, max_blocks_ = 0;
};

/// Out of line for the kernels.
void grow_bin(ThreadBins& bins, Bin& bin);

}  // namespace blysk
