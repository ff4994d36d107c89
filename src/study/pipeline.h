// study/pipeline.h - the stages of a frame one by one, on one thread.
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "render/frame.h"
#include "render/kernels.h"

namespace blysk::study {

/// Each stage works on what the one before it left; the constructor has transformed and assembled.
class Pipeline {
 public:
  /// The scene must outlive the pipeline, be drawable with the options, and have one instance with triangles.
  Pipeline(const Scene& scene, const RenderOptions& options, Isa isa);

  void transform();
  void assemble();
  /// One tile's buffers after the other's, as in a frame; returns the covered pixels.
  std::uint64_t rasterize();
  /// Rasterises every tile into buffers of its own, for shade().
  std::uint64_t keep_tiles();
  void shade(const MethodChoice& method);

  [[nodiscard]] std::size_t triangles() const { return plan_.triangles; }
  [[nodiscard]] std::size_t bytes() const { return bins_.memory(); }

 private:
  int rasterize_tile(std::size_t tile, TileBuffers& buffers);

  RenderOptions options_;
  const Kernels& table_;
  FramePlan plan_;
  int tiles_x_;
  std::size_t tiles_;
  std::unique_ptr<TileBuffers> reused_ = std::make_unique<TileBuffers>();
  std::vector<TileBuffers> kept_;  ///< empty, or one a tile
  std::vector<ScreenVertex> vertices_;
  std::vector<std::uint32_t> rest_;
  ThreadBins bins_;
};

}  // namespace blysk::study
