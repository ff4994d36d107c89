// shading/shade_tile.h - walks the pixels of a draw in a tile and hands them to a shading method.
//
// Runs of one triangle in a row are shaded as spans: the triangle's values are plain floats, sixteen pixels
// at a time. Where triangles change too often for that, pixels are gathered until sixteen of them, each with
// its own triangle, fill the lanes. A method is written once for both; a pixel's value does not depend on
// which way it went.
//
// A method is a struct of static templates over F, float or F32:
//   template <class F> struct Triangle;                             what is known per triangle; has .corners
//   template <class F> Triangle<F> set_up_triangle(job, triangle);  from the number of the triangle in the
//   mesh template <class F, class Y> struct Span / set_up_span(job, triangle, y);  what is known per row of
//   it, y in subpixels shade(job, triangle, span, x, y, nearness) -> Rgb<F32>          sixteen pixel centres,
//   x in subpixels
#pragma once

#include "image/transfer.h"
#include "raster/tile.h"
#include "shading/corners.h"
#include "shading/shade.h"
#include "simd/lanes.h"

namespace blysk::BLYSK_ISA {

BLYSK_INLINE F32 unit_clamp(F32 v) { return min(max(v, F32(0.0f)), F32(1.0f)); }

/// 0..1 to 0..255 in the low byte by the transfer function (image/transfer.h is the model); the highest byte
/// is not clean.
BLYSK_INLINE I32 encode(Transfer transfer, F32 v) {
  // Adding 2^23 leaves the nearest integer in the low bits (and 0x4b above them, which pack() lets fall out).
  if (transfer == Transfer::none) return bits_of(unit_clamp(v) * F32(255.0f) + F32(8388608.0f));
  const I32 bits = bits_of(min(max(v, F32(kSrgbLowest)), F32(kSrgbHighest)));
  const I32 segment =
      gather(kSrgbSegments, shift_right<20>(bits - I32(static_cast<std::int32_t>(kSrgbLowestBits))));
  const I32 base = shift_left<9>(shift_right<16>(segment) & I32(0xffff));
  return shift_right<16>(base + (segment & I32(0xffff)) * (shift_right<12>(bits) & I32(0xff)));
}

/// Takes colours to the tile's pixels.
struct ColorSink {
  static BLYSK_INLINE I32 pack(const ShadeJob& job, const Rgb<F32>& c) {
    const I32 rg = encode(job.transfer, c.x) | shift_left<8>(encode(job.transfer, c.y));
    return rg | shift_left<16>(encode(job.transfer, c.z)) | I32(static_cast<std::int32_t>(0xff000000));
  }
  static BLYSK_INLINE void row(const ShadeJob& job, int at, Mask m, const Rgb<F32>& c) {
    store_masked(m, pack(job, c), job.buffers->color + at);
  }
  static BLYSK_INLINE void scatter(const ShadeJob& job, const std::int32_t* at, int count,
                                   const Rgb<F32>& c) {
    std::int32_t pixel[kLanes];
    store(pack(job, c), pixel);
    for (int i = 0; i < count; ++i) job.buffers->color[at[i]] = static_cast<std::uint32_t>(pixel[i]);
  }
};

/// Pixels that wait until sixteen have come together.
struct Strays {
  std::int32_t triangle[2 * kLanes], at[2 * kLanes];
  int count = 0;
};

/// Below this many pixels a run they are gathered: a span's set-up costs as much as a few gathered pixels.
inline constexpr int kSpanPixels = 12;

template <class Method, class Sink>
BLYSK_INLINE void shade_strays(const ShadeJob& job, Strays& s, int count) {
  const I32 at = load(s.at);
  const auto center = [](I32 pixel) {
    return to_float(shift_left<kSubpixelBits>(pixel) + I32(kSubpixels / 2));
  };
  const F32 x = center((at & I32(kTileSize - 1)) + I32(job.x));
  const F32 y = center(shift_right<kTileBits>(at) + I32(job.y));
  const auto triangle = Method::template set_up_triangle<F32>(job, load(s.triangle));
  const auto span = Method::set_up_span(job, triangle, y);
  Sink::scatter(job, s.at, count,
                Method::shade(job, triangle, span, x, y, gather(job.buffers->nearness, at)));
}

template <class Method, class Sink>
BLYSK_INLINE void flush_strays(const ShadeJob& job, Strays& s) {
  if (s.count == 0) return;
  // Lanes past the last pixel repeat it: their work is thrown away, but it must be sound.
  for (int i = s.count; i < kLanes; ++i) {
    s.triangle[i] = s.triangle[s.count - 1];
    s.at[i] = s.at[s.count - 1];
  }
  shade_strays<Method, Sink>(job, s, s.count);
  s.count = 0;
}

template <class Method, class Sink>
BLYSK_INLINE void shade_draw(const ShadeJob& job) {
  using Triangle = typename Method::template Triangle<float>;
  Strays strays;
  Triangle triangle;
  std::int32_t known = -1;  // the triangle that `triangle` was set up for
  const I32 first_id(static_cast<std::int32_t>(job.draw->id_base));
  const I32 last_id(static_cast<std::int32_t>(job.draw->id_base + job.draw->id_count - 1));

  for (int row = 0; row < job.height; ++row) {
    const float y = static_cast<float>((job.y + row) * kSubpixels + kSubpixels / 2);
    for (int column = 0; column < job.width; column += kLanes) {
      const int at = row * kTileSize + column;
      const I32 id = load(job.buffers->id + at);
      // kNoTriangle is -1 here and drops out of the range.
      const unsigned mine = to_bits((id >= first_id) & (id <= last_id) & lanes_below(job.width - column));
      if (mine == 0) continue;
      // The last pixels of runs, in this block of sixteen.
      const unsigned ends = mine & (to_bits(id != load(job.buffers->id + at + 1)) | 1u << (kLanes - 1));

      if (__builtin_popcount(ends) * kSpanPixels > __builtin_popcount(mine)) {
        const Mask m = lanes_of(mine);
        store_compressed(m, id - first_id, strays.triangle + strays.count);
        strays.count += store_compressed(m, iota(at), strays.at + strays.count);
        if (strays.count >= kLanes) {
          shade_strays<Method, Sink>(job, strays, kLanes);
          strays.count -= kLanes;
          store(load(strays.triangle + kLanes), strays.triangle);
          store(load(strays.at + kLanes), strays.at);
        }
        continue;
      }
      const F32 x =
          to_float(iota(job.x + column)) * F32(static_cast<float>(kSubpixels)) + F32(kSubpixels / 2.0f);
      const F32 nearness = load(job.buffers->nearness + at);
      for (unsigned left = mine; left != 0;) {
        const unsigned run = left & ((2u << __builtin_ctz(ends & left)) - 1);
        const int begin = __builtin_ctz(left);
        left &= ~run;
        const auto index = static_cast<std::int32_t>(job.buffers->id[at + begin] - job.draw->id_base);
        if (index != known) {
          triangle = Method::template set_up_triangle<float>(job, index);
          known = index;
        }
        const auto span = Method::set_up_span(job, triangle, y);
        Sink::row(job, at, lanes_of(run), Method::shade(job, triangle, span, x, y, nearness));
      }
    }
  }
  flush_strays<Method, Sink>(job, strays);
}

}  // namespace blysk::BLYSK_ISA
