// shading/angular_row.h - the normals of a row turn by equal angles: cos(v) = cos(beta) cos(psi - t phi).
//
// Specification of the shading thesis, section 7; the arccos-free form about the middle of the row (7.4,
// pair), in which both halves share sine and cosine and neither beta nor psi is needed.
#pragma once

#include "shading/row_path.h"

namespace blysk::BLYSK_ISA {

/// The angle between unit vectors whose difference has this squared length.
///
/// Max error: 4.6e-5 relative. Valid range: [0, 2]. Specification, section 8.1.
template <class F>
BLYSK_INLINE F angle_of_chord(F square) {
  F r = F(0.001645482f) * square + F(0.003225090f);
  r = r * square + F(0.042325762f);
  r = r * square + F(0.999954859f);
  return r * sqrt(square);
}

/// Max error: 1e-6 absolute. Valid range: |x| <= pi / 4. Lawson's iteration, the first term fixed.
template <class P>
BLYSK_INLINE P small_sine(P x) {
  const P q = x * x;
  return x + x * q * (P(-0.166628332f) + P(0.00815297841f) * q);
}

/// Max error: 1.9e-7 absolute. Valid range: |x| <= pi / 4. Likewise, the first two terms fixed.
template <class P>
BLYSK_INLINE P small_cosine(P x) {
  const P q = x * x;
  return (P(1.0f) - P(0.5f) * q) + q * q * (P(0.0416612779f) + P(-0.0013652435f) * q);
}

/// Max error: 1.7e-7 absolute. Valid range: |x| <= tan(pi / 8). Likewise, the first term fixed.
template <class P>
BLYSK_INLINE P small_arctangent(P x) {
  const P q = x * x;
  return x + x * q * (P(-0.333228916f) + q * (P(0.196702158f) + P(-0.110535696f) * q));
}

/// N.X along a row: the part that goes with the cosine of the angle from the middle and the part that goes
/// with its sine. Of far X they are constant.
template <class F>
struct ArcDot {
  Parabola<F> even, odd;
};

struct AngularRow {
  /// phi; and what makes the vectors to the arc's middle and across it of the sum and the difference of the
  /// ends.
  template <class F>
  struct Turn {
    F angle, to_middle, across;
  };
  template <class F>
  using Dot = ArcDot<F>;
  template <class P>
  struct Point {
    RowPoint<P> at;
    P cosine, sine;
  };

  /// Of ends with |Nb - Na|^2 = c, not more than 90 degrees apart. Equal ends have an angle of 0.0001: what
  /// that makes of their difference, rounding at most, stays as small.
  template <class F>
  static BLYSK_INLINE Turn<F> turn_of(F c) {
    const F square = max(c, F(1e-8f));
    const F one(1.0f), half(0.5f);
    return {angle_of_chord(square), half / sqrt(one - F(0.25f) * square), one / sqrt(square)};
  }

  template <class F>
  static BLYSK_INLINE Dot<F> dot_along(const Turn<F>& turn, const V3<F>& na, const V3<F>& nb,
                                       const Path<F>& x) {
    const V3<F> middle = scaled(plus(na, nb), turn.to_middle), across = scaled(minus(nb, na), turn.across);
    const F zero(0.0f);
    if (x.far) return {{dot(middle, x.first), zero, zero}, {dot(across, x.first), zero, zero}};
    const auto along = [&](const V3<F>& of) {
      return parabola(dot(of, x.first), dot(of, x.middle), dot(of, x.last));
    };
    return {along(middle), along(across)};
  }

  /// The walk from the foot of far X on the arc, section 7.4: both ways the same cosines serve, so that the
  /// foot has to be a pixel and moves to the nearest one of the row's steps (erratum E32). Evaluated in each
  /// pixel's own place that is another start of the same cosine. Off the arc there is no walk.
  template <class F>
  static BLYSK_INLINE Dot<F> from_foot(const Dot<F>& d, F angle, F steps) {
    const F even = d.even.start, odd = d.odd.start, half(0.5f);
    const F beta = sqrt(even * even + odd * odd);
    const F foot = F(2.0f) * small_arctangent(odd / max(beta + even, F(1e-6f)));  // from the middle
    const auto on_arc = (even > F(0.0f)) & (magnitude(foot) <= half * angle);
    const F place = (foot / angle + half) * steps;
    const F by = (to_float(truncate(select(on_arc, place, F(0.0f)) + half)) - place) * (angle / steps);
    const F cosine = small_cosine(by), sine = small_sine(by);
    Dot<F> moved = d;
    moved.even.start = select(on_arc, even * cosine - odd * sine, even);
    moved.odd.start = select(on_arc, odd * cosine + even * sine, odd);
    return moved;
  }

  template <class F, class P>
  static BLYSK_INLINE Point<P> point(const Turn<F>& turn, const RowPoint<P>& at) {
    const P u = (at.t - P(0.5f)) * P(turn.angle);
    return {at, small_cosine(u), small_sine(u)};
  }

  template <class F, class P>
  static BLYSK_INLINE P cosine(const Dot<F>& d, const Point<P>& p, bool far) {
    if (far) return P(d.even.start) * p.cosine + P(d.odd.start) * p.sine;
    return value(d.even, p.at) * p.cosine + value(d.odd, p.at) * p.sine;
  }
};

}  // namespace blysk::BLYSK_ISA
