// raster/clear_tile.h - what a tile holds before its first triangle.
#pragma once

#include "raster/tile.h"
#include "simd/lanes.h"

namespace blysk::BLYSK_ISA {

inline void clear(const TileJob& job) {
  for (int i = 0; i < kTilePixels; i += kLanes) {
    store(F32(0.0f), job.buffers->nearness + i);
    store(I32(static_cast<std::int32_t>(kNoTriangle)), job.buffers->id + i);
  }
}

/// Colours are written where a triangle is seen; only a tile with gaps needs the background below them.
inline void fill_background(const TileJob& job) {
  for (int i = 0; i < kTilePixels; i += kLanes) {
    store(I32(static_cast<std::int32_t>(job.background)), job.buffers->color + i);
  }
}

}  // namespace blysk::BLYSK_ISA
