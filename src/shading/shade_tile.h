// shading/shade_tile.h - walks the pixels of a draw in a tile and hands them to a shading method.
//
// Runs of one triangle in a row are shaded as spans: the triangle's values are plain floats, sixteen pixels
// at a time. Where triangles change too often for that, pixels are gathered until sixteen of them, each with
// its own triangle, fill the lanes. A method is written once for both; a pixel's value does not depend on
// which way it went.
//
// A method is a struct of static templates. F is float (one triangle) or F32 (sixteen), P the pixels' lanes,
// Y float or F32:
//
//   template <class F> struct Triangle;   what is known of a triangle
//   set_up_triangle<F>(job, index)        index counts in the mesh
//   set_up_span(job, triangle, y)         what is known of its row; x and y are pixel centres in subpixels
//   shade(job, triangle, span, x, y, nearness) -> Rgb<P>
#pragma once

#include "image/transfer.h"
#include "raster/tile.h"
#include "shading/corners.h"
#include "shading/shade.h"
#include "simd/lanes.h"

namespace blysk::BLYSK_ISA {

/// 0..1 to 0..255 in the low byte by the transfer function (image/transfer.h is the model); the highest byte
/// is not clean. Colours are not negative: neither lights nor materials are.
template <int kRegisters>
BLYSK_INLINE Ints<kRegisters> encode(Transfer transfer, Floats<kRegisters> v) {
  using F = Floats<kRegisters>;
  using I = Ints<kRegisters>;
  // Adding 2^23 leaves the nearest integer in the low bits (and 0x4b above them, which pack() lets fall out).
  if (transfer == Transfer::none) return bits_of(min(v, F(1.0f)) * F(255.0f) + F(8388608.0f));
  const I bits = bits_of(min(max(v, F(kSrgbLowest)), F(kSrgbHighest)));
  const I segment =
      gather(kSrgbSegments, shift_right<20>(bits - I(static_cast<std::int32_t>(kSrgbLowestBits))));
  const I base = shift_left<9>(shift_right<16>(segment) & I(0xffff));
  return shift_right<16>(base + (segment & I(0xffff)) * (shift_right<12>(bits) & I(0xff)));
}

/// Takes colours to the tile's pixels.
struct ColorSink {
  static constexpr bool kWide = true;
  template <int kRegisters>
  static BLYSK_INLINE Ints<kRegisters> pack(const ShadeJob& job, const Rgb<Floats<kRegisters>>& c) {
    using I = Ints<kRegisters>;
    const I rg = encode(job.transfer, c.x) | shift_left<8>(encode(job.transfer, c.y));
    return rg | shift_left<16>(encode(job.transfer, c.z)) | I(static_cast<std::int32_t>(0xff000000));
  }
  static BLYSK_INLINE void row(const ShadeJob& job, int at, Mask m, const Rgb<F32>& c) {
    store_masked(m, pack(job, c), job.buffers->color + at);
  }
  static BLYSK_INLINE void whole(const ShadeJob& job, int at, const Rgb<F32Wide>& c) {
    store_all(pack(job, c), job.buffers->color + at);
  }
  static BLYSK_INLINE void scatter(const ShadeJob& job, const std::int32_t* at, int count,
                                   const Rgb<F32Wide>& c) {
    std::uint32_t pixel[kWideLanes];
    store_all(pack(job, c), pixel);
    for (int i = 0; i < count; ++i) job.buffers->color[at[i]] = pixel[i];
  }
};

/// Pixels that wait until they fill the lanes.
struct Strays {
  std::int32_t triangle[kWideLanes + kLanes], at[kWideLanes + kLanes];
  int count = 0;
};

/// Below this many pixels a run they are gathered: a span's set-up costs as much as a few gathered pixels.
/// Methods with a costly set-up, which gathered pixels repeat, have a kSpanPixels of their own.
template <class Method>
constexpr int span_pixels() {
  if constexpr (requires { Method::kSpanPixels; }) {
    return Method::kSpanPixels;
  } else {
    return 12;
  }
}

/// Pixel centres in subpixels.
template <int kRegisters>
BLYSK_INLINE Floats<kRegisters> centers(Ints<kRegisters> pixel) {
  using I = Ints<kRegisters>;
  return to_float(shift_left<kSubpixelBits>(pixel) + I(kSubpixels / 2));
}

template <class Method, class Sink>
class DrawShader {
 public:
  explicit BLYSK_INLINE DrawShader(const ShadeJob& job)
      : job_(job),
        first_id_(static_cast<std::int32_t>(job.draw->id_base)),
        last_id_(static_cast<std::int32_t>(job.draw->id_base + job.draw->id_count - 1)) {
    for (std::int32_t& index : known_) index = -1;
  }

  BLYSK_INLINE void shade() {
    for (int row = 0; row < job_.height; ++row) {
      for (int column = 0; column < job_.width;) column += shade_block(row, column, own_pixels(row, column));
    }
    flush();
  }

  /// The draw's pixels among sixteen.
  [[nodiscard]] BLYSK_INLINE unsigned own_pixels(int row, int column) const {
    const I32 id = load(job_.buffers->id + row * kTileSize + column);
    // kNoTriangle is -1 here and drops out of the range.
    return to_bits((id >= first_id_) & (id <= last_id_) & lanes_below(job_.width - column));
  }

