// shading/mixed_normals.h - Phong's normal at any point of a triangle, for methods that make it unit at some
// points and find the others from those.
#pragma once

#include "shading/corner_light.h"
#include "shading/row.h"

namespace blysk::BLYSK_ISA {

/// Rows of fewer pixels are not worth what their ends cost: every pixel has its own normal.
inline constexpr int kShortestRow = 16;

template <class F>
struct MixedNormals {
  Corners<F> corners;               ///< sorted, unless all are narrow
  V3<F> normal[3];                  ///< world
  RowFrame<F> frame;                ///< likewise
  decltype(F() < F()) narrow;  ///< no row is long enough, or there are none: only pieces are drawn
};

template <class F>
BLYSK_INLINE MixedNormals<F> fetch_mixed_normals(const ShadeJob& job, Integer<F> index, int shortest) {
  MixedNormals<F> t;
  t.corners = fetch_corners<F>(job, index);
  const F* x = t.corners.x;
  const F width = max(max(x[0], x[1]), x[2]) - min(min(x[0], x[1]), x[2]);
  t.narrow = t.corners.unplaced | (width < F(static_cast<float>(shortest * kSubpixels)));
  if (!all(t.narrow)) {
    sort_corners(t.corners);
    t.frame = row_frame(t.corners);
  }
  if (job.draw->normals == nullptr) {
    t.normal[0] = t.normal[1] = t.normal[2] = face_normal(job, t.corners);
  } else {
    for (int k = 0; k < 3; ++k) t.normal[k] = corner_normal(job, t.corners, k);
  }
  return t;
}

template <class F, class P, class Y>
BLYSK_INLINE V3<P> unit_normal_at(const ShadeJob& job, const MixedNormals<F>& t, P x, Y y) {
  const V3<P> mixed = mix(weights_at(t.corners, x, y), t.normal[0], t.normal[1], t.normal[2]);
  const V3<P> n = or_viewer(mixed, viewer_at(job, x, y));
  const P scale = reciprocal_root(dot(n, n));
  return {n.x * scale, n.y * scale, n.z * scale};
}

/// Centres of the first and the last pixel of a row, subpixels; one pixel where none is covered.
template <class F>
struct RowCenters {
  F first, last;
};

template <class F>
BLYSK_INLINE RowCenters<F> row_centers(const RowFrame<F>& f, F y) {
  const RowEnds<F> ends = row_ends(f, y);
  const auto center = [](Integer<F> column) {
    return to_float(column * Integer<F>(kSubpixels) + Integer<F>(kSubpixels / 2));
  };
  return {center(ends.first), center(max(ends.last, ends.first))};
}

/// Lights points of a triangle by normals of length near 1.
template <class F, class P, class Y>
BLYSK_INLINE Rgb<P> light_unit(const ShadeJob& job, const MixedNormals<F>& t, const V3<P>& n, P x, Y y,
                               P nearness) {
  const V3<P> viewer = viewer_at(job, x, y);
  const auto where = [&] { return point_at(job, x, y, nearness, viewer); };
  Weights<P> w{};
  if (job.draw->colors != nullptr) w = weights_at(t.corners, x, y);
  return compose(job, t.corners, w, light_scaled<true>(job.draw->surface, n, P(1.0f), viewer, where));
}

}  // namespace blysk::BLYSK_ISA
