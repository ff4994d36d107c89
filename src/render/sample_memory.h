// render/sample_memory.h - what one thread keeps for antialiased tiles, and how it is handed to the kernels.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "antialias/glass.h"
#include "antialias/sample_tile.h"
#include "render/frame.h"
#include "render/kernels.h"
#include "render/tile_counts.h"

namespace blysk {

/// Fragments and layers of a thread's tiles.
struct SampleCounts {
  std::uint64_t fragments = 0, shared_pixels = 0;
  std::uint64_t layers = 0, merged_layers = 0, merged_pixels = 0;
};

class SampleMemory {
 public:
  /// Takes what a frame needs; what is there stays.
  void prepare(bool glass);
  /// Draws one tile; returns how many pixels are covered.
  int rasterize(const Kernels& table, const FramePlan& plan, const TileJob& job);
  /// Of pixels with fragments, the nearest opaque sample stands for the pixel where one surface has to.
  void show_nearest(TileBuffers& pixels) const;
  /// What the last tile left in its pixels; before show_nearest().
  void count(const TileBuffers& pixels, TileCounts& counts) const;

  [[nodiscard]] SampleBuffers* buffers() { return buffers_.get(); }
  [[nodiscard]] SampleCounts& counts() { return counts_; }
  [[nodiscard]] std::size_t bytes() const;

 private:
  void take_fragments(std::size_t most);
  void gather_glass(const FramePlan& plan, const TileJob& job);

  std::unique_ptr<SampleBuffers> buffers_;
  std::unique_ptr<GlassBuffers> glass_;
  std::unique_ptr<std::uint32_t[]> fragments_;
  std::size_t fragment_words_ = 0;
  std::vector<GlassEntry> entries_;
  bool has_glass_ = false;  ///< the last tile
  SampleCounts counts_;
};

}  // namespace blysk
