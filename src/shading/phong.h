// shading/phong.h - Phong shading as a method of shade_tile.h, for its own kernel and for methods that leave
// pixels to it.
#pragma once

#include "shading/plane.h"

namespace blysk::BLYSK_ISA {

struct Phong {
  template <class F>
  struct Triangle {
    Corners<F> corners;
    F x, y;  // where the plane starts
    NormalPlane<F> normal;
  };
  template <class F>
  using Span = V3<F>;

  template <class F>
  static BLYSK_INLINE Triangle<F> set_up_triangle(const ShadeJob& job, Integer<F> index) {
    Triangle<F> t;
    t.corners = fetch_corners<F>(job, index);
    V3<F> normal[3];
    if (job.draw->normals == nullptr) {
      normal[0] = normal[1] = normal[2] = face_normal(job, t.corners);
    } else {
      for (int k = 0; k < 3; ++k) {
        const V3<F> n = fetch3<F>(job.draw->normals, t.corners.vertex[k]);
        normal[k] = job.draw->moved ? times(job.draw->normal_matrix, 3, n) : n;
      }
    }
    const PlaneFrame<F> frame = plane_frame(t.corners);
    t.x = frame.x;
    t.y = frame.y;
    t.normal = normal_plane(frame, normal);
    return t;
  }

  template <class F>
  static BLYSK_INLINE Span<F> set_up_span(const ShadeJob&, const Triangle<F>& t, F y) {
    return on_row(t.normal, y - t.y);
  }

  // World normal up to its length.
  template <class F, class P>
  static BLYSK_INLINE V3<P> normal_at(const Triangle<F>& t, const Span<F>& row, P x, const V3<P>& viewer) {
    return or_viewer(along_row(t.normal, row, x - P(t.x)), viewer);
  }

  template <class F, class P, class Y>
  static BLYSK_INLINE Rgb<P> shade(const ShadeJob& job, const Triangle<F>& t, const Span<F>& row, P x, Y y,
                                   P nearness) {
    const V3<P> viewer = viewer_at(job, x, y);
    const V3<P> n = normal_at(t, row, x, viewer);
    const auto where = [&] { return point_at(job, x, y, nearness, viewer); };
    const Intensity<P> light = light_point(job.draw->surface, n, viewer, where);
    return compose(job, t.corners, x, y, light);
  }
};

}  // namespace blysk::BLYSK_ISA
