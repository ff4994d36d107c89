// Visibility of one tile at sixteen samples a pixel, and the fragments that are left of it.
//
// Based on: the A-buffer paper, visibility masks; specification A.3. Differs in: masks are not kept with
// fragments but samples with their surfaces, which is the same (invariant 4) and bounded by itself.
#include "antialias/glass_compose.h"
#include "antialias/glass_rows.h"
#include "antialias/sample_occlusion.h"
#include "antialias/sample_tile.h"
#include "geometry/bin_writer.h"
#include "raster/clear_tile.h"
#include "simd/kernels.h"

namespace blysk::BLYSK_ISA {
namespace {

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

// Fragments in the order in which they are found.
template <bool kCenters>
class FragmentWriter {
 public:
  explicit BLYSK_INLINE FragmentWriter(const SampleBuffers& s)
      : id_(s.fragment_id), place_(s.fragment_place), nearness_(s.fragment_nearness), count_(s.fragments) {}

  /// Of some samples of a pixel: writes the fragment of the first of `rest`, which counts if there is any;
  /// what is left of `rest`.
  BLYSK_INLINE unsigned write(const PixelSamples& pixel, I32 ids, int at, unsigned rest, bool counts) {
    const std::int32_t id = pixel.id[__builtin_ctz(rest | 1u << (kSamples - 1))];
    const unsigned same = to_bits(ids == I32(id));
    id_[count_] = id;
    place_[count_] = fragment_word(at, same);
    if constexpr (kCenters) nearness_[count_] = mean_nearness(load(pixel.nearness), same);
    count_ += static_cast<int>(counts);
    return rest & ~same;
  }
  BLYSK_INLINE int count() const { return count_; }

 private:
  std::int32_t *id_, *place_;
  float* nearness_;
  int count_;
};

// How many surfaces a pixel shows no branch can foresee. So all pixels write two, which count if they are
// there, and what is left waits in a queue, from which each step takes one and to which it returns the rest.
template <bool kCenters>
void collect(const SampleJob& job) {
  SampleBuffers& s = *job.samples;
  FragmentWriter<kCenters> fragments(s);
  TileBuffers& tile = *job.tile.buffers;
  const I32 many(static_cast<std::int32_t>(kManySurfaces)), nothing(kNoSurface);
  int queued = 0, pixels = s.pixels;
  for (int row = 0; row < job.tile.height; ++row) {
    for (int column = 0; column < job.tile.width; column += kLanes) {
      const int block = row * kTileSize + column;
      unsigned open = to_bits(load(tile.id + block) == many);
      if (job.glass != nullptr) open &= to_bits(load(job.glass->first + block) < I32(0));
      for (; open != 0; open &= open - 1) {
        const int at = block + __builtin_ctz(open);
        const PixelSamples& pixel = s.open[SampleBuffers::place_of(at)];
        const I32 ids = load(pixel.id);
        const unsigned uncovered = to_bits(ids == nothing);
        const std::int32_t first = pixel.id[0];
        const bool shared = to_bits(ids == I32(first)) != kAllSamples;
        const std::uint32_t whole = first == kNoSurface ? kNoTriangle : static_cast<std::uint32_t>(first);
        tile.id[at] = shared ? kManySurfaces : whole;
        unsigned rest = fragments.write(pixel, ids, at, kAllSamples & ~uncovered, shared);
        rest = fragments.write(pixel, ids, at, rest, rest != 0);
        s.queue[queued] = static_cast<std::uint32_t>(at) | rest << 2 * kTileBits;
        queued += static_cast<int>(rest != 0);
        s.pixel[pixels] = at;
        pixels += static_cast<int>(shared);
        const auto clear = static_cast<float>(__builtin_popcount(uncovered));
        for (int k = 0; k < 4; ++k) s.sum[4 * at + k] = job.background[k] * clear;
      }
    }
  }
  for (int i = 0; i < queued; ++i) {
    const int at = static_cast<int>(s.queue[i] & (kTilePixels - 1));
    const PixelSamples& pixel = s.open[SampleBuffers::place_of(at)];
    const unsigned rest = fragments.write(pixel, load(pixel.id), at, s.queue[i] >> 2 * kTileBits, true);
    s.queue[queued] = static_cast<std::uint32_t>(at) | rest << 2 * kTileBits;
    queued += static_cast<int>(rest != 0);
  }
  s.fragments = fragments.count();
  s.pixels = pixels;
}

BLYSK_INLINE void draw_rows(const RowSurface& s, SampleTile& tile, SampleOcclusion& occlusion) {
  if (occlusion.hides(s.box(), s.ceiling)) return;
  RowPainter(s, tile).draw();
  occlusion.drawn(s.box().blocks(), 16, tile);
}

/// Small triangles on their way through a tile.
template <bool kCenters>
class SmallPainter {
 public:
  BLYSK_INLINE SmallPainter(const TileJob& job, SampleTile& tile, SampleOcclusion& occlusion)
      : job_(job), tile_(tile), occlusion_(occlusion), painter_(tile) {}

  /// Triangles wait until sixteen others have come after them, so that their vertices are there when they are
  /// asked for: these lie anywhere in memory.
  BLYSK_INLINE void add(const SmallEntry& t) {
    for (const std::uint32_t vertex : t.vertex) __builtin_prefetch(job_.vertices + vertex);
    waiting_[waits_++] = t;
    if (waits_ < 2 * kLanes) return;
    meet(waiting_, kLanes);
    waits_ = kLanes;
    std::memcpy(waiting_, waiting_ + kLanes, sizeof waiting_ / 2);
  }

  BLYSK_INLINE void finish() {
    for (int first = 0; first < waits_; first += kLanes) meet(waiting_ + first, min(waits_ - first, kLanes));
    waits_ = 0;
    if (queue_.count() > 0) draw(queue_.count());
  }

 private:
  __attribute__((noinline)) void meet(const SmallEntry* entries, int count) {
    const SmallTriangles t = fetch_small(job_, entries);
    queue_.add(and_not(occlusion_.hidden(boxes_of(job_, t)), lanes_below(count)), t);
    if (queue_.count() >= kLanes) draw(kLanes);
  }

  __attribute__((noinline)) void draw(int count) {
    SmallBlock block;
    set_up_small(job_, queue_.take(), block);
    const unsigned there = (1u << count) - 1;
    for (unsigned rest = there & ~block.patches; rest != 0; rest &= rest - 1) {
      draw_rows(row_surface(block, __builtin_ctz(rest)), tile_, occlusion_);
    }
    std::uint64_t blocks = 0;
    for (unsigned rest = there & block.patches; rest != 0; rest &= rest - 1) {
      blocks |= block.blocks(__builtin_ctz(rest));
    }
    if (blocks == 0) return;
    tile_.open_all(blocks);
    painter_.template draw<kCenters>(block, lanes_of(there & block.patches));
    occlusion_.drawn(blocks, count, tile_);
  }

  const TileJob& job_;
  SampleTile& tile_;
  SampleOcclusion& occlusion_;
  PatchPainter painter_;
  SmallQueue queue_;
  SmallEntry waiting_[2 * kLanes] = {};
  int waits_ = 0;
};

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
  SmallPainter<kCenters> small(of, tile, occlusion);
  for (const Stream stream : {Stream::small, Stream::small_away}) {
    occlusion.refresh(tile);
    for (int i = 0; i < of.bins_count; ++i) {
      for_each_entry<SmallEntry>(of.bins[i][bin_index(of.tile, stream)], [&](const SmallEntry& t) {
        clear_once();
        small.add(t);
      });
    }
    small.finish();
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
