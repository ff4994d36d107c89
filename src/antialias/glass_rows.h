// antialias/glass_rows.h - transparent triangles into the lists of their pixels.
#pragma once

#include "antialias/glass.h"
#include "antialias/sample_rows.h"

namespace blysk::BLYSK_ISA {

/// Two layers as one: what is seen through both is kept where all that lies in front or behind is the same at
/// all samples; its colour and plane are those of the layer that shows more.
BLYSK_INLINE void merge_layers(GlassLayer& into, const GlassLayer& other) {
  const auto count = [](std::uint32_t mask) { return static_cast<float>(__builtin_popcount(mask)); };
  const float only_into = count(into.mask & ~other.mask), only_other = count(other.mask & ~into.mask);
  const float a = 1.0f - into.opacity, b = 1.0f - other.opacity;
  const float through = (only_into * a + only_other * b) + count(into.mask & other.mask) * (a * b);
  const std::int32_t next = into.next;
  const std::uint32_t mask = into.mask | other.mask;
  const float shows = count(into.mask) * into.opacity, other_shows = count(other.mask) * other.opacity;
  if (other_shows > shows || (other_shows == shows && other.center > into.center)) into = other;
  into.next = next;
  into.mask = mask;
  into.opacity = 1.0f - through / count(mask);
}

/// The farther of two at the pixel's centre.
BLYSK_INLINE bool is_farther(const GlassLayer& a, const GlassLayer& b) {
  return a.center < b.center || (a.center == b.center && a.id > b.id);
}

/// A pixel that is full gives up the farthest of its layers and the new one: they show least.
__attribute__((noinline)) inline void squeeze_layer(GlassBuffers& g, int at, GlassLayer layer) {
  GlassLayer *last = nullptr, *last_but_one = nullptr;
  for (std::int32_t i = g.first[at]; i >= 0; i = g.layer[i].next) {
    GlassLayer* const l = &g.layer[i];
    if (last == nullptr || is_farther(*l, *last)) {
      last_but_one = last;
      last = l;
    } else if (last_but_one == nullptr || is_farther(*l, *last_but_one)) {
      last_but_one = l;
    }
  }
  if (is_farther(*last_but_one, layer)) {  // the new one is among the two farthest
    merge_layers(*last, layer);
  } else {
    merge_layers(*last_but_one, *last);
    layer.next = last->next;
    *last = layer;
  }
  g.merged[at] = 1;
  ++g.merges;
}

BLYSK_INLINE void add_layer(GlassBuffers& g, int at, const GlassLayer& layer) {
  if (g.layers[at] == kMostLayers) {
    squeeze_layer(g, at, layer);
    return;
  }
  if (g.layers[at] == 0) g.pixel[g.pixels++] = at;
  ++g.layers[at];
  g.layer[g.used] = layer;
  g.layer[g.used].next = g.first[at];
  g.first[at] = g.used++;
}

class GlassPainter {
 public:
  BLYSK_INLINE GlassPainter(const TileJob& job, const GlassEntry& entry, SampleTile& tile,
                            GlassBuffers& glass)
      : s_(row_surface(job, entry.triangle)),
        edges_(s_),
        tile_(tile),
        glass_(glass),
        slopes_(tile.grid, s_.slope_x, s_.slope_y),
        first_x_(job.x),
        first_y_(job.y),
        opacity_(entry.opacity),
        varies_(entry.varying != nullptr) {
    if (varies_) varying_ = triangle_opacity(*entry.varying, job.vertices, entry.triangle.id);
    for (int k = 0; k < 3; ++k) {
      at_samples_[k] = I32(s_.dx[k]) * tile.grid.down - I32(s_.dy[k]) * tile.grid.across;
    }
  }

  BLYSK_INLINE void draw() {
    const I32 lane = iota(0);
    for (int y = s_.top; y <= s_.bottom; ++y) {
      for (int left = s_.left; left <= s_.right; left += kLanes) {
        Mask reached = lanes_below(s_.right - left + 1);
        for (int k = 0; k < 3; ++k) {
          const I32 e =
              I32(edges_.value[k] + (left - s_.left) * edges_.step_x[k] + (y - s_.top) * edges_.step_y[k]) +
              lane * I32(edges_.step_x[k]);
          reached = reached & (e >= I32(edges_.none[k]));
        }
        for (unsigned rest = to_bits(reached); rest != 0; rest &= rest - 1) {
          draw_pixel(left + __builtin_ctz(rest), y);
        }
      }
    }
  }

 private:
  BLYSK_INLINE void draw_pixel(int x, int y) {
    const int at = y * kTileSize + x;
    const Mask uncovered = samples_out(s_, at_samples_, x - s_.left, y - s_.top);
    if (to_bits(uncovered) == kAllSamples) return;
    ++glass_.generated;
    if (!tile_.is_open(at)) tile_.open_one(at);
    const float across = s_.x + static_cast<float>((x - s_.left) * kSubpixels);
    const float down = s_.y + static_cast<float>((y - s_.top) * kSubpixels);
    const float center = (s_.nearness + down * s_.slope_y) + across * s_.slope_x;
    const F32 depths = min(max(slopes_.depths(center), F32(s_.lowest)), F32(s_.highest));
    const PixelSamples& pixel = tile_.samples_of(at);
    const F32 opaque = load(pixel.nearness);
    const Mask front =
        and_not(uncovered, (depths > opaque) | ((depths == opaque) & (load(pixel.id) > I32(s_.id))));
    const unsigned mask = to_bits(front);
    if (mask == 0) return;
    const float opacity = varies_ ? opacity_at(varying_, first_x_ + x, first_y_ + y, mask) : opacity_;
    if (opacity == 0) return;
    add_layer(glass_, at, {s_.id, mask, center, s_.slope_x, s_.slope_y, s_.lowest, s_.highest, opacity, -1});
  }

  const RowSurface s_;
  const RowEdges edges_;
  SampleTile& tile_;
  GlassBuffers& glass_;
  const SampleSlopes slopes_;
  const int first_x_, first_y_;  // of the tile
  const float opacity_;
  const bool varies_;
  TriangleOpacity varying_;
  I32 at_samples_[3];
};

/// All transparent triangles of a tile whose opaque ones are drawn.
inline void draw_glass(const SampleJob& job, SampleTile& tile) {
  GlassBuffers& g = *job.glass;
  g.used = g.pixels = 0;
  g.generated = g.merges = 0;
  for (int i = 0; i < kTilePixels; i += kLanes) store(I32(-1), g.first + i);
  std::memset(g.layers, 0, sizeof g.layers);
  std::memset(g.merged, 0, sizeof g.merged);
  for (std::size_t i = 0; i < job.glass_count; ++i) {
    GlassPainter(job.tile, job.glass_entries[i], tile, g).draw();
  }
}

}  // namespace blysk::BLYSK_ISA
