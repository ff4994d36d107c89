// shading/arc.h - unit normals at equal angles between two unit normals, without root or division.
#pragma once

#include "math/row_normals.h"
#include "shading/corners.h"

namespace blysk::BLYSK_ISA {

/// An arc between unit vectors at cosine d >= 0: see ArcFit.
template <class F>
struct Arc {
  V3<F> sum, difference;
  F even[2], odd[2];
};

template <class F>
BLYSK_INLINE Arc<F> arc_between(const V3<F>& a, const V3<F>& b, F d) {
  constexpr auto even = [](int i) { return static_cast<float>(kArcFit.even[i]); };
  constexpr auto odd = [](int i) { return static_cast<float>(kArcFit.odd[i]); };
  Arc<F> r;
  r.sum = {b.x + a.x, b.y + a.y, b.z + a.z};
  r.difference = {b.x - a.x, b.y - a.y, b.z - a.z};
  const F z = max((F(1.0f) - d) * F(0.5f), F(0.0f)), square = z * z;
  r.even[0] = z * (((F(even(3)) * z + F(even(2))) * z + F(even(1))) * z + F(even(0)));
  r.even[1] = square * (F(even(5)) * z + F(even(4)));
  r.odd[0] = z * ((F(odd(2)) * z + F(odd(1))) * z + F(odd(0)));
  r.odd[1] = square * F(odd(3));
  return r;
}

/// t in [-1, 1].
template <class F, class P>
BLYSK_INLINE V3<P> along(const Arc<F>& arc, P t) {
  const P half(0.5f), e = P(1.0f) - t * t;
  const P even = half + e * (P(arc.even[0]) + e * P(arc.even[1]));
  const P odd = t * (half + e * (P(arc.odd[0]) + e * P(arc.odd[1])));
  return {P(arc.sum.x) * even + P(arc.difference.x) * odd, P(arc.sum.y) * even + P(arc.difference.y) * odd,
          P(arc.sum.z) * even + P(arc.difference.z) * odd};
}

/// The same at any cosine d from kLowestArc on: arcs of more than 90 degrees are halved first.
template <class P>
BLYSK_INLINE V3<P> along_any(const V3<P>& a, const V3<P>& b, P d, P t) {
  const auto obtuse = d < P(0.0f), first = t < P(0.0f);
  const P square = max(P(2.0f) + P(2.0f) * d, P(1e-6f)), to_middle = reciprocal_root(square);
  const V3<P> m = {(a.x + b.x) * to_middle, (a.y + b.y) * to_middle, (a.z + b.z) * to_middle};
  const auto end = [&](P own, P middle, auto inner) { return select(obtuse & inner, middle, own); };
  const auto second = t >= P(0.0f);
  const V3<P> from = {end(a.x, m.x, second), end(a.y, m.y, second), end(a.z, m.z, second)};
  const V3<P> to = {end(b.x, m.x, first), end(b.y, m.y, first), end(b.z, m.z, first)};
  const P shift = select(first, P(1.0f), P(-1.0f));
  const P cosine = select(obtuse, square * to_middle * P(0.5f), d);
  return along(arc_between(from, to, cosine), select(obtuse, t + t + shift, t));
}

}  // namespace blysk::BLYSK_ISA
