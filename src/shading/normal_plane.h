// shading/normal_plane.h - a triangle's interpolated normal as a plane over the picture.
//
// Corner normals times their weights, summed, are linear in x and y, perspective included: the common divisor
// does not matter, as only the direction counts. A row then costs two operations a component instead of
// eleven.
#pragma once

#include "shading/corners.h"
#include "shading/determinant.h"

namespace blysk::BLYSK_ISA {

template <class F>
struct NormalPlane {
  V3<F> start, along_x, along_y;  ///< world, up to one common factor of either sign
  F x, y;                         ///< where `start` is, subpixels
};

/// a * p - b * q
template <class F>
BLYSK_INLINE V3<F> cross_mix(F a, const V3<F>& p, F b, const V3<F>& q) {
  return {a * p.x - b * q.x, a * p.y - b * q.y, a * p.z - b * q.z};
}

/// From corner 0, where all corners have places.
template <class F>
BLYSK_INLINE NormalPlane<F> placed_plane(const Corners<F>& c, const V3<F> n[3]) {
  const F x1 = c.x[1] - c.x[0], y1 = c.y[1] - c.y[0], x2 = c.x[2] - c.x[0], y2 = c.y[2] - c.y[0];
  const F area = determinant(x1, y2, x2, y1);
  const V3<F> d1 = {n[1].x - n[0].x, n[1].y - n[0].y, n[1].z - n[0].z};
  const V3<F> d2 = {n[2].x - n[0].x, n[2].y - n[0].y, n[2].z - n[0].z};
  return {{area * n[0].x, area * n[0].y, area * n[0].z},
          cross_mix(y2, d1, y1, d2),
          cross_mix(x1, d2, x2, d1),
          c.x[0],
          c.y[0]};
}

/// From the picture's corner, in homogeneous coordinates.
template <class F>
__attribute__((noinline)) NormalPlane<F> unplaced_plane(const Corners<F>& c, const V3<F> n[3]) {
  NormalPlane<F> p{{F(0.0f), F(0.0f), F(0.0f)},
                   {F(0.0f), F(0.0f), F(0.0f)},
                   {F(0.0f), F(0.0f), F(0.0f)},
                   F(0.0f),
                   F(0.0f)};
  const auto add = [](V3<F>& to, F by, const V3<F>& v) {
    to = {to.x + by * v.x, to.y + by * v.y, to.z + by * v.z};
  };
  for (int k = 0; k < 3; ++k) {
    const int a = (k + 1) % 3, b = (k + 2) % 3;
    add(p.start, c.x[a] * c.y[b] - c.x[b] * c.y[a], n[k]);
    add(p.along_x, c.y[a] * c.w[b] - c.y[b] * c.w[a], n[k]);
    add(p.along_y, c.w[a] * c.x[b] - c.w[b] * c.x[a], n[k]);
  }
  return p;
}

template <class F>
BLYSK_INLINE NormalPlane<F> normal_plane(const ShadeJob& job, const Corners<F>& c, const V3<F> normal[3]) {
  V3<F> n[3];
  for (int k = 0; k < 3; ++k) n[k] = {normal[k].x * c.q[k], normal[k].y * c.q[k], normal[k].z * c.q[k]};
  if (job.draw->moved && job.draw->normals != nullptr) {
    for (V3<F>& v : n) v = times(job.draw->normal_matrix, 3, v);
  }
  if (__builtin_expect(!c.clipped, 1)) return placed_plane(c, n);
  Corners<F> placed = c;  // whole numbers in every lane
  for (int k = 0; k < 3; ++k) {
    placed.x[k] = select(c.unplaced, F(0.0f), c.x[k]);
    placed.y[k] = select(c.unplaced, F(0.0f), c.y[k]);
  }
  NormalPlane<F> p = placed_plane(placed, n);
  const NormalPlane<F> u = unplaced_plane(c, n);
  const auto pick = [&](V3<F>& to, const V3<F>& v) {
    to = {select(c.unplaced, v.x, to.x), select(c.unplaced, v.y, to.y), select(c.unplaced, v.z, to.z)};
  };
  pick(p.start, u.start);
  pick(p.along_x, u.along_x);
  pick(p.along_y, u.along_y);
  p.x = select(c.unplaced, u.x, p.x);
  p.y = select(c.unplaced, u.y, p.y);
  return p;
}

/// The plane at x = p.x of a row.
template <class F>
BLYSK_INLINE V3<F> row_normal(const NormalPlane<F>& p, F y) {
  const F down = y - p.y;
  return {p.start.x + down * p.along_y.x, p.start.y + down * p.along_y.y, p.start.z + down * p.along_y.z};
}

template <class F, class P>
BLYSK_INLINE V3<P> normal_along(const NormalPlane<F>& p, const V3<F>& row, P x) {
  const P over = x - P(p.x);
  return {P(row.x) + over * P(p.along_x.x), P(row.y) + over * P(p.along_x.y),
          P(row.z) + over * P(p.along_x.z)};
}

}  // namespace blysk::BLYSK_ISA
