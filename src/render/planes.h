// render/planes.h - what a frame holds besides its picture: one value a pixel each.
#pragma once

#include "blysk/render.h"
#include "raster/tile.h"
#include "render/tile_counts.h"

namespace blysk {

/// Whether any plane shows one surface a pixel.
[[nodiscard]] inline bool wants_surface(const RenderOptions& o) {
  return o.want_depth || o.want_normal || o.want_id;
}
[[nodiscard]] inline bool wants_counts(const RenderOptions& o) {
  return o.want_fragments || o.want_coverage || o.want_complexity;
}

/// Makes room for the planes that are wanted, and none for the others.
void size_planes(const RenderOptions& options, Frame& frame);

/// Pixels of the picture that a tile holds.
struct TileArea {
  int x, y, width, height;
};

/// A tile's values, of pixels that are joined.
struct TilePlanes {
  TileArea area;
  const TileBuffers* buffers;
  const float* normals;  ///< three a pixel
  const TileCounts* counts;
  int samples;  ///< of a pixel
};

/// Copies a tile's values to the planes that are wanted; null where no plane wants them.
void store_planes(const RenderOptions& options, const TilePlanes& tile, Frame& frame);

}  // namespace blysk
