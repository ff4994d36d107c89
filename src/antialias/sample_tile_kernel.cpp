// Visibility of one tile at sixteen samples a pixel, and the fragments that are left of it.
//
// Based on: the A-buffer paper, visibility masks; specification A.3. Differs in: masks are not kept with
// fragments but samples with their surfaces, which is the same (invariant 4) and bounded by itself.
#include "antialias/glass_compose.h"
#include "antialias/glass_rows.h"
#include "antialias/sample_occlusion.h"
#include "antialias/sample_tile.h"
#include "geometry/bin_writer.h"
#include "simd/kernels.h"

namespace blysk::BLYSK_ISA {
namespace {

void clear(const TileJob& job) {
  for (int i = 0; i < kTilePixels; i += kLanes) {
    store(F32(0.0f), job.buffers->nearness + i);
    store(I32(static_cast<std::int32_t>(kNoTriangle)), job.buffers->id + i);
  }
}

void fill_background(const TileJob& job) {
  for (int i = 0; i < kTilePixels; i += kLanes) {
    store(I32(static_cast<std::int32_t>(job.background)), job.buffers->color + i);
  }
}

// Below the picture's last row pixels may be open, as blocks are opened whole.
int count_covered(const TileJob& job) {
  const TileBuffers& tile = *job.buffers;
  int n = 0;
  const I32 none(static_cast<std::int32_t>(kNoTriangle));
  for (int i = 0; i < job.height * kTileSize; i += kLanes) {
    n += __builtin_popcount(to_bits(load(tile.id + i) != none));
  }
  return n;
}

// Writes the fragment of the first of `rest`, and lets it count if it `is` there; what is left of `rest`.
template <bool kCenters>
BLYSK_INLINE unsigned write_fragment(SampleBuffers& s, int at, unsigned rest, bool is, int& uncovered) {
  const PixelSamples& pixel = s.open[at + (at >> kTileBits)];
  const std::int32_t id = pixel.id[__builtin_ctz(rest | 1u << (kSamples - 1))];
  const unsigned same = to_bits(load(pixel.id) == I32(id));
  s.fragment_id[s.fragments] = id;
  s.fragment_place[s.fragments] = fragment_word(at, same);
  if constexpr (kCenters) s.fragment_nearness[s.fragments] = mean_nearness(load(pixel.nearness), same);
  s.fragments += static_cast<int>(is & (id != kNoSurface));
  uncovered += id == kNoSurface ? __builtin_popcount(same) : 0;
  return rest & ~same;
}

// How many surfaces a pixel shows no branch can foresee. So all pixels write two, which count if they are
// there, and what is left waits in a queue, from which each step takes one and to which it returns the rest.
template <bool kCenters>
void collect(const SampleJob& job) {
  SampleBuffers& s = *job.samples;
  int queued = 0;
  for (int row = 0; row < job.tile.height; ++row) {
    for (int column = 0; column < job.tile.width; column += kLanes) {
      const int block = row * kTileSize + column;
      const I32 many(static_cast<std::int32_t>(kManySurfaces));
      unsigned open = to_bits(load(job.tile.buffers->id + block) == many);
      if (job.glass != nullptr) open &= to_bits(load(job.glass->first + block) < I32(0));
      for (; open != 0; open &= open - 1) {
        const int at = block + __builtin_ctz(open);
        const PixelSamples& pixel = s.open[at + (at >> kTileBits)];
        const std::int32_t id = pixel.id[0];
        const bool shared = to_bits(load(pixel.id) == I32(id)) != kAllSamples;
        const std::uint32_t whole = id == kNoSurface ? kNoTriangle : static_cast<std::uint32_t>(id);
        job.tile.buffers->id[at] = shared ? kManySurfaces : whole;
        int uncovered = 0;
        unsigned rest = write_fragment<kCenters>(s, at, kAllSamples, shared, uncovered);
        rest = write_fragment<kCenters>(s, at, rest, shared, uncovered);
        s.queue[queued] = static_cast<std::uint32_t>(at) | rest << 2 * kTileBits;
        queued += static_cast<int>(rest != 0);
        s.pixel[s.pixels] = at;
        s.pixels += static_cast<int>(shared);
        s.uncovered[at] = static_cast<std::uint8_t>(uncovered);
      }
    }
  }
  for (int i = 0; i < queued; ++i) {
    const int at = static_cast<int>(s.queue[i] & (kTilePixels - 1));
    int uncovered = s.uncovered[at];
    const unsigned rest = write_fragment<kCenters>(s, at, s.queue[i] >> 2 * kTileBits, true, uncovered);
    s.uncovered[at] = static_cast<std::uint8_t>(uncovered);
    s.queue[queued] = static_cast<std::uint32_t>(at) | rest << 2 * kTileBits;
    queued += static_cast<int>(rest != 0);
  }
  for (int i = 0; i < s.pixels; ++i) {
    const int at = s.pixel[i];
    for (int k = 0; k < 4; ++k) s.sum[4 * at + k] = job.background[k] * static_cast<float>(s.uncovered[at]);
  }
}

BLYSK_INLINE void draw_rows(const RowSurface& s, SampleTile& tile, SampleOcclusion& occlusion) {
  if (occlusion.hides(s.box(), s.ceiling)) return;
  RowPainter(s, tile).draw();
  occlusion.drawn(s.box().blocks(), 8, tile);
}

template <bool kCenters>
void draw_small(const TileJob& job, const SmallEntry* entries, int count, SampleTile& tile,
                SampleOcclusion& occlusion) {
  SmallBlock block;
  set_up_small(job, entries, block);
  for (int i = 0; i < count; ++i) {
    const auto id = static_cast<std::int32_t>(entries[i].id);
    if ((block.patches >> i & 1) == 0) {
      draw_rows(row_surface(block, i, id), tile, occlusion);
      continue;
    }
    const Box box = block.box(i);
    if (occlusion.hides(box, block.highest[i])) continue;
    const std::uint64_t blocks = box.blocks();
    tile.open_all(blocks);
    draw_patches<kCenters>(block, i, I32(id), tile);
    occlusion.drawn(blocks, 1, tile);
  }
}

template <bool kCenters>
int rasterize(const SampleJob& job) {
  const TileJob& of = job.tile;
  SampleTile tile{*of.buffers, *job.samples, {}};
  SampleOcclusion occlusion;
  bool fresh = true, filled = false;
  const auto clear_once = [&] {
    if (fresh) clear(of);
    fresh = false;
  };
  // Triangles wait until sixteen others have come after them, so that their vertices are there when they are
  // set up: these lie anywhere in memory.
  SmallEntry waiting[2 * kLanes] = {};
  int waits = 0;
  for (int i = 0; i < of.bins_count; ++i) {
    const Bin* bins = of.bins[i];
    for_each_entry<LargeEntry>(bins[bin_index(of.tile, Stream::large)], [&](const LargeEntry& t) {
      const RowSurface s = row_surface(of, t);
      if (fresh) {
        RowPainter painter(s, tile);
        if (painter.covers_tile()) {
          painter.fill_tile();
          fresh = false;
          filled = true;
          return;
        }
      }
      clear_once();
      draw_rows(s, tile, occlusion);
    });
  }
  // Larger triangles first, then those that face the viewer: they hide most of the others.
  for (const Stream stream : {Stream::small, Stream::small_away}) {
    occlusion.refresh(tile);
    for (int i = 0; i < of.bins_count; ++i) {
      for_each_entry<SmallEntry>(of.bins[i][bin_index(of.tile, stream)], [&](const SmallEntry& t) {
        clear_once();
        for (const std::uint32_t vertex : t.vertex) __builtin_prefetch(of.vertices + vertex);
        waiting[waits++] = t;
        if (waits < 2 * kLanes) return;
        draw_small<kCenters>(of, waiting, kLanes, tile, occlusion);
        waits = kLanes;
        std::memcpy(waiting, waiting + kLanes, sizeof waiting / 2);
      });
    }
    for (int first = 0; first < waits; first += kLanes) {
      draw_small<kCenters>(of, waiting + first, min(waits - first, kLanes), tile, occlusion);
    }
    waits = 0;
  }
  clear_once();
  job.samples->fragments = job.samples->pixels = 0;
  job.samples->weighted = job.glass != nullptr;
  if (job.glass != nullptr) draw_glass(job, tile);
  if (tile.any_open) collect<kCenters>(job);
  if (job.glass != nullptr) compose_glass<kCenters>(job, tile);
  const int covered = filled ? kTilePixels : count_covered(of);
  if (covered < kTilePixels) fill_background(of);
  return covered;
}

}  // namespace

int rasterize_samples(const SampleJob& job) {
  return job.want_nearness ? rasterize<true>(job) : rasterize<false>(job);
}

}  // namespace blysk::BLYSK_ISA
