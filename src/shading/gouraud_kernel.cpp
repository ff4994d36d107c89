// Gouraud shading: the corners are lit, intensities are interpolated.
//
// Based on: H. Gouraud. Continuous shading of curved surfaces. 1971. Thesis, section 3.2 of the
// specification.
#include "shading/corner_light.h"
#include "shading/shade_tile.h"
#include "simd/kernels.h"

namespace blysk::BLYSK_ISA {
namespace {

struct Gouraud {
  template <class F>
  struct Triangle {
    Corners<F> corners;
    Intensity<F> intensity[3];
  };
  struct Span {};

  template <class F>
  static BLYSK_INLINE Triangle<F> set_up_triangle(const ShadeJob& job, Integer<F> index) {
    Triangle<F> t;
    t.corners = fetch_corners<F>(job, index);
    for (int k = 0; k < 3; ++k) t.intensity[k] = light_corner(job, t.corners, k);
    return t;
  }

  template <class F, class Y>
  static BLYSK_INLINE Span set_up_span(const ShadeJob&, const Triangle<F>&, Y) {
    return {};
  }

  template <class F, class P, class Y>
  static BLYSK_INLINE Rgb<P> shade(const ShadeJob& job, const Triangle<F>& t, const Span&, P x, Y y, P) {
    Weights<P> w = weights_at(t.corners, x, y);
    const P scale = inverse_sum(w);
    for (P& weight : w.of) weight = weight * scale;
    const Intensity<P> i = {
        mix(w, t.intensity[0].diffuse, t.intensity[1].diffuse, t.intensity[2].diffuse),
        mix(w, t.intensity[0].specular, t.intensity[1].specular, t.intensity[2].specular)};
    return compose(job, t.corners, w, i);
  }
};

}  // namespace

void shade_gouraud(const ShadeJob& job) { shade_draw<Gouraud, ColorSink>(job); }

}  // namespace blysk::BLYSK_ISA
