// shading/shade_tile.h - walks the pixels of a draw in a tile and hands them to a shading method.
//
// Runs of one triangle in a row are shaded as spans: the triangle's values are plain floats, sixteen pixels
// at a time. Where triangles change too often for that, pixels are gathered until sixteen of them, each with
// its own triangle, fill the lanes. Fragments of pixels that show several surfaces go the same way, each at
// the centroid of its samples. A method is written once for all; a pixel's value does not depend on which way
// it went.
//
// A method is a struct of static templates. F is float (one triangle) or F32 (sixteen), P the pixels' lanes,
// Y float or F32:
//
//   template <class F> struct Triangle;   what is known of a triangle
//   set_up_triangle<F>(job, index)        index counts in the mesh
//   set_up_span(job, triangle, y)         what is known of its row; x and y are pixel centres in subpixels
//   shade(job, triangle, span, x, y, nearness) -> Rgb<P>
#pragma once

#include "raster/tile.h"
#include "shading/corners.h"
#include "shading/encode.h"
#include "shading/shade.h"
#include "simd/lanes.h"

namespace blysk::BLYSK_ISA {

template <int kRegisters>
BLYSK_INLINE Ints<kRegisters> fragment_samples(Ints<kRegisters> place) {
  return shift_right<kFragmentSamplesShift>(place) & Ints<kRegisters>(31);
}

/// From the pixel's centre to the centroid of a fragment's samples, whole subpixels.
template <int kShift, int kRegisters>
BLYSK_INLINE Floats<kRegisters> to_centroid(Ints<kRegisters> place) {
  using F = Floats<kRegisters>;
  const F places = to_float(shift_right<kShift>(place) & Ints<kRegisters>(127));
  return to_float(nearest(places * F(32.0f) / to_float(fragment_samples(place)) - F(kSampleReach)));
}

/// to[k] += row[k], k = 0..3
BLYSK_INLINE void add_row(const float* row, float* to) {
#if HWY_TARGET == HWY_SCALAR
  for (int k = 0; k < 4; ++k) to[k] += row[k];
#else
  const hn::Full128<float> d;
  hn::StoreU(hn::Add(hn::LoadU(d, to), hn::LoadU(d, row)), d, to);
#endif
}

/// Takes colours to the tile's pixels.
struct ColorSink {
  static constexpr bool kWide = true;
  template <int kRegisters>
  static BLYSK_INLINE Ints<kRegisters> pack(const ShadeJob& job, const Rgb<Floats<kRegisters>>& c) {
    return pack_rgb(job.transfer, c) | Ints<kRegisters>(static_cast<std::int32_t>(0xff000000));
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
  /// Adds fragments to the sums of their pixels. A sample shows no more than white, as a pixel does.
  static BLYSK_INLINE void blend(const ShadeJob& job, const std::int32_t* place, int count,
                                 const Rgb<F32Wide>& c, F32Wide weight) {
    const F32Wide one(1.0f);
    float row[4 * kWideLanes];
    store_rows(min(c.x, one) * weight, min(c.y, one) * weight, min(c.z, one) * weight, weight, row);
    for (int i = 0; i < count; ++i) {
      add_row(row + 4 * i, job.samples->sum + 4 * (place[i] & (kTilePixels - 1)));
    }
  }
};

/// Pixels or fragments that wait until they fill the lanes. `at` is a pixel or a fragment's word.
struct Strays {
  std::int32_t triangle[kWideLanes + kLanes], at[kWideLanes + kLanes], nearness[kWideLanes + kLanes],
      weight[kWideLanes + kLanes];
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
    if (job_.samples != nullptr) shade_fragments();
  }

  /// The draw's pixels among sixteen.
  [[nodiscard]] BLYSK_INLINE unsigned own_pixels(int row, int column) const {
    const I32 id = load(job_.buffers->id + row * kTileSize + column);
    // kNoTriangle is -1 here and drops out of the range.
    return to_bits((id >= first_id_) & (id <= last_id_) & lanes_below(job_.width - column));
  }

  /// What job.samples holds of the draw.
  BLYSK_INLINE void shade_fragments() {
    of_fragments_ = true;
    const SampleBuffers& s = *job_.samples;
    for (int i = 0; i < s.fragments; i += kLanes) {
      const I32 id = load(s.fragment_id + i);
      const Mask mine = (id >= first_id_) & (id <= last_id_) & lanes_below(s.fragments - i);
      if (s.weighted)
        store_compressed(mine, bits_of(load(s.fragment_weight + i)), strays_.weight + strays_.count);
      gather_strays(mine, id, load(s.fragment_place + i), load(s.fragment_nearness + i));
    }
    flush();
    of_fragments_ = false;
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
      gather_strays(lanes_of(mine), id, iota(at), load(job_.buffers->nearness + at));
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
      strays_.nearness[i] = strays_.nearness[strays_.count - 1];
    }
    shade_strays(strays_.count);
    strays_.count = 0;
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

  BLYSK_INLINE void gather_strays(Mask mine, I32 id, I32 at, F32 nearness) {
    store_compressed(mine, id - first_id_, strays_.triangle + strays_.count);
    store_compressed(mine, bits_of(nearness), strays_.nearness + strays_.count);
    strays_.count += store_compressed(mine, at, strays_.at + strays_.count);
    if (strays_.count < kWideLanes) return;
    shade_strays(kWideLanes);
    strays_.count -= kWideLanes;
    store(load(strays_.triangle + kWideLanes), strays_.triangle);
    store(load(strays_.at + kWideLanes), strays_.at);
    store(load(strays_.nearness + kWideLanes), strays_.nearness);
    store(load(strays_.weight + kWideLanes), strays_.weight);
  }

  // One copy of the gathered code: it is large.
  __attribute__((noinline)) void shade_strays(int count) {
    const auto at = load_wide(strays_.at);
    using I = decltype(at + at);
    F32Wide x = centers((at & I(kTileSize - 1)) + I(job_.x));
    F32Wide y = centers((shift_right<kTileBits>(at) & I(kTileSize - 1)) + I(job_.y));
    if (of_fragments_) {
      x = x + to_centroid<kFragmentColumnsShift>(at);
      y = y + to_centroid<kFragmentRowsShift>(at);
    }
    const auto triangle = Method::template set_up_triangle<F32Wide>(job_, load_wide(strays_.triangle));
    const auto span = Method::set_up_span(job_, triangle, y);
    const F32Wide nearness = float_of_bits(load_wide(strays_.nearness));
    const auto color = Method::shade(job_, triangle, span, x, y, nearness);
    if (of_fragments_) {
      const F32Wide weight =
          job_.samples->weighted ? float_of_bits(load_wide(strays_.weight)) : to_float(fragment_samples(at));
      Sink::blend(job_, strays_.at, count, color, weight);
    } else {
      Sink::scatter(job_, strays_.at, count, color);
    }
  }

  const ShadeJob& job_;
  const I32 first_id_, last_id_;
  // Triangles come back row after row: the last ones stay set up, one of each remainder.
  Triangle triangles_[kKept];
  std::int32_t known_[kKept];
  Strays strays_;
  bool of_fragments_ = false;  // they are taken from job_.samples
};

template <class Method, class Sink>
BLYSK_INLINE void shade_draw(const ShadeJob& job) {
  DrawShader<Method, Sink>(job).shade();
}

}  // namespace blysk::BLYSK_ISA
