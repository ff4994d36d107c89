// Visibility of one tile: edge functions over rows of sixteen pixels, depth, triangle ids.
//
// Based on: J. Pineda. A parallel algorithm for polygon rasterization. 1988.
#include <hwy/cache_control.h>

#include "geometry/bin_writer.h"
#include "raster/clear_tile.h"
#include "simd/kernels.h"
#include "simd/lanes.h"

namespace blysk::BLYSK_ISA {
namespace {

// A triangle ready for its rows in one tile. Edge functions count pixels: for integers e and s, e + 256 k s
// >= 0 exactly if (e >> 8) + k s >= 0, so the low 8 bits can go and 32 bits suffice.
struct RowSetup {
  std::int32_t edge[3];  // at the first pixel
  std::int32_t step_x[3], step_y[3];
  float x, y;                        // first pixel centre minus vertex 0, subpixels
  float nearness, slope_x, slope_y;  // at vertex 0; per subpixel
  float lowest, highest;             // of the vertices: a sliver's slope must not carry a pixel beyond them
  std::int32_t left, top, right, bottom;  // in the tile, inclusive
  std::uint32_t id;
};

// The farthest depth of each block of 16 x 16 pixels: what lies behind it everywhere is hidden, and goes
// before any work per pixel. It only ever rejects what the depth test would, so it cannot show.
//
// Based on: N. Greene, M. Kass, G. Miller. Hierarchical Z-buffer visibility. 1993. Differs in: one level,
// brought up to date now and then.
class Occlusion {
 public:
  bool hides(const RowSetup& s) const {
    for (int y = s.top / kBlock; y <= s.bottom / kBlock; ++y) {
      for (int x = s.left / kBlock; x <= s.right / kBlock; ++x) {
        if (s.highest >= farthest_[y * kAcross + x]) return false;
      }
    }
    return true;
  }

  void drawn(const RowSetup& s, const TileBuffers& tile) {
    const unsigned columns = (2u << (s.right / kBlock)) - (1u << (s.left / kBlock));
    for (int y = s.top / kBlock; y <= s.bottom / kBlock; ++y) stale_ |= columns << (y * kAcross);
    if (++waited_ >= kWait) refresh(tile);
  }

 private:
  static constexpr int kBlock = kLanes, kAcross = kTileSize / kBlock;
  static constexpr int kWait = 32;  // triangles: a refresh costs as much as drawing one or two

  void refresh(const TileBuffers& tile) {
    waited_ = 0;
    for (; stale_ != 0; stale_ &= stale_ - 1) {
      const int block = __builtin_ctz(stale_);
      const float* at = tile.nearness + block / kAcross * kBlock * kTileSize + block % kAcross * kBlock;
      F32 least = load(at);
      for (int row = 1; row < kBlock; ++row) least = min(least, load(at + row * kTileSize));
      float lanes[kLanes];
      store(least, lanes);
      float farthest = lanes[0];
      for (int i = 1; i < kLanes; ++i) farthest = min(farthest, lanes[i]);
      farthest_[block] = farthest;
    }
  }

