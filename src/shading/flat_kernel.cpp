// Flat shading: one normal a triangle, lit once, at its centroid.
//
// Based on: W. J. Bouknight. A procedure for generation of three-dimensional half-toned computer graphics
// presentations. 1970. Thesis, section 3.1 of the specification.
#include "shading/corner_light.h"
#include "shading/shade_tile.h"
#include "simd/kernels.h"

namespace blysk::BLYSK_ISA {
namespace {

struct Flat {
  template <class F>
  struct Triangle {
    Corners<F> corners;
    Intensity<F> intensity;
  };
  struct Span {};

  template <class F>
  static BLYSK_INLINE Triangle<F> set_up_triangle(const ShadeJob& job, Integer<F> index) {
    Triangle<F> t;
    t.corners = fetch_corners<F>(job, index);
    V3<F> p[3];
    for (int k = 0; k < 3; ++k) p[k] = world_position<F>(job, t.corners.vertex[k]);
    const F third(1.0f / 3.0f);
    const V3<F> centroid = {(p[0].x + p[1].x + p[2].x) * third, (p[0].y + p[1].y + p[2].y) * third,
                            (p[0].z + p[1].z + p[2].z) * third};
    t.intensity = light_world_point(job, face_normal(job, t.corners), centroid);
    return t;
  }

  template <class F, class Y>
  static BLYSK_INLINE Span set_up_span(const ShadeJob&, const Triangle<F>&, Y) {
    return {};
  }

  template <class F, class P, class Y>
  static BLYSK_INLINE Rgb<P> shade(const ShadeJob& job, const Triangle<F>& t, const Span&, P x, Y y, P) {
    Weights<P> w{};
    if (job.draw->colors != nullptr) w = weights_at(t.corners, x, y);
    const auto lanes = [](const Rgb<F>& c) { return Rgb<P>{P(c.x), P(c.y), P(c.z)}; };
    return compose(job, t.corners, w, Intensity<P>{lanes(t.intensity.diffuse), lanes(t.intensity.specular)});
  }
};

}  // namespace

void shade_flat(const ShadeJob& job) { shade_draw<Flat, ColorSink>(job); }

}  // namespace blysk::BLYSK_ISA
