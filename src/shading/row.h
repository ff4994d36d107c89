// shading/row.h - a triangle's rows: where each begins and ends, never where a tile cuts it.
//
// A row starts on the long edge, from the top corner to the bottom one. A point of the triangle is s of the
// way down that edge and v of the way over to the middle corner: both lie in 0..1 and are linear in x and y,
// however slender the triangle is. Specification of the shading thesis, sections 0.3 and 4.2 (u = s - bend *
// v).
#pragma once

#include "shading/corners.h"
#include "shading/determinant.h"

namespace blysk::BLYSK_ISA {

template <class Lanes, class M>
BLYSK_INLINE void exchange(M where, Lanes& a, Lanes& b) {
  const Lanes old = a;
  a = select(where, b, a);
  b = select(where, old, b);
}

/// Corners 0, 1, 2 become top, bottom, middle.
template <class F>
BLYSK_INLINE void sort_corners(Corners<F>& c) {
  const auto order = [&](int a, int b) {
    const auto wrong = c.y[b] < c.y[a];
    exchange(wrong, c.vertex[a], c.vertex[b]);
    exchange(wrong, c.x[a], c.x[b]);
    exchange(wrong, c.y[a], c.y[b]);
    exchange(wrong, c.w[a], c.w[b]);
    exchange(wrong, c.q[a], c.q[b]);
    exchange(wrong, c.nearness[a], c.nearness[b]);
  };
  order(0, 2);
  order(2, 1);
  order(0, 2);
}

/// What the rows of a triangle have in common.
template <class F>
struct RowFrame {
  F x[3], y[3];  ///< top, bottom, middle
  F area;        ///< twice, in subpixels; positive if the middle corner lies to the right of the long edge
  F inverse_height;
  F slope;  ///< of the long edge, x over y
  F bend;   ///< s at the middle corner's height
  F over;   ///< v gained a subpixel to the right
};

/// Of sorted corners. Triangles with unplaced corners have none: their values mean nothing.
template <class F>
BLYSK_INLINE RowFrame<F> row_frame(const Corners<F>& c) {
  RowFrame<F> f;
  for (int k = 0; k < 3; ++k) {
    f.x[k] = select(c.unplaced, F(0.0f), c.x[k]);
    f.y[k] = select(c.unplaced, F(0.0f), c.y[k]);
  }
  const F height = f.y[1] - f.y[0], along = f.x[1] - f.x[0];
  f.area = determinant(f.x[2] - f.x[0], height, along, f.y[2] - f.y[0]);
  f.inverse_height = F(1.0f) / height;
  f.slope = along * f.inverse_height;
  f.bend = (f.y[2] - f.y[0]) * f.inverse_height;
  f.over = height / f.area;
  return f;
}

/// A row of a triangle.
template <class F>
struct RowStart {
  F s;      ///< where the row begins on the long edge: 0 top, 1 bottom
  F along;  ///< the same in x, subpixels from the top corner
};

template <class F>
BLYSK_INLINE RowStart<F> row_start(const RowFrame<F>& f, F y) {
  const F down = y - f.y[0];
  return {down * f.inverse_height, down * f.slope};
}

/// How far x is to the right of the long edge, subpixels. Times `over` it is v.
template <class F, class P>
BLYSK_INLINE P right_of(const RowFrame<F>& f, const RowStart<F>& row, P x) {
  return (x - P(f.x[0])) - P(row.along);
}

/// Columns, both covered.
template <class F>
struct RowEnds {
  Integer<F> first, last;
};

/// The first column whose centre is not left of the edge from (ax, ay) down to (bx, by). An edge that begins
/// a row owns its points, one that ends a row does not: the top-left rule.
template <class F>
BLYSK_INLINE Integer<F> first_column(F ax, F ay, F bx, F by, F y) {
  using I = Integer<F>;
  constexpr int kBias = 1 << 15;  // pixels: keeps what is truncated positive
  const F dx = bx - ax, dy = by - ay, down = y - ay;
  const F crossing = ax + dx * down / max(dy, F(1.0f));
  // Less than 1/100 pixel off, so that it can only be this column, the next or the one after.
  const F column = (crossing - F(kSubpixels / 2)) * F(1.0f / kSubpixels);
  const I guess = truncate(column + F(static_cast<float>(kBias))) - I(kBias);
  I n = guess;
  for (int i = 0; i < 2; ++i) {
    const F x = to_float((guess + I(i)) * I(kSubpixels) + I(kSubpixels / 2));
    n = n + select(determinant(x - ax, dy, dx, down) < F(0.0f), I(1), I(0));
  }
  return n;
}

/// Of a row that the triangle covers at least one pixel of.
template <class F>
BLYSK_INLINE RowEnds<F> row_ends(const RowFrame<F>& f, F y) {
  const auto upper = y < f.y[2];
  const auto at = [&](const F v[3], int if_upper, int if_lower) {
    return select(upper, v[if_upper], v[if_lower]);
  };
  const Integer<F> long_edge = first_column(f.x[0], f.y[0], f.x[1], f.y[1], y);
  const Integer<F> short_edge = first_column(at(f.x, 0, 2), at(f.y, 0, 2), at(f.x, 2, 1), at(f.y, 2, 1), y);
  const auto rightwards = f.area > F(0.0f);
  return {select(rightwards, long_edge, short_edge),
          select(rightwards, short_edge, long_edge) - Integer<F>(1)};
}

}  // namespace blysk::BLYSK_ISA