  /// Shades pixels of the draw in the sixteen from `column` on; of a triangle all that are there or none.
  /// Returns how many columns are done. flush() shades what is left over.
  BLYSK_INLINE int shade_block(int row, int column, unsigned mine) {
    if (mine == 0) return kLanes;
    const int at = row * kTileSize + column;
    const I32 id = load(job_.buffers->id + at);
    const float y = static_cast<float>((job_.y + row) * kSubpixels + kSubpixels / 2);
    // The last pixels of runs, in this block of sixteen.
    const unsigned ends = mine & (to_bits(id != load(job_.buffers->id + at + 1)) | 1u << (kLanes - 1));
    if (__builtin_popcount(ends) * span_pixels<Method>() > __builtin_popcount(mine)) {
      gather_strays(lanes_of(mine), id, at);
      return kLanes;
    }
    if constexpr (kWideLanes > kLanes && Sink::kWide) {
      if (ends == 1u << (kLanes - 1) && mine == (1u << kLanes) - 1 && goes_on(at, column)) {
        shade_wide(at, column, y);
        return kWideLanes;
      }
    }
    shade_runs(at, column, y, mine, ends);
    return kLanes;
  }

  BLYSK_INLINE void flush() {
    if (strays_.count == 0) return;
    // Lanes past the last pixel repeat it: their work is thrown away, but it must be sound.
    for (int i = strays_.count; i < kWideLanes; ++i) {
      strays_.triangle[i] = strays_.triangle[strays_.count - 1];
      strays_.at[i] = strays_.at[strays_.count - 1];
    }
    shade_strays(strays_.count);
  }

 private:
  using Triangle = typename Method::template Triangle<float>;
  static constexpr int kKept = 16;

  // Whether the block after a block of one triangle is all of the same.
  BLYSK_INLINE bool goes_on(int at, int column) const {
    const I32 same(static_cast<std::int32_t>(job_.buffers->id[at]));
    return column + kWideLanes <= job_.width &&
           to_bits(load(job_.buffers->id + at + kLanes) == same) == (1u << kLanes) - 1;
  }

  BLYSK_INLINE const Triangle& set_up(int at) {
    const auto index = static_cast<std::int32_t>(job_.buffers->id[at] - job_.draw->id_base);
    const int place = index & (kKept - 1);
    if (index != known_[place]) {
      triangles_[place] = Method::template set_up_triangle<float>(job_, index);
      known_[place] = index;
    }
    return triangles_[place];
  }

  BLYSK_INLINE void shade_wide(int at, int column, float y) {
    const Triangle& triangle = set_up(at);
    const F32Wide x = centers(iota<kWideParts>(job_.x + column));
    const F32Wide nearness = load_wide(job_.buffers->nearness + at);
    Sink::whole(job_, at,
                Method::shade(job_, triangle, Method::set_up_span(job_, triangle, y), x, y, nearness));
  }

  BLYSK_INLINE void shade_runs(int at, int column, float y, unsigned mine, unsigned ends) {
    const F32 x = centers(iota(job_.x + column));
    const F32 nearness = load(job_.buffers->nearness + at);
    for (unsigned left = mine; left != 0;) {
      const unsigned run = left & ((2u << __builtin_ctz(ends & left)) - 1);
      const Triangle& triangle = set_up(at + __builtin_ctz(left));
      left &= ~run;
      const auto& span = Method::set_up_span(job_, triangle, y);
      Sink::row(job_, at, lanes_of(run), Method::shade(job_, triangle, span, x, y, nearness));
    }
  }

  BLYSK_INLINE void gather_strays(Mask mine, I32 id, int at) {
    store_compressed(mine, id - first_id_, strays_.triangle + strays_.count);
    strays_.count += store_compressed(mine, iota(at), strays_.at + strays_.count);
    if (strays_.count < kWideLanes) return;
    shade_strays(kWideLanes);
    strays_.count -= kWideLanes;
    store(load(strays_.triangle + kWideLanes), strays_.triangle);
    store(load(strays_.at + kWideLanes), strays_.at);
  }

  // One copy of the gathered code: it is large.
  __attribute__((noinline)) void shade_strays(int count) {
    const auto at = load_wide(strays_.at);
    using I = decltype(at + at);
    const F32Wide x = centers((at & I(kTileSize - 1)) + I(job_.x));
    const F32Wide y = centers(shift_right<kTileBits>(at) + I(job_.y));
    const auto triangle = Method::template set_up_triangle<F32Wide>(job_, load_wide(strays_.triangle));
    const auto span = Method::set_up_span(job_, triangle, y);
    const F32Wide nearness = gather(job_.buffers->nearness, at);
    Sink::scatter(job_, strays_.at, count, Method::shade(job_, triangle, span, x, y, nearness));
  }

  const ShadeJob& job_;
  const I32 first_id_, last_id_;
  // Triangles come back row after row: the last ones stay set up, one of each remainder.
  Triangle triangles_[kKept];
  std::int32_t known_[kKept];
  Strays strays_;
};

template <class Method, class Sink>
BLYSK_INLINE void shade_draw(const ShadeJob& job) {
  DrawShader<Method, Sink>(job).shade();
}

}  // namespace blysk::BLYSK_ISA
