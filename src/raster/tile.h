// raster/tile.h - the depth and triangle of every pixel of one tile.
#pragma once

#include <cstdint>

#include "geometry/bins.h"
#include "geometry/screen_vertex.h"

namespace blysk {

inline constexpr std::uint32_t kNoTriangle = 0xffffffff;

/// What one thread works on. Rows are kTileSize long; sixteen lanes may be read and rewritten past the last
/// pixel.
struct TileBuffers {
  static constexpr int kPadding = 16;
  alignas(64) float nearness[kTilePixels + kPadding];
  alignas(64) std::uint32_t id[kTilePixels + kPadding];
  alignas(64) std::uint32_t color[kTilePixels + kPadding];  ///< RGBA8, as Image::pixels
};

/// Resolves visibility of one tile: nearest wins, of equals the lower triangle id.
struct TileJob {
  int x, y;                      ///< first pixel of the tile in the picture
  int width, height;             ///< of the part inside the picture
  std::size_t tile;              ///< number of the tile
  const ScreenVertex* vertices;  ///< of the frame
  const Bin* const* bins;        ///< ThreadBins::bins() of every thread
  int bins_count;
  std::uint32_t background;
  TileBuffers* buffers;  ///< out: nearness, id, and the background in color where pixels are open
};

/// Copies `rows` rows of `width` colours of a tile to a picture whose rows are `stride` pixels apart.
using StoreTileFunction = void (*)(const TileBuffers& tile, int width, int rows, std::uint32_t* to,
                                   std::size_t stride);

/// Returns how many pixels are covered.
using RasterizeFunction = int (*)(const TileJob&);

}  // namespace blysk
