// Sixteen triangles at a time: what misses all pixel centres (or all samples) goes before it touches memory,
// the very small ones end here as dots, the small ones go to bins.
#include "geometry/assemble.h"
#include "geometry/bin_writer.h"
#include "simd/kernels.h"
#include "simd/lanes.h"

namespace blysk::BLYSK_ISA {
namespace {

// A triangle whose box holds at most this many pixel centres a side is tested centre by centre here, sixteen
// triangles at once.
constexpr int kDotSide = 4;
// Under this extent (128 pixels) products of differences fit 32 bits.
constexpr std::int32_t kSmallExtent = 1 << 15;

// Up to kDotSide^2 dots of sixteen triangles.
constexpr int kDotRoom = kDotSide * kDotSide * kLanes + kLanes;

struct Triangles {
  I32 vertex[3];  // frame indices
  I32 x[3], y[3];
  F32 nearness[3];
  I32 area;                      // twice the area, 1/65536 pixel
  I32 left, top, right, bottom;  // pixels with a centre (or sample) in the box, inclusive
  I32 id;
};

BLYSK_INLINE I32 min3(const I32* v) { return min(min(v[0], v[1]), v[2]); }
BLYSK_INLINE I32 max3(const I32* v) { return max(max(v[0], v[1]), v[2]); }

template <class Lanes>
BLYSK_INLINE void swap_where(Mask m, Lanes& a, Lanes& b) {
  const Lanes old = a;
  a = select(m, b, a);
  b = select(m, old, b);
}

// Edge function a -> b, its value at the first centre and its steps; inside is >= 0 under the top-left rule.
struct Edge {
  I32 value, step_x, step_y;
};

BLYSK_INLINE Edge make_edge(const Triangles& t, int a, int b) {
  Edge e;
  const I32 dx = t.x[b] - t.x[a], dy = t.y[b] - t.y[a];
  e.step_x = I32(0) - shift_left<kSubpixelBits>(dy);
  e.step_y = shift_left<kSubpixelBits>(dx);
  // Top edges (level, interior below) and left edges (going up) own their points.
  const Mask owns = (dy < I32(0)) | ((dy == I32(0)) & (dx > I32(0)));
  const I32 bias = select(owns, I32(0), I32(-1));
  const I32 px = shift_left<kSubpixelBits>(t.left) + I32(kSubpixels / 2);
  const I32 py = shift_left<kSubpixelBits>(t.top) + I32(kSubpixels / 2);
  e.value = dx * (py - t.y[a]) - dy * (px - t.x[a]) + bias;
  return e;
}

struct Dots {
  std::int32_t id[kDotRoom], nearness[kDotRoom], place[kDotRoom];  // place: tile * 4096 + row * 64 + column
};

// Tests all centres of the boxes of `which` and writes the dots that are covered.
BLYSK_INLINE int find_dots(const AssembleJob& job, const Triangles& t, Mask which, Dots& dots,
                           Mask& hit_any) {
  Edge e0 = make_edge(t, 1, 2), e1 = make_edge(t, 2, 0), e2 = make_edge(t, 0, 1);
  // The plane of nearness, as the tile's kernels have it.
  const F32 z0 = t.nearness[0];
  const F32 inverse = F32(1.0f) / to_float(t.area);
  const F32 dz1 = t.nearness[1] - z0, dz2 = t.nearness[2] - z0;
  const I32 dx1 = t.x[1] - t.x[0], dy1 = t.y[1] - t.y[0], dx2 = t.x[2] - t.x[0], dy2 = t.y[2] - t.y[0];
  const F32 slope_x = (dz1 * to_float(dy2) - dz2 * to_float(dy1)) * inverse;
  const F32 slope_y = (dz2 * to_float(dx1) - dz1 * to_float(dx2)) * inverse;
  const F32 across = to_float(shift_left<kSubpixelBits>(t.left) + I32(kSubpixels / 2) - t.x[0]);
  const F32 down = to_float(shift_left<kSubpixelBits>(t.top) + I32(kSubpixels / 2) - t.y[0]);
  // Rounding must not carry a dot beyond its corners: below 0 it would be lost.
  const F32 lowest = min(min(z0, t.nearness[1]), t.nearness[2]);
  const F32 highest = max(max(z0, t.nearness[1]), t.nearness[2]);

  int n = 0;
  for (int j = 0; j < kDotSide; ++j) {
    const I32 row = t.top + I32(j);
    const Mask in_row = which & (row <= t.bottom);
    if (!any(in_row)) break;
    I32 v0 = e0.value, v1 = e1.value, v2 = e2.value;
    const F32 start = z0 + (down + F32(static_cast<float>(j * kSubpixels))) * slope_y;
    for (int i = 0; i < kDotSide; ++i) {
      const I32 column = t.left + I32(i);
      const Mask hit = in_row & (column <= t.right) & ((v0 | v1 | v2) >= I32(0));
      if (any(hit)) {
        const F32 plane = start + (across + F32(static_cast<float>(i * kSubpixels))) * slope_x;
        const F32 nearness = min(max(plane, lowest), highest);
        const I32 tile = shift_right<kTileBits>(row) * I32(job.tiles_x) + shift_right<kTileBits>(column);
        const I32 place = shift_left<2 * kTileBits>(tile) | shift_left<kTileBits>(row & I32(kTileSize - 1)) |
                          (column & I32(kTileSize - 1));
        store_compressed(hit, t.id, dots.id + n);
        store_compressed(hit, bits_of(nearness), dots.nearness + n);
        n += store_compressed(hit, place, dots.place + n);
        hit_any = hit_any | hit;
      }
      v0 = v0 + e0.step_x;
      v1 = v1 + e1.step_x;
      v2 = v2 + e2.step_x;
    }
    e0.value = e0.value + e0.step_y;
    e1.value = e1.value + e1.step_y;
    e2.value = e2.value + e2.step_y;
  }
  return n;
}

BLYSK_INLINE void bin_dots(const AssembleJob& job, const Dots& dots, int count) {
  for (int i = 0; i < count; ++i) {
    const auto place = static_cast<std::uint32_t>(dots.place[i]);
    Bin& bin = job.bins[bin_index(place >> (2 * kTileBits), Stream::dot)];
    append(*job.owner, bin,
           DotEntry{static_cast<std::uint32_t>(dots.id[i]), float_of_bits(dots.nearness[i]),
                    place & (kTilePixels - 1)});
  }
}

BLYSK_INLINE void bin_small(const AssembleJob& job, const Triangles& t, unsigned which, Mask away) {
  std::int32_t words[4 * kLanes], list[kLanes], columns[kLanes], rows[kLanes];
  store_interleaved(t.id, t.vertex[0], t.vertex[1], t.vertex[2], words);
  const I32 left = shift_right<kTileBits>(t.left), top = shift_right<kTileBits>(t.top);
  const I32 width = shift_right<kTileBits>(t.right) - left, height = shift_right<kTileBits>(t.bottom) - top;
  const auto number = [](Stream stream) { return I32(static_cast<std::int32_t>(stream)); };
  const I32 facing = select(away, number(Stream::small_away), number(Stream::small));
  const I32 stream = job.transparent ? number(Stream::glass_small) : facing;
  store((top * I32(job.tiles_x) + left) * I32(kStreams) + stream, list);
  store(width, columns);
  store(height, rows);
  const unsigned several = to_bits((width > I32(0)) | (height > I32(0)));
  Bin* const bins = job.bins;
  ThreadBins& owner = *job.owner;
  const int stride = job.tiles_x * kStreams;
  for (; which != 0; which &= which - 1) {
    const int k = __builtin_ctz(which);
    SmallEntry entry;
    std::memcpy(&entry, words + 4 * k, sizeof entry);
    Bin* const first = bins + list[k];
    if (__builtin_expect((several >> k & 1) == 0, 1)) {
      append(owner, *first, entry);
      continue;
    }
    for (int y = 0; y <= rows[k]; ++y) {
      for (int x = 0; x <= columns[k]; ++x) append(owner, first[y * stride + x * kStreams], entry);
    }
  }
}

// Samples lie on a lattice of their own: one every 64 subpixels from 32 on.
BLYSK_INLINE Mask meets_samples(I32 x_min, I32 x_max, I32 y_min, I32 y_max) {
  const auto any_between = [](I32 low, I32 high) {
    return shift_right<6>(low + I32(31)) <= shift_right<6>(high - I32(32));
  };
  return any_between(x_min, x_max) & any_between(y_min, y_max);
}

template <Sampling kSampling>
BLYSK_INLINE void assemble_block(AssembleJob& job, const I32 index[3], I32 id, Mask valid) {
  Triangles t;
  t.id = id;
  for (int k = 0; k < 3; ++k) {
    t.vertex[k] = index[k] + I32(static_cast<std::int32_t>(job.vertex_base));
    F32 vertex[4];
    gather_rows<4>(reinterpret_cast<const float*>(job.vertices), t.vertex[k], vertex);
    t.x[k] = bits_of(vertex[0]);
    t.y[k] = bits_of(vertex[1]);
    t.nearness[k] = vertex[2];
  }
  const I32 x_min = min3(t.x), x_max = max3(t.x), y_min = min3(t.y), y_max = max3(t.y);
  const Mask unplaced = x_min == I32(kUnplaced);

  // Pixel centres in the box, then in the picture too. What is tiny must not depend on where the picture
  // ends.
  constexpr int kReach = reach_of(kSampling);
  const I32 before(kSubpixels / 2 - 1 - kReach), after(kSubpixels / 2 - kReach);
  t.left = shift_right<kSubpixelBits>(x_min + before);
  t.top = shift_right<kSubpixelBits>(y_min + before);
  t.right = shift_right<kSubpixelBits>(x_max - after);
  t.bottom = shift_right<kSubpixelBits>(y_max - after);
  const Mask few = (t.right - t.left < I32(kDotSide)) & (t.bottom - t.top < I32(kDotSide));
  t.left = max(t.left, I32(0));
  t.top = max(t.top, I32(0));
  t.right = min(t.right, I32(job.width - 1));
  t.bottom = min(t.bottom, I32(job.height - 1));
  Mask reaches = (t.left <= t.right) & (t.top <= t.bottom);
  if constexpr (kSampling == Sampling::samples) reaches = reaches & meets_samples(x_min, x_max, y_min, y_max);
  const Mask large = (x_max - x_min >= I32(kSmallExtent)) | (y_max - y_min >= I32(kSmallExtent));

  const Mask rest = valid & (unplaced | (large & reaches));
  if (any(rest)) {
    job.rest_count += static_cast<std::size_t>(
        store_compressed(rest, id - I32(static_cast<std::int32_t>(job.id_base)),
                         reinterpret_cast<std::int32_t*>(job.rest) + job.rest_count));
  }
  const Mask placed = and_not(unplaced | large, valid);

  t.area = (t.x[1] - t.x[0]) * (t.y[2] - t.y[0]) - (t.x[2] - t.x[0]) * (t.y[1] - t.y[0]);
  const Mask negative = t.area < I32(0);
  Mask live = placed & (t.area != I32(0));
  if (job.drop != DropArea::none) {
    const Mask away = live & (job.drop == DropArea::negative ? negative : t.area > I32(0));
    job.culled += static_cast<std::uint64_t>(__builtin_popcount(to_bits(away)));
    live = and_not(away, live);
  }
  live = live & reaches;
  if (!any(live)) return;

  t.area = select(negative, I32(0) - t.area, t.area);
  swap_where(negative, t.x[1], t.x[2]);
  swap_where(negative, t.y[1], t.y[2]);
  swap_where(negative, t.vertex[1], t.vertex[2]);
  swap_where(negative, t.nearness[1], t.nearness[2]);

  unsigned small_bits = to_bits(live);
  if constexpr (kSampling == Sampling::centers) {
    const Mask tiny = live & few;
    const unsigned tiny_bits = to_bits(tiny);
    if (tiny_bits != 0) {
      Dots dots;
      Mask hit = and_not(tiny, tiny);
      bin_dots(job, dots, find_dots(job, t, tiny, dots, hit));
      job.drawn += static_cast<std::uint64_t>(__builtin_popcount(to_bits(hit)));
    }
    small_bits &= ~tiny_bits;
  }
  if (small_bits != 0) {
    // From the front a triangle turns counter-clockwise: its area is negative.
    bin_small(job, t, small_bits,
              kSampling == Sampling::samples ? and_not(negative, live) : and_not(live, live));
    job.drawn += static_cast<std::uint64_t>(__builtin_popcount(small_bits));
  }
}

template <Sampling kSampling>
void assemble_all(AssembleJob& job) {
  I32 index[3];
  const std::uint32_t* in = job.indices + 3 * job.first;
  const auto id = static_cast<std::int32_t>(job.id_base + job.first);
  std::size_t i = 0;
  for (; i + kLanes <= job.count; i += kLanes) {
    load_interleaved(in + 3 * i, index[0], index[1], index[2]);
    assemble_block<kSampling>(job, index, iota(id + static_cast<std::int32_t>(i)), lanes_below(kLanes));
  }
  if (i < job.count) {
    std::uint32_t rest[3 * kLanes] = {};
    std::memcpy(rest, in + 3 * i, (job.count - i) * 3 * sizeof(std::uint32_t));
    load_interleaved(rest, index[0], index[1], index[2]);
    assemble_block<kSampling>(job, index, iota(id + static_cast<std::int32_t>(i)),
                              lanes_below(static_cast<int>(job.count - i)));
  }
}

}  // namespace

void assemble_triangles(AssembleJob& job) {
  if (job.sampling == Sampling::samples) {
    assemble_all<Sampling::samples>(job);
  } else {
    assemble_all<Sampling::centers>(job);
  }
}

}  // namespace blysk::BLYSK_ISA
