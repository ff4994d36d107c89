// Gouraud shading with one increment for the whole triangle: corners are lit and coloured, colours are
// carried down the long edge and along each row.
//
// Based on: the Gouraud paper, part B of its specification: the increment along a row is the same for all
// rows. Differs in: a pixel is a product away from the row's start instead of a sum, so that sixteen are
// independent.
#include "shading/corner_light.h"
#include "shading/row.h"
#include "shading/shade_tile.h"
#include "simd/kernels.h"

namespace blysk::BLYSK_ISA {
namespace {

template <class F>
BLYSK_INLINE Rgb<F> plus_scaled(const Rgb<F>& a, const Rgb<F>& b, F by) {
  return {a.x + b.x * by, a.y + b.y * by, a.z + b.z * by};
}

template <class F>
BLYSK_INLINE Rgb<F> difference(const Rgb<F>& a, const Rgb<F>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

struct GouraudConstant {
  template <class F>
  struct Triangle {
    Corners<F> corners;
    RowFrame<F> frame;
    Rgb<F> color[3];
    Rgb<F> down;       // from the top corner to the bottom one
    Rgb<F> increment;  // a subpixel to the right: (I_B - I_K) / (X_B - X_K), K on the long edge at B's height
  };
  template <class F>
  struct Span {
    RowStart<F> row;
    Rgb<F> color;  // where the row begins
  };

  template <class F>
  static BLYSK_INLINE Triangle<F> set_up_triangle(const ShadeJob& job, Integer<F> index) {
    Triangle<F> t;
    t.corners = fetch_corners<F>(job, index);
    sort_corners(t.corners);
    t.frame = row_frame(t.corners);
    for (int k = 0; k < 3; ++k) {
      const Intensity<F> lit = light_corner(job, t.corners, k);
      Weights<F> own{};
      for (int j = 0; j < 3; ++j) own.of[j] = F(j == k ? 1.0f : 0.0f);
      t.color[k] = compose(job, t.corners, own, lit);
    }
    t.down = difference(t.color[1], t.color[0]);
    const Rgb<F> across = plus_scaled(difference(t.color[2], t.color[0]), t.down, F(0.0f) - t.frame.bend);
    t.increment = {across.x * t.frame.over, across.y * t.frame.over, across.z * t.frame.over};
    return t;
  }

  template <class F>
  static BLYSK_INLINE Span<F> set_up_span(const ShadeJob&, const Triangle<F>& t, F y) {
    const RowStart<F> row = row_start(t.frame, y);
    return {row, plus_scaled(t.color[0], t.down, row.s)};
  }

  template <class F, class P, class Y>
  static BLYSK_INLINE Rgb<P> shade(const ShadeJob&, const Triangle<F>& t, const Span<F>& span, P x, Y y, P) {
    const P steps = right_of(t.frame, span.row, x);
    const auto channel = [&](F start, F increment) {
      // Rounding may carry a pixel of a sliver beyond its corners.
      return max(P(start) + P(increment) * steps, P(0.0f));
    };
    const Rgb<P> color = {channel(span.color.x, t.increment.x), channel(span.color.y, t.increment.y),
                          channel(span.color.z, t.increment.z)};
    if (__builtin_expect(!any(t.corners.unplaced), 1)) return color;
    const Weights<P> w = weights_at(t.corners, x, y);
    const P scale = inverse_sum(w);
    const Rgb<P> mixed = mix(w, t.color[0], t.color[1], t.color[2]);
    return choose(t.corners.unplaced, {mixed.x * scale, mixed.y * scale, mixed.z * scale}, color);
  }
};

}  // namespace

void shade_gouraud_constant(const ShadeJob& job) { shade_draw<GouraudConstant, ColorSink>(job); }

}  // namespace blysk::BLYSK_ISA
