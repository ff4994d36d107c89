// shading/plane.h - attributes as planes over the picture.
//
// Corner values times their weights, summed, are linear in x and y, perspective included: what weights are
// divided by is another such sum, and a direction needs no division. A row then costs two operations a value
// instead of eleven.
#pragma once

#include "shading/corner_light.h"
#include "shading/determinant.h"

namespace blysk::BLYSK_ISA {

/// start + (x - frame.x) * along_x + (y - frame.y) * along_y
template <class F>
struct Plane {
  F start, along_x, along_y;
};

template <class F>
struct PlaneFrame {
  F x, y;                  ///< corner 0, subpixels; of unplaced corners the picture's own corner
  F x1, y1, x2, y2, area;  ///< corners 1 and 2 from corner 0
  const Corners<F>* corners;
};

template <class F>
BLYSK_INLINE PlaneFrame<F> plane_frame(const Corners<F>& c) {
  F x[3], y[3];
  for (int k = 0; k < 3; ++k) {
    x[k] = c.clipped ? select(c.unplaced, F(0.0f), c.x[k]) : c.x[k];
    y[k] = c.clipped ? select(c.unplaced, F(0.0f), c.y[k]) : c.y[k];
  }
  const F x1 = x[1] - x[0], y1 = y[1] - y[0], x2 = x[2] - x[0], y2 = y[2] - y[0];
  return {x[0], y[0], x1, y1, x2, y2, determinant(x1, y2, x2, y1), &c};
}

/// In homogeneous coordinates.
template <class F>
__attribute__((noinline)) Plane<F> unplaced_plane(const Corners<F>& c, const F value[3]) {
  Plane<F> p{F(0.0f), F(0.0f), F(0.0f)};
  for (int k = 0; k < 3; ++k) {
    const int a = (k + 1) % 3, b = (k + 2) % 3;
    p.start = p.start + (c.x[a] * c.y[b] - c.x[b] * c.y[a]) * value[k];
    p.along_x = p.along_x + (c.y[a] * c.w[b] - c.y[b] * c.w[a]) * value[k];
    p.along_y = p.along_y + (c.w[a] * c.x[b] - c.w[b] * c.x[a]) * value[k];
  }
  return p;
}

/// Of the corners' values times their q.
template <class F>
BLYSK_INLINE Plane<F> plane_of(const PlaneFrame<F>& f, const F value[3]) {
  const F d1 = value[1] - value[0], d2 = value[2] - value[0];
  Plane<F> p{f.area * value[0], f.y2 * d1 - f.y1 * d2, f.x1 * d2 - f.x2 * d1};
  if (__builtin_expect(f.corners->clipped, 0)) {
    const Plane<F> u = unplaced_plane(*f.corners, value);
    p.start = select(f.corners->unplaced, u.start, p.start);
    p.along_x = select(f.corners->unplaced, u.along_x, p.along_x);
    p.along_y = select(f.corners->unplaced, u.along_y, p.along_y);
  }
  return p;
}

template <class F>
BLYSK_INLINE F on_row(const Plane<F>& p, F down) {
  return p.start + down * p.along_y;
}
template <class F, class P>
BLYSK_INLINE P along_row(const Plane<F>& p, F row, P over) {
  return P(row) + over * P(p.along_x);
}

/// A triangle's interpolated normal, up to one common factor of either sign.
template <class F>
struct NormalPlane {
  F x, y;  ///< of the frame
  Plane<F> n[3];
};

/// Of world normals.
template <class F>
BLYSK_INLINE NormalPlane<F> normal_plane(const PlaneFrame<F>& f, const V3<F> normal[3]) {
  const auto component = [&](F V3<F>::*of) {
    F value[3];
    for (int k = 0; k < 3; ++k) value[k] = normal[k].*of * f.corners->q[k];
    return plane_of(f, value);
  };
  return {f.x, f.y, {component(&V3<F>::x), component(&V3<F>::y), component(&V3<F>::z)}};
}

/// What Phong shading starts from.
template <class F>
BLYSK_INLINE NormalPlane<F> fetch_normal_plane(const ShadeJob& job, const Corners<F>& c) {
  V3<F> normal[3];
  if (job.draw->normals == nullptr) {
    normal[0] = normal[1] = normal[2] = face_normal(job, c);
  } else {
    for (int k = 0; k < 3; ++k) normal[k] = corner_normal(job, c, k);
  }
  return normal_plane(plane_frame(c), normal);
}

/// Where x is that of the plane.
template <class F>
BLYSK_INLINE V3<F> row_normal(const NormalPlane<F>& p, F y) {
  const F down = y - p.y;
  return {on_row(p.n[0], down), on_row(p.n[1], down), on_row(p.n[2], down)};
}

template <class F, class P>
BLYSK_INLINE V3<P> normal_along(const NormalPlane<F>& p, const V3<F>& row, P x) {
  const P over = x - P(p.x);
  return {along_row(p.n[0], row.x, over), along_row(p.n[1], row.y, over), along_row(p.n[2], row.z, over)};
}

}  // namespace blysk::BLYSK_ISA
