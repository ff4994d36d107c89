// shading/auto_ways.h - the ways that `auto` has to interpolate the light of a triangle, of some rows of a
// tile: set up sixteen triangles at a time, told for each whether it fits, kept as runs of pixels want them.
#pragma once

#include "shading/curved_light.h"
#include "shading/linear_light.h"
#include "shading/quads.h"

namespace blysk::BLYSK_ISA {

inline constexpr int kMostTriangles = 1024;
inline constexpr int kTriangleRoom = kMostTriangles + 2 * kLanes;

/// Triangles that no way has been found for yet: their indices and their numbers here.
struct Undecided {
  std::int32_t triangle[kTriangleRoom], number[kTriangleRoom];
  int count = 0;
};

/// How a triangle is shaded: kPlane, kPhong or the place of its surface.
using Way = std::int32_t;
inline constexpr Way kPlane = -1, kPhong = -2;

BLYSK_INLINE void put_row(float* rows, int at, const Rgb<F32>& c, F32 fourth) {
  store_interleaved(bits_of(c.x), bits_of(c.y), bits_of(c.z), bits_of(fourth),
                    reinterpret_cast<std::int32_t*>(rows + 4 * at));
}

/// Pixels of one triangle side by side: the first one's centre in subpixels, bits of all of them, and where
/// they are.
struct RunPixels {
  float x, y;
  std::uint64_t pixels;
  std::uint32_t* color;
};

/// Hands value(x of four pixels) to the pixels of a run.
template <class Value>
BLYSK_INLINE void store_run(const RunPixels& run, Value value) {
  const F32 lowest(0.0f), highest(255.0f), step(static_cast<float>(kQuad * kSubpixels));
  F32 x = F32(run.x) + quad_columns();
  std::uint64_t left = run.pixels;
  std::uint32_t* to = run.color;
  do {
    store_quad(min(max(value(x), lowest), highest), static_cast<unsigned>(left), to);
    x = x + step;
    to += kQuad;
    left >>= kQuad;
  } while (left != 0);
}

/// Three rows of four numbers a triangle: colour at a corner and the triangle's way; slopes in x and the
/// corner's x; slopes in y and the corner's y.
class Planes {
 public:
  /// Of those numbered 1 to count, whose ids are given. Those that do not fit, but are large enough for a
  /// surface, are left.
  __attribute__((noinline)) void set_up(const ShadeJob& job, const std::int32_t* ids, int count,
                                        Undecided& left) {
    const I32 first(static_cast<std::int32_t>(job.draw->id_base));
    left.count = 0;
    for (int i = 0; i <= count; i += kLanes) {
      const I32 triangle = load(ids + i) - first, number = iota(i);
      const auto light = fetch_linear_light<F32>(job, triangle);
      put_row(row_[0], i, light.at, float_of_bits(select(light.fits, I32(kPlane), I32(kPhong))));
      put_row(row_[1], i, light.per_x, light.x);
      put_row(row_[2], i, light.per_y, light.y);
      const Mask open = light.near & (number >= I32(1)) & (number <= I32(count));
      store_compressed(open, number, left.number + left.count);
      left.count += store_compressed(open, triangle, left.triangle + left.count);
    }
  }

  [[nodiscard]] BLYSK_INLINE Way way(int number) const { return bits_of(row_[0][4 * number + 3]); }
  BLYSK_INLINE void set_way(int number, Way way) { row_[0][4 * number + 3] = float_of_bits(way); }

  BLYSK_INLINE void shade(int number, const RunPixels& run) const {
    const float *at = row_[0] + 4 * number, *per_x = row_[1] + 4 * number, *per_y = row_[2] + 4 * number;
    const F32 start = for_each_pixel(at) + F32(run.y - per_y[3]) * for_each_pixel(per_y);
    const F32 slope = for_each_pixel(per_x), corner(per_x[3]);
    store_run(run, [&](F32 x) { return start + (x - corner) * slope; });
  }

 private:
  alignas(64) float row_[3][4 * kTriangleRoom];
};

/// Six rows a triangle, by place: coefficients of SecondOrder in its order; x, y and slope are the fourths of
/// the first three.
class Surfaces {
 public:
  /// Tells `planes` which of those that are left fit.
  __attribute__((noinline)) void set_up(const ShadeJob& job, Undecided& left, Planes& planes) {
    for (int i = left.count; i < left.count + kLanes; ++i) left.triangle[i] = left.triangle[left.count - 1];
    for (int i = 0; i < left.count; i += kLanes) {
      const auto light = fetch_curved_light<F32>(job, load(left.triangle + i));
      unsigned fits = to_bits(light.fits & lanes_below(left.count - i));
      if (fits == 0) continue;
      const auto put = [&](int row, F32 SecondOrder<F32>::*of, F32 fourth) {
        const auto& c = light.channel;
        put_row(row_[row], i, {c[0].*of, c[1].*of, c[2].*of}, fourth);
      };
      put(0, &SecondOrder<F32>::f, light.x);
      put(1, &SecondOrder<F32>::a, light.y);
      put(2, &SecondOrder<F32>::c, light.slope);
      put(3, &SecondOrder<F32>::b, F32(0.0f));
      put(4, &SecondOrder<F32>::e, F32(0.0f));
      put(5, &SecondOrder<F32>::d, F32(0.0f));
      for (; fits != 0; fits &= fits - 1) {
        const int place = i + __builtin_ctz(fits);
        planes.set_way(left.number[place], place);
      }
    }
  }

  BLYSK_INLINE void shade(int place, const RunPixels& run) const {
    const float* at[6];
    for (int i = 0; i < 6; ++i) at[i] = row_[i] + 4 * place;
    const float down = run.y - at[1][3];
    const F32 s(down), corner(at[0][3]), along(down * at[2][3]);
    const auto c = [&](int i) { return for_each_pixel(at[i]); };
    const F32 p0 = c(0) + s * (c(1) + s * c(2)), p1 = c(3) + s * c(4), bend = c(5);
    store_run(run, [&](F32 x) {
      const F32 right = (x - corner) - along;
      return p0 + right * (p1 + right * bend);
    });
  }

 private:
  alignas(64) float row_[6][4 * kTriangleRoom];
};

}  // namespace blysk::BLYSK_ISA
