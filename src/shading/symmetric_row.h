// shading/symmetric_row.h - the accelerated cosines of a row: its normals are linear between unit ends, so
// that their length depends on z = t (1 - t) alone and one root serves both halves of the row.
//
// Specification of the shading thesis, section 6, with M = -c z, c = |Nb - Na|^2.
#pragma once

#include "shading/row_path.h"

namespace blysk::BLYSK_ISA {

/// Of 1 / sqrt(1 + M), M in [-0.5, 0]; in the order of the registry's choices.
enum class RowRoot { exact, taylor, chebyshev, shift, minimax };

/// Coefficients of one row: base + z (first + z second). The exact root keeps c in `first`.
template <class F>
struct RootTerms {
  F base, first, second;
};

/// The parabola through the root at z = 0 and at two places that spread the error evenly over the row's own
/// range, as the third Chebyshev polynomial does.
///
/// Max error: relative, for rows that turn by 20 deg 3.5e-7, 30 deg 4.1e-6, 45 deg 4.9e-5, 60 deg 3.0e-4,
/// 90 deg 4.2e-3, and rounding of 2e-6. Valid range: c in [0, 2].
template <class F>
BLYSK_INLINE RootTerms<F> own_root(F c) {
  constexpr float kNear = 0.1160254f, kFar = 0.2320508f;
  const F one(1.0f);
  const F a = (reciprocal_root(one - F(kNear) * c) - one) * F(1.0f / kNear);
  const F b = (reciprocal_root(one - F(kFar) * c) - one) * F(1.0f / kFar);
  const F second = (b - a) * F(1.0f / (kFar - kNear));
  return {one, a - second * F(kNear), second};
}

/// Not less than the error of own_root() without its rounding.
template <class F>
BLYSK_INLINE F own_root_error(F c) {
  const F quarter = F(0.25f) * c;
  return ((quarter * quarter) * quarter) * (F(0.0122f) + F(0.043f) * quarter);
}

template <class F>
BLYSK_INLINE RootTerms<F> root_terms(RowRoot root, F c) {
  const F one(1.0f);
  switch (root) {
    case RowRoot::exact:
      return {one, c, one};
    case RowRoot::taylor:
      return {one, F(0.5f) * c, F(0.375f) * (c * c)};
    case RowRoot::chebyshev:
      return {F(1.003f), F(0.403f) * c, F(0.82f) * (c * c)};
    case RowRoot::shift:
      return {one, F(13.0f / 32) * c, F(26.0f / 32) * (c * c)};
    case RowRoot::minimax:
      break;
  }
  return own_root(c);
}

/// N.X |N| along a row: start + gain t + z (bend + skew t); of far X the first two.
template <class F>
struct RowDot {
  F start, gain, bend, skew;
};

struct SymmetricRow {
  template <class F>
  using Turn = RootTerms<F>;
  template <class F>
  using Dot = RowDot<F>;
  template <class P>
  struct Point {
    RowPoint<P> at;
    P root;
  };

  template <class F>
  static BLYSK_INLINE Dot<F> dot_along(const Turn<F>&, const V3<F>& na, const V3<F>& nb, const Path<F>& x) {
    const F start = dot(na, x.first);
    if (x.far) return {start, dot(nb, x.first) - start, F(0.0f), F(0.0f)};
    const V3<F> turn = minus(nb, na), bend = bend_of(x);
    return {start, dot(nb, x.last) - start, dot(na, bend) - dot(turn, minus(x.last, x.first)),
            dot(turn, bend)};
  }

  template <class F, class P>
  static BLYSK_INLINE Point<P> point(RowRoot root, const Turn<F>& turn, const RowPoint<P>& at) {
    if (root == RowRoot::exact) return {at, reciprocal_root(P(1.0f) - P(turn.first) * at.z)};
    return {at, P(turn.base) + at.z * (P(turn.first) + at.z * P(turn.second))};
  }

  /// N.X.
  template <class F, class P>
  static BLYSK_INLINE P cosine(const Dot<F>& d, const Point<P>& p, bool far) {
    P v = P(d.start) + P(d.gain) * p.at.t;
    if (!far) v = v + p.at.z * (P(d.bend) + P(d.skew) * p.at.t);
    return v * p.root;
  }
};

}  // namespace blysk::BLYSK_ISA
