// shading/phong.h - Phong shading: the normal is interpolated and lit at every pixel. The reference of all
// others.
//
// Based on: B. T. Phong. Illumination for computer generated pictures. 1975. Thesis, section 3.3 of the
// specification.
#pragma once

#include "shading/shade_tile.h"

namespace blysk::BLYSK_ISA {

struct Phong {
  template <class F>
  struct Triangle {
    Corners<F> corners;
    V3<F> normal[3];
  };
  struct Span {};

  template <class F>
  static BLYSK_INLINE Triangle<F> set_up_triangle(const ShadeJob& job, Integer<F> index) {
    Triangle<F> t;
    t.corners = fetch_corners<F>(job, index);
    if (job.draw->normals == nullptr) {
      t.normal[0] = t.normal[1] = t.normal[2] = face_normal(job, t.corners);
    } else {
      for (int k = 0; k < 3; ++k) t.normal[k] = fetch3<F>(job.draw->normals, t.corners.vertex[k]);
    }
    return t;
  }

  template <class F, class Y>
  static BLYSK_INLINE Span set_up_span(const ShadeJob&, const Triangle<F>&, Y) {
    return {};
  }

  // World normal up to its length.
  template <class F, class P>
  static BLYSK_INLINE V3<P> normal_at(const ShadeJob& job, const Triangle<F>& t, const Weights<P>& w,
                                      const V3<P>& viewer) {
    V3<P> n = mix(w, t.normal[0], t.normal[1], t.normal[2]);
    if (job.draw->moved && job.draw->normals != nullptr) n = times(job.draw->normal_matrix, 3, n);
    return or_viewer(n, viewer);
  }

  template <class F, class P, class Y>
  static BLYSK_INLINE Rgb<P> shade(const ShadeJob& job, const Triangle<F>& t, const Span&, P x, Y y,
                                   P nearness) {
    const Weights<P> w = weights_at(t.corners, x, y);
    const V3<P> viewer = viewer_at(job, x, y);
    const V3<P> n = normal_at(job, t, w, viewer);
    const auto where = [&] { return point_at(job, x, y, nearness, viewer); };
    return compose(job, t.corners, w, light_point(job.draw->surface, n, viewer, where));
  }
};

}  // namespace blysk::BLYSK_ISA
