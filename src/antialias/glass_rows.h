// antialias/glass_rows.h - transparent triangles into the lists of their pixels.
#pragma once

#include "antialias/glass.h"
#include "antialias/sample_rows.h"

namespace blysk::BLYSK_ISA {

/// A part more of a merged layer; of too many the two that show least become one, with the greater one's
/// colour.
BLYSK_INLINE void add_part(FullPixel& full, GlassPart part) {
  if (full.parts < kMostParts) {
    full.part[full.parts++] = part;
    return;
  }
  GlassPart* least = full.part;
  for (GlassPart& p : full.part) least = p.weight < least->weight ? &p : least;
  part.weight = part.weight + least->weight;
  if (2.0f * least->weight > part.weight) {
    least->weight = part.weight;
  } else {
    *least = part;
  }
}

/// Another layer becomes part of a full pixel's last one. What is seen through both is kept where all that
/// lies in front or behind is the same at all samples, and so is colour (specification of the A-buffer paper,
/// A.5) up to kMostParts. Depth lies nearer to the one that covers more, and of slopes the flatter ones are
/// kept (A.7, M1): a steep plane that has come to cover the whole pixel would hide what lies before it.
BLYSK_INLINE void merge_layer(FullPixel& full, GlassLayer& into, const GlassLayer& other) {
  const auto count = [](std::uint32_t mask) { return static_cast<float>(__builtin_popcount(mask)); };
  const auto flatter = [](float a, float b) { return (b < 0 ? -b : b) < (a < 0 ? -a : a) ? b : a; };
  const float covers = count(into.mask), other_covers = count(other.mask),
              both = count(into.mask & other.mask);
  const float a = 1.0f - into.opacity, b = 1.0f - other.opacity;
  const bool behind = other.center < into.center;
  const float before_into = behind ? 0.0f : both * other.opacity,
              before_other = behind ? both * into.opacity : 0.0f;
  const float keeps = (covers - before_into) / covers;
  for (int i = 0; i < full.parts; ++i) full.part[i].weight = full.part[i].weight * keeps;
  add_part(full, {other.id, other.mask, (other_covers - before_other) * other.opacity});

  const float through = ((covers - both) * a + (other_covers - both) * b) + both * (a * b);
  into.mask |= other.mask;
  into.opacity = 1.0f - through / count(into.mask);
  into.center = into.center + (other.center - into.center) * (other_covers / (covers + other_covers));
  into.slope_x = flatter(into.slope_x, other.slope_x);
  into.slope_y = flatter(into.slope_y, other.slope_y);
  into.lowest = min(into.lowest, other.lowest);
  into.highest = max(into.highest, other.highest);
}

/// The farther of two at the pixel's centre.
BLYSK_INLINE bool is_farther(const GlassLayer& a, const GlassLayer& b) {
  return a.center < b.center || (a.center == b.center && a.id > b.id);
}

/// The farthest of a full pixel's layers but for `but`.
BLYSK_INLINE int farthest_of(const GlassBuffers& g, const FullPixel& full, int but) {
  int best = but == 0 ? 1 : 0;
  for (int i = best + 1; i < kMostLayers; ++i) {
    if (i == but || full.center[i] > full.center[best]) continue;
    if (is_farther(g.layer[full.layer[i]], g.layer[full.layer[best]])) best = i;
  }
  return best;
}

BLYSK_INLINE void fill_pixel(GlassBuffers& g, int at) {
  FullPixel& full = g.full[at];
  int count = 0;
  for (std::int32_t i = g.first[at]; i >= 0; i = g.layer[i].next) {
    full.center[count] = g.layer[i].center;
    full.layer[count++] = i;
  }
  full.last = farthest_of(g, full, -1);
  full.second = farthest_of(g, full, full.last);
  const GlassLayer& last = g.layer[full.layer[full.last]];
  full.part[0] = {last.id, last.mask, static_cast<float>(__builtin_popcount(last.mask)) * last.opacity};
  full.parts = 1;
  g.merged[at] = 1;
}

/// A pixel that is full gives up the farthest of its layers and the new one: they show least.
__attribute__((noinline)) inline void squeeze_layer(GlassBuffers& g, int at, GlassLayer layer) {
  if (g.merged[at] == 0) fill_pixel(g, at);
  FullPixel& full = g.full[at];
  GlassLayer &last = g.layer[full.layer[full.last]], &second = g.layer[full.layer[full.second]];
  ++g.merges;
  if (is_farther(layer, second)) {
    merge_layer(full, last, layer);
    return;
  }
  merge_layer(full, last, second);
  layer.next = second.next;
  second = layer;
  full.center[full.second] = layer.center;
  full.second = farthest_of(g, full, full.last);
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
