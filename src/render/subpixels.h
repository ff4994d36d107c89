// render/subpixels.h - pixels that are cut up, each part drawn as a pixel of sixteen samples, and joined
// again in linear light.
//
// The picture is drawn as one that has more pixels, tile by tile; a tile of parts becomes a smaller one of
// pixels before anything leaves it, so that memory does not grow with them.
#pragma once

#include <cstdint>
#include <vector>

#include "antialias/sample_tile.h"
#include "raster/tile.h"
#include "render/view.h"

namespace blysk {

/// The parts of a pixel, each way: powers of two that divide kTileSize.
struct Subpixels {
  int across = 1, down = 1;
  /// Only of two halves: a surface that covers a whole pixel is shaded once, at the pixel's centre, as
  /// without halves.
  bool centered = false;

  [[nodiscard]] int count() const { return across * down; }
};

/// The view of a picture whose pixels are parts of the given one's.
[[nodiscard]] ViewFrame in_subpixels(ViewFrame view, const Subpixels& subpixels);

/// One tile on its way from parts to pixels. Pixels end in the tile's first columns and rows.
class SubpixelTile {
 public:
  /// Parts that show one surface become fragments like the others, so that their colours stay linear.
  /// `background`: linear colour times alpha, alpha.
  void list_simple(const Subpixels& subpixels, const TileJob& job, const Vec4f& background,
                   SampleBuffers& samples);
  /// After shading: gives simple parts their surfaces back.
  void restore(TileBuffers& buffers) const;
  /// Sums of parts become means of pixels, to be resolved: those that have any surface.
  void join_sums(const Subpixels& subpixels, const TileJob& job, SampleBuffers& samples) const;

  [[nodiscard]] std::size_t bytes() const { return ids_.capacity() * sizeof(std::uint32_t); }

 private:
  std::vector<std::uint32_t> ids_;  ///< of parts: a surface, kManySurfaces, kNoTriangle
};

/// Where one surface has to stand for a pixel, that of its nearest part does. `normals`: three a pixel, or
/// null.
void join_surfaces(const Subpixels& subpixels, TileBuffers& buffers, float* normals);

/// A number of each part becomes the sum of each pixel's.
void join_counts(const Subpixels& subpixels, std::uint32_t* counts);

}  // namespace blysk
