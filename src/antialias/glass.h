// antialias/glass.h - transparent surfaces of a tile, layer by layer.
//
// Opaque surfaces are drawn first. What of a transparent one lies in front of them, sample by sample, waits
// in its pixel's list. When all are there each sample is composed front to back by the depths at that sample
// (specification of the A-buffer paper, A.5), so that order of submission does not show and intersecting
// glass is right. A pixel holds up to kMostLayers; beyond them the two farthest become one, which is counted.
#pragma once

#include <cstdint>

#include "antialias/sample_tile.h"
#include "antialias/vertex_opacity.h"

namespace blysk {

inline constexpr int kMostLayers = 64;
inline constexpr int kMostGlass = kTilePixels * kMostLayers;

/// A transparent triangle. They come in ascending order of ids.
struct GlassEntry {
  LargeEntry triangle;
  float opacity;                 ///< above 0, below 1
  const VertexOpacity* varying;  ///< instead of `opacity`, which may then be anything of 0..1; or null
};

/// Of one pixel: the samples at which a surface is not behind an opaque one.
struct GlassLayer {
  std::int32_t id;
  std::uint32_t mask;
  float center;            ///< nearness of its plane at the pixel's centre
  float slope_x, slope_y;  ///< a subpixel
  float lowest, highest;   ///< of the triangle
  float opacity;
  std::int32_t next;  ///< of the pixel, or -1
};

/// What a triangle adds to the colour of a layer that several have become: its weight counts among those of
/// the others.
struct GlassPart {
  std::int32_t id;
  std::uint32_t mask;
  float weight;
};
inline constexpr int kMostParts = 16;

/// The layers of a pixel that has no room left: where they are, and how near at the pixel's centre.
struct FullPixel {
  float center[kMostLayers];
  std::int32_t layer[kMostLayers];
  int last;                    ///< the farthest, into which others go
  int second;                  ///< the farthest of the others
  GlassPart part[kMostParts];  ///< of the last
  int parts;
};

struct GlassBuffers {
  std::int32_t first[kTilePixels];  ///< of a pixel's layers, or -1
  std::uint8_t layers[kTilePixels];
  std::uint8_t merged[kTilePixels];  ///< whether any of the pixel's layers are two
  FullPixel full[kTilePixels];       ///< of those
  GlassLayer layer[kMostGlass];
  int used;
  std::uint64_t generated, merges;  ///< of the tile
  std::int32_t pixel[kTilePixels];  ///< those with layers
  int pixels;
};

}  // namespace blysk
