// shading/phong.h - Phong shading as a method of shade_tile.h, for its own kernel and for methods that leave
// pixels to it.
#pragma once

#include "shading/plane.h"

namespace blysk::BLYSK_ISA {

struct Phong {
  template <class F>
  struct Triangle {
    Corners<F> corners;
    NormalPlane<F> normal;
  };
  template <class F>
  using Span = V3<F>;

  template <class F>
  static BLYSK_INLINE Triangle<F> set_up_triangle(const ShadeJob& job, Integer<F> index) {
    // In place: the parts are large, and would be copied.
    Triangle<F> t{fetch_corners<F>(job, index), fetch_normal_plane(job, t.corners)};
    return t;
  }

  template <class F>
  static BLYSK_INLINE Span<F> set_up_span(const ShadeJob&, const Triangle<F>& t, F y) {
    return row_normal(t.normal, y);
  }

  template <class F, class P, class Y>
  static BLYSK_INLINE Rgb<P> shade(const ShadeJob& job, const Triangle<F>& t, const Span<F>& row, P x, Y y,
                                   P nearness) {
    const V3<P> viewer = viewer_at(job, x, y);
    const V3<P> n = or_viewer(normal_along(t.normal, row, x), viewer);
    const auto where = [&] { return point_at(job, x, y, nearness, viewer); };
    return compose(job, t.corners, x, y, light_point(job.draw->surface, n, viewer, where));
  }
};

}  // namespace blysk::BLYSK_ISA
