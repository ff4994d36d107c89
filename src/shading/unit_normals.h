// shading/unit_normals.h - for methods that need normals of length near 1: unit corners, weights whose sum is
// one.
#pragma once

#include "shading/corners.h"

namespace blysk::BLYSK_ISA {

template <class F>
struct UnitNormals {
  Corners<F> corners;
  V3<F> normal[3];  ///< world, unit
  F inverse_area;   ///< one over the sum of the weights, 0 where that changes from pixel to pixel
  bool divide;      ///< any of them is 0
};

template <class F>
BLYSK_INLINE F magnitude(F v) {
  return float_of_bits(bits_of(v) & decltype(bits_of(v))(0x7fffffff));
}

/// A vector of length 0 stays.
template <class F>
BLYSK_INLINE V3<F> made_unit(const V3<F>& n) {
  const F scale = reciprocal_root(max(dot(n, n), F(1e-30f)));
  return {n.x * scale, n.y * scale, n.z * scale};
}

/// On the screen the sum of a triangle's weights is its area. That of a needle has lost its digits: there, as
/// with perspective, the pixels' own sums serve.
template <class F>
BLYSK_INLINE F inverse_area(const ShadeJob& job, const Corners<F>& c) {
  if (!job.screen_linear) return F(0.0f);
  const F a = (c.x[1] - c.x[0]) * (c.y[2] - c.y[0]), b = (c.x[2] - c.x[0]) * (c.y[1] - c.y[0]);
  const F one(1.0f);
  const auto constant = (c.w[0] == one) & (c.w[1] == one) & (c.w[2] == one);
  const auto precise = magnitude(a - b) * F(1024.0f) > magnitude(a) + magnitude(b);
  return select(constant & precise, one / (a - b), F(0.0f));
}

template <class F>
BLYSK_INLINE UnitNormals<F> fetch_unit_normals(const ShadeJob& job, Integer<F> triangle) {
  UnitNormals<F> t;
  t.corners = fetch_corners<F>(job, triangle);
  if (job.draw->normals == nullptr) {
    t.normal[0] = t.normal[1] = t.normal[2] = made_unit(face_normal(job, t.corners));
  } else {
    for (int k = 0; k < 3; ++k) {
      const V3<F> n = fetch3<F>(job.draw->normals, t.corners.vertex[k]);
      t.normal[k] = made_unit(job.draw->moved ? times(job.draw->normal_matrix, 3, n) : n);
    }
  }
  t.inverse_area = inverse_area(job, t.corners);
  t.divide = any(t.inverse_area == F(0.0f));
  return t;
}

/// What turns weights of this sum into shares of one; 0 where even the pixel's sum has vanished.
template <class F, class P>
BLYSK_INLINE P share_scale(const UnitNormals<F>& t, P sum) {
  const P own = select(magnitude(sum) > P(1e-30f), P(1.0f) / sum, P(0.0f));
  return select(P(t.inverse_area) == P(0.0f), own, P(t.inverse_area));
}

/// Barycentric coordinates.
template <class F, class P, class Y>
BLYSK_INLINE Weights<P> shares_at(const UnitNormals<F>& t, P x, Y y) {
  Weights<P> w = weights_at(t.corners, x, y);
  P scale = P(t.inverse_area);
  if (t.divide) scale = share_scale(t, (w.of[0] + w.of[1]) + w.of[2]);
  for (P& weight : w.of) weight = weight * scale;
  return w;
}

/// The reciprocal length of a normal by the exact root. One that vanished between opposite normals faces the
/// viewer.
template <class P>
BLYSK_INLINE P exact_inverse_length(V3<P>& n, P square, const V3<P>& viewer) {
  const auto gone = square < P(1e-12f);
  n = {select(gone, viewer.x, n.x), select(gone, viewer.y, n.y), select(gone, viewer.z, n.z)};
  return reciprocal_root(select(gone, dot(viewer, viewer), square));
}

}  // namespace blysk::BLYSK_ISA
