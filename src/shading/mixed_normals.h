// shading/mixed_normals.h - Phong's normal at any point of a triangle, for methods that make it unit at some
// points and find the others from those.
#pragma once

#include "shading/plane.h"
#include "shading/row.h"

namespace blysk::BLYSK_ISA {

template <class F>
struct MixedNormals {
  Corners<F> corners;
  NormalPlane<F> normal;
  decltype(F() < F()) narrow;  ///< no row is as long as was asked for, or none is known
  RowFrame<F> frame;           ///< of the others
};

/// `shortest`: pixels of the shortest row that the method asks for.
template <class F>
BLYSK_INLINE MixedNormals<F> fetch_mixed_normals(const ShadeJob& job, Integer<F> index, int shortest) {
  MixedNormals<F> t;
  t.corners = fetch_corners<F>(job, index);
  t.normal = fetch_normal_plane(job, t.corners);
  const F* x = t.corners.x;
  const F width = max(max(x[0], x[1]), x[2]) - min(min(x[0], x[1]), x[2]);
  t.narrow = t.corners.unplaced | (width < F(static_cast<float>((shortest - 1) * kSubpixels)));
  if (!all(t.narrow)) {
    Corners<F> sorted = t.corners;
    sort_corners(sorted);
    t.frame = row_frame(sorted);
  }
  return t;
}

template <class F>
struct NormalRow {
  V3<F> normal;   ///< see on_row()
  F first, last;  ///< centres of the covered pixels' ends, subpixels; 0 of narrow triangles
};

template <class F>
BLYSK_INLINE NormalRow<F> normal_row(const MixedNormals<F>& t, F y) {
  NormalRow<F> row{row_normal(t.normal, y), F(0.0f), F(0.0f)};
  if (all(t.narrow)) return row;
  const RowEnds<F> ends = row_ends(t.frame, y);
  const auto center = [&](Integer<F> column) {
    const F at = to_float(column * Integer<F>(kSubpixels) + Integer<F>(kSubpixels / 2));
    return select(t.narrow, F(0.0f), at);
  };
  row.first = center(ends.first);
  row.last = center(max(ends.last, ends.first));
  return row;
}

template <class F, class P, class Y>
BLYSK_INLINE V3<P> unit_normal_at(const ShadeJob& job, const MixedNormals<F>& t, const NormalRow<F>& row, P x,
                                  Y y) {
  const V3<P> n = or_viewer(normal_along(t.normal, row.normal, x), viewer_at(job, x, y));
  const P scale = reciprocal_root(dot(n, n));
  return {n.x * scale, n.y * scale, n.z * scale};
}

/// Lights points of a triangle by normals of length near 1.
template <class F, class P, class Y>
BLYSK_INLINE Rgb<P> light_unit(const ShadeJob& job, const Corners<F>& c, const V3<P>& n, P x, Y y,
                               P nearness) {
  const V3<P> viewer = viewer_at(job, x, y);
  const auto where = [&] { return point_at(job, x, y, nearness, viewer); };
  return compose(job, c, x, y, light_scaled<true>(job.draw->surface, n, P(1.0f), viewer, where));
}

}  // namespace blysk::BLYSK_ISA
