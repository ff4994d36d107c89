// Visibility of one tile at sixteen samples a pixel, and the fragments that are left of it.
//
// Based on: the A-buffer paper, visibility masks; specification A.3. Differs in: masks are not kept with
// fragments but samples with their surfaces, which is the same (invariant 4) and bounded by itself.
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

int count_covered(const TileBuffers& tile) {
  int n = 0;
  const I32 none(static_cast<std::int32_t>(kNoTriangle));
  for (int i = 0; i < kTilePixels; i += kLanes) n += __builtin_popcount(to_bits(load(tile.id + i) != none));
  return n;
}

// What the samples of half a mask add to a fragment's word.
struct MaskWords {
  std::uint32_t word[2][256];
  constexpr MaskWords() : word() {
    for (unsigned half = 0; half < 2; ++half) {
      for (unsigned bits = 0; bits < 256; ++bits) {
        for (unsigned s = 0; s < 8; ++s) {
          if ((bits >> s & 1) == 0) continue;
          const unsigned row = half * 2 + s / 4, column = s % 4;
          word[half][bits] += (1u << kFragmentSamplesShift) + (2 * column << kFragmentColumnsShift) +
                              (2 * row << kFragmentRowsShift);
        }
      }
    }
  }
};
constexpr MaskWords kMaskWords;

// The mean depth of some samples is the plane's at their centroid.
float mean_nearness(const float* nearness, unsigned mask) {
  float v[kSamples];
  store(select(lanes_of(mask), load(nearness), F32(0.0f)), v);
  for (int half = kSamples / 2; half > 0; half /= 2) {
    for (int i = 0; i < half; ++i) v[i] = v[i] + v[i + half];
  }
  return v[0] / static_cast<float>(__builtin_popcount(mask));
}

// The fragments of one pixel, or its one surface.
BLYSK_INLINE void collect_pixel(const SampleJob& job, int at) {
  SampleBuffers& s = *job.samples;
  const std::int32_t* ids = s.id + at * kSamples;
  const I32 all = load(ids);
  unsigned same = to_bits(all == I32(ids[0]));
  if (same == kAllSamples) {
    job.tile.buffers->id[at] = ids[0] == kNoSurface ? kNoTriangle : static_cast<std::uint32_t>(ids[0]);
    return;
  }
  float open = 0;
  for (unsigned rest = kAllSamples;;) {
    const std::int32_t id = ids[__builtin_ctz(rest)];
    same = to_bits(all == I32(id));
    if (id == kNoSurface) {
      open = static_cast<float>(__builtin_popcount(same));
    } else {
      s.fragment_id[s.fragments] = id;
      s.fragment_place[s.fragments] = static_cast<std::int32_t>(
          static_cast<unsigned>(at) + kMaskWords.word[0][same & 255] + kMaskWords.word[1][same >> 8]);
      if (job.want_nearness) {
        s.fragment_nearness[s.fragments] = mean_nearness(s.nearness + at * kSamples, same);
      }
      ++s.fragments;
    }
    rest &= ~same;
    if (rest == 0) break;
  }
  for (int k = 0; k < 4; ++k) s.sum[4 * at + k] = job.background[k] * open;
  s.pixel[s.pixels++] = at;
}

void collect(const SampleJob& job) {
  for (int row = 0; row < job.tile.height; ++row) {
    for (int column = 0; column < job.tile.width; column += kLanes) {
      const int at = row * kTileSize + column;
      const I32 many(static_cast<std::int32_t>(kManySurfaces));
      unsigned open = to_bits(load(job.tile.buffers->id + at) == many);
      for (; open != 0; open &= open - 1) collect_pixel(job, at + __builtin_ctz(open));
    }
  }
}

BLYSK_INLINE void draw_rows(const RowSurface& s, SampleTile& tile, SampleOcclusion& occlusion) {
  if (occlusion.hides(s.left, s.top, s.right, s.bottom, s.ceiling)) return;
  RowPainter(s, tile).draw();
  occlusion.drawn(s.left, s.top, s.right, s.bottom, 4, tile);
}

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
    const int left = block.left[i], top = block.top[i], right = block.right[i], bottom = block.bottom[i];
    if (occlusion.hides(left, top, right, bottom, block.highest[i])) continue;
    draw_patches(block, i, id, tile);
    occlusion.drawn(left, top, right, bottom, 1, tile);
  }
}

}  // namespace

int rasterize_samples(const SampleJob& job) {
  const TileJob& of = job.tile;
  SampleTile tile{*of.buffers, *job.samples, {}};
  SampleOcclusion occlusion;
  bool fresh = true, filled = false;
  const auto clear_once = [&] {
    if (fresh) clear(of);
    fresh = false;
  };
  SmallEntry waiting[kLanes] = {};
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
    for_each_entry<SmallEntry>(bins[bin_index(of.tile, Stream::small)], [&](const SmallEntry& t) {
      clear_once();
      waiting[waits++] = t;
      if (waits == kLanes) {
        draw_small(of, waiting, waits, tile, occlusion);
        waits = 0;
      }
    });
  }
  if (waits > 0) draw_small(of, waiting, waits, tile, occlusion);
  clear_once();
  job.samples->fragments = job.samples->pixels = 0;
  if (tile.any_open) collect(job);
  const int covered = filled ? kTilePixels : count_covered(*of.buffers);
  if (covered < kTilePixels) fill_background(of);
  return covered;
}

}  // namespace blysk::BLYSK_ISA
