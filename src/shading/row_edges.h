// shading/row_edges.h - normals of a row's ends that turn evenly along the edges of the triangle.
//
// Specification of the shading thesis, section 7.3: A turns from the common corner C to D, B from C to F, and
// the row from A to B. The cosines that the thesis gets from spherical triangles are those of the vectors
// here; near lamps and the side that is seen need the vectors themselves.
#pragma once

#include "shading/angular_row.h"
#include "shading/corner_light.h"
#include "shading/row.h"

namespace blysk::BLYSK_ISA {

/// At u = 0..1 of the way from a to b, unit vectors up to 90 degrees apart.
template <class Y>
BLYSK_INLINE V3<Y> turned(const V3<Y>& a, const V3<Y>& b, Y u) {
  const V3<Y> difference = minus(b, a);
  const auto turn = AngularRow::turn_of(min(dot(difference, difference), Y(2.0f)));
  const Y w = (u - Y(0.5f)) * turn.angle;
  return plus(scaled(plus(a, b), turn.to_middle * small_cosine(w)),
              scaled(difference, turn.across * small_sine(w)));
}

/// A corner of a triangle, or where a row meets an edge.
template <class Y>
struct EdgePoint {
  V3<Y> normal;
  Y x, q;  ///< subpixels from the top corner, so that its place does not show; weight of its attributes
};

/// u: share of b on the screen.
template <class Y>
BLYSK_INLINE EdgePoint<Y> between(const EdgePoint<Y>& a, const EdgePoint<Y>& b, Y u) {
  const Y q = a.q + u * (b.q - a.q);
  return {turned(a.normal, b.normal, u * b.q / q), a.x + u * (b.x - a.x), q};
}

/// The centres of a row's first and last pixel, subpixels.
template <class Y>
struct RowCentres {
  Y y, first, last;
};

template <class Y>
struct EdgeNormals {
  V3<Y> first, last;           ///< unit
  decltype(Y() < Y()) beyond;  ///< corners are too far apart, or without direction
};

/// Of sorted corners, all of them placed.
template <class F, class Y>
__attribute__((noinline)) EdgeNormals<Y> edge_normals(const ShadeJob& job, const Corners<F>& c,
                                                      const RowCentres<Y>& row) {
  EdgePoint<Y> corner[3];
  for (int k = 0; k < 3; ++k) {
    const V3<F> n = made_unit(corner_normal(job, c, k));
    corner[k] = {{Y(n.x), Y(n.y), Y(n.z)}, Y(c.x[k] - c.x[0]), Y(c.q[k])};
  }
  const auto& [top, bottom, middle] = corner;
  const Y zero(0.0f), one(1.0f);
  const auto part = [&](int from, int to) {
    const Y height(c.y[to] - c.y[from]);
    return min(max((row.y - Y(c.y[from])) / max(height, one), zero), one);
  };
  const EdgePoint<Y> along = between(top, bottom, part(0, 1)), above = between(top, middle, part(0, 2)),
                     below = between(middle, bottom, part(2, 1));
  const auto upper = row.y < Y(c.y[2]);
  const auto side = [&](Y a, Y b) { return select(upper, a, b); };
  const EdgePoint<Y> other = {{side(above.normal.x, below.normal.x), side(above.normal.y, below.normal.y),
                               side(above.normal.z, below.normal.z)},
                              side(above.x, below.x),
                              side(above.q, below.q)};
  const auto at = [&](Y x) {
    const Y width = other.x - along.x, u = (x - along.x) / select(magnitude(width) < one, one, width);
    return made_unit(between(along, other, min(max(u, zero), one)).normal);
  };
  const Y from(c.x[0]);
  const auto wide = [](const V3<Y>& a, const V3<Y>& b) { return dot(a, b) < Y(0.0f); };
  const auto gone = [](const V3<Y>& n) { return dot(n, n) < Y(0.5f); };
  return {at(row.first - from), at(row.last - from),
          wide(top.normal, bottom.normal) | wide(top.normal, middle.normal) |
              wide(middle.normal, bottom.normal) | gone(top.normal) | gone(middle.normal) |
              gone(bottom.normal)};
}

}  // namespace blysk::BLYSK_ISA
