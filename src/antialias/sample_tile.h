// antialias/sample_tile.h - a tile of sixteen samples a pixel: the exact A-buffer.
//
// Opaque fragments whose visibility is decided sample by sample are, all together, an array: which surface
// each sample shows, and how near it is (specification of the A-buffer paper, A.3, invariants 3 and 4). Most
// pixels show one surface and stay simple: its id and its nearness at the centre in TileBuffers, its slopes
// here. Only a pixel that several surfaces meet gets sixteen depths and ids, 128 bytes, one register each.
// Memory is there for all pixels of a tile, and touched where edges are: with edges everywhere a tile's whole
// state takes 0.7 MB of a second-level cache, and its fragments 8 bytes each.
#pragma once

#include <cstdint>

#include "blysk/image.h"
#include "raster/tile.h"

namespace blysk {

/// Of a pixel, in four rows of four: sample 4 * row + column lies 64 * column - 96 and 64 * row - 96
/// subpixels from its centre.
inline constexpr int kSamples = 16;

/// Marks, in TileBuffers::id, a pixel whose samples may differ. Like kNoTriangle it is negative as a signed
/// number.
inline constexpr std::uint32_t kManySurfaces = 0xfffffffe;
/// In PixelSamples::id: above all ids, so that the rule for equals, lower id wins, needs no exception.
inline constexpr std::int32_t kNoSurface = 0x7fffffff;
/// Nearness of a sample that nothing covers: below all that rounding can make of a surface's.
inline constexpr float kNothingNear = -4.0f;

// A fragment is the part of a pixel that shows one surface: the triangle, and a word
// pixel | samples << 12 | sum of 2 * column << 17 | sum of 2 * row << 24 over its samples.
inline constexpr int kFragmentSamplesShift = 2 * kTileBits, kFragmentColumnsShift = 17,
                     kFragmentRowsShift = 24;

/// The samples of one pixel: two lines of a cache.
struct PixelSamples {
  alignas(64) float nearness[kSamples];
  alignas(64) std::int32_t id[kSamples];
};

struct SampleBuffers {
  static constexpr int kPadding = 64;  ///< whole registers may be read and written past the last fragment
  /// A pixel has at most as many opaque fragments as samples.
  static constexpr int kMostFragments = kTilePixels * kSamples;

  // Read also where a pixel was never simple.
  alignas(64) float slope_x[kTilePixels + TileBuffers::kPadding] = {};  ///< of simple pixels, a subpixel
  alignas(64) float slope_y[kTilePixels + TileBuffers::kPadding] = {};
  /// Of the others. Rows are one pixel longer than the tile's: else the pixels of a column would share a set
  /// of the first-level cache.
  PixelSamples open[kTilePixels + kTileSize];
  static constexpr int place_of(int at) { return at + (at >> kTileBits); }

  // What is left for shading: room for kMostFragments and, with glass, kMostGlass more; and for kPadding.
  std::int32_t* fragment_id;
  std::int32_t* fragment_place;
  float* fragment_nearness;  ///< at its centroid, if wanted
  float* fragment_weight;    ///< if `weighted`, how many samples it makes up; else all that it covers
  bool weighted;
  alignas(64) float sum[4 * kTilePixels];  ///< over a pixel's samples: linear colour times alpha, alpha
  alignas(64) std::int32_t pixel[kTilePixels + kPadding];  ///< those that have fragments
  int fragments, pixels;

  // Of pixels whose fragments are being listed.
  std::uint32_t queue[kMostFragments + kPadding];
};

struct GlassEntry;
struct GlassBuffers;

struct SampleJob {
  TileJob tile;
  SampleBuffers* samples;
  GlassBuffers* glass;  ///< null: nothing is transparent here
  const GlassEntry* glass_entries;
  std::size_t glass_count;
  float background[4];  ///< linear colour times alpha, alpha
  bool want_nearness;   ///< of fragments, and in TileBuffers; else both mean nothing
};

/// Visibility of one tile, sample by sample: nearest wins, of equals the lower id. TileBuffers::id and
/// nearness are set where all samples show one surface, TileBuffers::id is kNoTriangle where nothing is,
/// kManySurfaces where there are fragments; of these SampleBuffers::sum holds the background's part. Returns
/// how many pixels have any surface.
using RasterizeSamplesFunction = int (*)(const SampleJob&);

struct ResolveJob {
  TileBuffers* buffers;  ///< out: color of the pixels with fragments
  SampleBuffers* samples;
  Transfer transfer;
};

/// Sums to colours.
using ResolveFunction = void (*)(const ResolveJob&);

}  // namespace blysk
