// shading/row_path.h - what methods by rows take from the ends and the middle of a row.
#pragma once

#include "shading/unit_normals.h"

namespace blysk::BLYSK_ISA {

template <class F>
BLYSK_INLINE V3<F> plus(const V3<F>& a, const V3<F>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class F>
BLYSK_INLINE V3<F> minus(const V3<F>& a, const V3<F>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class F>
BLYSK_INLINE V3<F> scaled(const V3<F>& a, F by) {
  return {a.x * by, a.y * by, a.z * by};
}

/// Where in its row a pixel is: t = 0 at the first pixel's centre, 1 at the last one's; z = t (1 - t) is the
/// same at both halves of the row.
template <class P>
struct RowPoint {
  P t, z;
};

/// A scalar along a row: exact at both ends and in the middle.
template <class F>
struct Parabola {
  F start, gain, bend;  // start + gain t + bend z
};
template <class F>
BLYSK_INLINE Parabola<F> parabola(F first, F middle, F last) {
  return {first, last - first, F(4.0f) * middle - F(2.0f) * (first + last)};
}
template <class F, class P>
BLYSK_INLINE P value(const Parabola<F>& q, const RowPoint<P>& at) {
  return (P(q.start) + P(q.gain) * at.t) + P(q.bend) * at.z;
}

/// A unit vector along a row, towards a lamp, the viewer or half-way: constant if what it points to is far,
/// else exact at both ends and in the middle. Of a vector that is linear before it is made unit and turns by
/// d, the parabola in between is 0.016 d^3 off.
template <class F>
struct Path {
  V3<F> first, middle, last;
  bool far;
};

/// first + gain t + bend z.
template <class F>
BLYSK_INLINE V3<F> bend_of(const Path<F>& p) {
  const V3<F> ends = plus(p.first, p.last);
  return {F(4.0f) * p.middle.x - F(2.0f) * ends.x, F(4.0f) * p.middle.y - F(2.0f) * ends.y,
          F(4.0f) * p.middle.z - F(2.0f) * ends.z};
}

/// |last - first|^2.
template <class F>
BLYSK_INLINE F squared_turn(const Path<F>& p) {
  if (p.far) return F(0.0f);
  const V3<F> d = minus(p.last, p.first);
  return dot(d, d);
}

}  // namespace blysk::BLYSK_ISA