  float farthest_[kAcross * kAcross] = {};
  unsigned stale_ = 0;
  int waited_ = 0;
};

int count_covered(const TileBuffers& tile) {
  int n = 0;
  for (int i = 0; i < kTilePixels; i += kLanes) n += __builtin_popcount(to_bits(load(tile.id + i) >= I32(0)));
  return n;
}

// Sixteen pixels that the edges cover are taken over where they are nearer.
BLYSK_INLINE void depth_test(Mask covered, F32 nearness, std::uint32_t id, float* depth_at,
                             std::uint32_t* id_at) {
  const F32 old = load(depth_at);
  // Equal depths are rare outside exact copies, so the ids are only read then. Ids stay below 2^31,
  // kNoTriangle is -1 as a signed number and nothing drawn has depth below 0, so "no triangle" is told apart
  // by its own test.
  Mask wins = covered & (nearness > old);
  const Mask ties = covered & (nearness == old);
  if (__builtin_expect(any(ties), 0)) {
    const I32 owner = load(id_at);
    wins = wins | (ties & ((owner > I32(static_cast<std::int32_t>(id))) | (owner < I32(0))));
  }
  // No branch on an empty mask: for small triangles it would be mispredicted more often than it spares a
  // store.
  store_masked(wins, nearness, depth_at);
  store_masked(wins, I32(static_cast<std::int32_t>(id)), id_at);
}

BLYSK_INLINE void draw_rows(const RowSetup& s, TileBuffers& tile) {
  const I32 lane = iota(0);
  const F32 lane_x = to_float(shift_left<kSubpixelBits>(lane));
  const I32 ramp[3] = {lane * I32(s.step_x[0]), lane * I32(s.step_x[1]), lane * I32(s.step_x[2])};
  const F32 lowest(s.lowest), highest(s.highest);

  for (int left = s.left; left <= s.right; left += kLanes) {
    const int skipped = left - s.left;
    const Mask inside = lanes_below(s.right - left + 1);
    I32 e[3];
    for (int k = 0; k < 3; ++k) e[k] = ramp[k] + I32(s.edge[k] + skipped * s.step_x[k]);
    const F32 along = (F32(s.x + static_cast<float>(skipped * kSubpixels)) + lane_x) * F32(s.slope_x);

    float dy = s.y;
    int at = s.top * kTileSize + left;
    for (int y = s.top; y <= s.bottom; ++y, at += kTileSize) {
      const Mask covered = inside & ((e[0] | e[1] | e[2]) >= I32(0));
      const F32 plane = F32(s.nearness + dy * s.slope_y) + along;
      depth_test(covered, min(max(plane, lowest), highest), s.id, tile.nearness + at, tile.id + at);
      for (int k = 0; k < 3; ++k) e[k] = e[k] + I32(s.step_y[k]);
      dy += static_cast<float>(kSubpixels);
    }
  }
}

// Sixteen set-ups as columns.
struct SetupBlock {
  std::int32_t edge[3][kLanes], step_x[3][kLanes], step_y[3][kLanes];
  float x[kLanes], y[kLanes], nearness[kLanes], slope_x[kLanes], slope_y[kLanes], lowest[kLanes],
      highest[kLanes];
  std::int32_t left[kLanes], top[kLanes], right[kLanes], bottom[kLanes];
};

// One edge a -> b of sixteen small triangles; all products fit 32 bits.
BLYSK_INLINE void set_up_edge(I32 ax, I32 ay, I32 bx, I32 by, I32 px, I32 py, SetupBlock& out, int k) {
  const I32 dx = bx - ax, dy = by - ay;
  const Mask owns = (dy < I32(0)) | ((dy == I32(0)) & (dx > I32(0)));  // top or left
  const I32 value = dx * (py - ay) - dy * (px - ax) + select(owns, I32(0), I32(-1));
  store(shift_right<kSubpixelBits>(value), out.edge[k]);
  store(I32(0) - dy, out.step_x[k]);
  store(dx, out.step_y[k]);
}

BLYSK_INLINE void set_up_small(const TileJob& job, const SmallEntry* entries, SetupBlock& out) {
  I32 x[3], y[3];
  F32 z[3], entry[4];
  gather_rows<4>(reinterpret_cast<const float*>(entries), iota(0), entry);
  for (int k = 0; k < 3; ++k) {
    F32 vertex[4];
    gather_rows<4>(reinterpret_cast<const float*>(job.vertices), bits_of(entry[k + 1]), vertex);
    x[k] = bits_of(vertex[0]) - I32(job.x * kSubpixels);
    y[k] = bits_of(vertex[1]) - I32(job.y * kSubpixels);
    z[k] = vertex[2];
  }
  const auto first = [](I32 v) { return shift_right<kSubpixelBits>(v + I32(kSubpixels / 2 - 1)); };
  const auto last = [](I32 v) { return shift_right<kSubpixelBits>(v - I32(kSubpixels / 2)); };
  const I32 left = max(first(min(min(x[0], x[1]), x[2])), I32(0));
  const I32 top = max(first(min(min(y[0], y[1]), y[2])), I32(0));
  store(left, out.left);
  store(top, out.top);
  store(min(last(max(max(x[0], x[1]), x[2])), I32(job.width - 1)), out.right);
  store(min(last(max(max(y[0], y[1]), y[2])), I32(job.height - 1)), out.bottom);

  const I32 px = shift_left<kSubpixelBits>(left) + I32(kSubpixels / 2);
  const I32 py = shift_left<kSubpixelBits>(top) + I32(kSubpixels / 2);
  set_up_edge(x[1], y[1], x[2], y[2], px, py, out, 0);
  set_up_edge(x[2], y[2], x[0], y[0], px, py, out, 1);
  set_up_edge(x[0], y[0], x[1], y[1], px, py, out, 2);

  const I32 dx1 = x[1] - x[0], dy1 = y[1] - y[0], dx2 = x[2] - x[0], dy2 = y[2] - y[0];
  const F32 inverse = F32(1.0f) / to_float(dx1 * dy2 - dx2 * dy1);
  const F32 dz1 = z[1] - z[0], dz2 = z[2] - z[0];
  store((dz1 * to_float(dy2) - dz2 * to_float(dy1)) * inverse, out.slope_x);
  store((dz2 * to_float(dx1) - dz1 * to_float(dx2)) * inverse, out.slope_y);
  store(to_float(px - x[0]), out.x);
  store(to_float(py - y[0]), out.y);
  store(z[0], out.nearness);
  store(min(min(z[0], z[1]), z[2]), out.lowest);
  store(max(max(z[0], z[1]), z[2]), out.highest);
}

BLYSK_INLINE RowSetup row_setup(const SetupBlock& b, int i, std::uint32_t id) {
  RowSetup s;
  for (int k = 0; k < 3; ++k) {
    s.edge[k] = b.edge[k][i];
    s.step_x[k] = b.step_x[k][i];
    s.step_y[k] = b.step_y[k][i];
  }
  s.x = b.x[i];
  s.y = b.y[i];
  s.nearness = b.nearness[i];
  s.slope_x = b.slope_x[i];
  s.slope_y = b.slope_y[i];
  s.lowest = b.lowest[i];
  s.highest = b.highest[i];
  s.left = b.left[i];
  s.top = b.top[i];
  s.right = b.right[i];
  s.bottom = b.bottom[i];
  s.id = id;
  return s;
}

BLYSK_INLINE void draw(const RowSetup& s, TileBuffers& tile, Occlusion& occlusion) {
  if (occlusion.hides(s)) return;
  draw_rows(s, tile);
  occlusion.drawn(s, tile);
}

void draw_small(const TileJob& job, const SmallEntry* entries, int count, Occlusion& occlusion) {
  SetupBlock block;
  set_up_small(job, entries, block);
  for (int i = 0; i < count; ++i) draw(row_setup(block, i, entries[i].id), *job.buffers, occlusion);
}

RowSetup set_up_large(const TileJob& job, const LargeEntry& t) {
  RowSetup s;
  const auto first = [](std::int32_t v) { return (v + kSubpixels / 2 - 1) >> kSubpixelBits; };
  const auto last = [](std::int32_t v) { return (v - kSubpixels / 2) >> kSubpixelBits; };
  s.left = max(first(min(min(t.x[0], t.x[1]), t.x[2])) - job.x, 0);
  s.top = max(first(min(min(t.y[0], t.y[1]), t.y[2])) - job.y, 0);
  s.right = min(last(max(max(t.x[0], t.x[1]), t.x[2])) - job.x, job.width - 1);
  s.bottom = min(last(max(max(t.y[0], t.y[1]), t.y[2])) - job.y, job.height - 1);
  s.id = t.id;

  const std::int64_t px = std::int64_t{job.x + s.left} * kSubpixels + kSubpixels / 2;
  const std::int64_t py = std::int64_t{job.y + s.top} * kSubpixels + kSubpixels / 2;
  // Inside a tile an edge function changes by less than 64 * 2 * 2^23 = 2^30: beyond that only its sign
  // matters.
  constexpr std::int64_t kFar = std::int64_t{1} << 30;
  for (int k = 0; k < 3; ++k) {
    const int a = (k + 1) % 3, b = (k + 2) % 3;
    const std::int64_t dx = std::int64_t{t.x[b]} - t.x[a], dy = std::int64_t{t.y[b]} - t.y[a];
    const bool owns = dy < 0 || (dy == 0 && dx > 0);
    const std::int64_t value = dx * (py - t.y[a]) - dy * (px - t.x[a]) + (owns ? 0 : -1);
    s.edge[k] = static_cast<std::int32_t>(clamp(value >> kSubpixelBits, -kFar, kFar));
    s.step_x[k] = static_cast<std::int32_t>(-dy);
    s.step_y[k] = static_cast<std::int32_t>(dx);
  }

  const double dx1 = t.x[1] - t.x[0], dy1 = t.y[1] - t.y[0], dx2 = t.x[2] - t.x[0], dy2 = t.y[2] - t.y[0];
  const double inverse = 1.0 / (dx1 * dy2 - dx2 * dy1);
  const double dz1 = double{t.nearness[1]} - double{t.nearness[0]},
               dz2 = double{t.nearness[2]} - double{t.nearness[0]};
  s.slope_x = static_cast<float>((dz1 * dy2 - dz2 * dy1) * inverse);
  s.slope_y = static_cast<float>((dz2 * dx1 - dz1 * dx2) * inverse);
  s.x = static_cast<float>(px - t.x[0]);
  s.y = static_cast<float>(py - t.y[0]);
  s.nearness = t.nearness[0];
  s.lowest = min(min(t.nearness[0], t.nearness[1]), t.nearness[2]);
  s.highest = max(max(t.nearness[0], t.nearness[1]), t.nearness[2]);
  return s;
}

// Whether a triangle covers every pixel of a whole tile: no edge is negative at any corner.
bool covers_tile(const RowSetup& s) {
  constexpr int kLast = kTileSize - 1;
  if (s.left != 0 || s.top != 0 || s.right != kLast || s.bottom != kLast) return false;
  for (int k = 0; k < 3; ++k) {
    if (s.edge[k] + kLast * (min(s.step_x[k], 0) + min(s.step_y[k], 0)) < 0) return false;
  }
  return true;
}

// What draw_rows() leaves of a triangle that covers a clear tile, without clearing or asking first.
void fill_tile(const RowSetup& s, TileBuffers& tile) {
  const F32 lane_x = to_float(shift_left<kSubpixelBits>(iota(0)));
  const I32 id(static_cast<std::int32_t>(s.id));
  float dy = s.y;
  for (int y = 0; y < kTileSize; ++y, dy += static_cast<float>(kSubpixels)) {
    const F32 row(s.nearness + dy * s.slope_y);
    for (int x = 0; x < kTileSize; x += kLanes) {
      const F32 along = (F32(s.x + static_cast<float>(x * kSubpixels)) + lane_x) * F32(s.slope_x);
      store(min(max(row + along, F32(s.lowest)), F32(s.highest)), tile.nearness + y * kTileSize + x);
      store(id, tile.id + y * kTileSize + x);
    }
  }
}

BLYSK_INLINE void draw_dot(TileBuffers& tile, const DotEntry& dot) {
  float& nearness = tile.nearness[dot.at];
  std::uint32_t& id = tile.id[dot.at];
  if (dot.nearness > nearness || (dot.nearness == nearness && dot.id < id)) {
    nearness = dot.nearness;
    id = dot.id;
  }
}

}  // namespace

void store_tile(const TileBuffers& tile, int width, int rows, std::uint32_t* to, std::size_t stride) {
  // Whole lines go past the caches: a picture is not read again before the last tile is done, and fetching
  // lines only to overwrite them would cost as much as the store.
  const bool stream =
      width == kTileSize && reinterpret_cast<std::uintptr_t>(to) % 64 == 0 && stride % 16 == 0;
  for (int row = 0; row < rows; ++row, to += stride) {
    const std::uint32_t* from = tile.color + row * kTileSize;
    if (stream) {
      for (int i = 0; i < kTileSize; i += kLanes) store_past_caches(load(from + i), to + i);
    } else {
      std::memcpy(to, from, static_cast<std::size_t>(width) * sizeof *to);
    }
  }
  if (stream) hwy::FlushStream();
}

int rasterize_tile(const TileJob& job) {
  bool fresh = true, filled = false;
  const auto clear_once = [&] {
    if (fresh) clear(job);
    fresh = false;
  };
  Occlusion occlusion;
  SmallEntry waiting[kLanes] = {};
  int waits = 0;
  for (int i = 0; i < job.bins_count; ++i) {
    const Bin* bins = job.bins[i];
    for_each_entry<LargeEntry>(bins[bin_index(job.tile, Stream::large)], [&](const LargeEntry& t) {
      const RowSetup s = set_up_large(job, t);
      if (fresh && covers_tile(s)) {
        fill_tile(s, *job.buffers);
        fresh = false;
        filled = true;
        return;
      }
      clear_once();
      draw(s, *job.buffers, occlusion);
    });
    for_each_entry<SmallEntry>(bins[bin_index(job.tile, Stream::small)], [&](const SmallEntry& t) {
      clear_once();
      waiting[waits++] = t;
      if (waits == kLanes) {
        draw_small(job, waiting, waits, occlusion);
        waits = 0;
      }
    });
  }
  if (waits > 0) draw_small(job, waiting, waits, occlusion);
  clear_once();
  for (int i = 0; i < job.bins_count; ++i) {
    for_each_entry<DotEntry>(job.bins[i][bin_index(job.tile, Stream::dot)],
                             [&](const DotEntry& dot) { draw_dot(*job.buffers, dot); });
  }
  if (filled) return kTilePixels;
  const int covered = count_covered(*job.buffers);
  if (covered < kTilePixels) fill_background(job);
  return covered;
}

}  // namespace blysk::BLYSK_ISA
