// lighting/lighting.h - the lighting models, for plain floats and for lanes.
//
//   I = ka*Ia + sum over lights of Il * (kd*(N.L) + ks*lobe(N.H or R.V)), everything clamped at zero from
//   below
//
// Thesis, formulas (2.1) and section 2.1 of the specification. Only dot products are normalised, never
// vectors: N.L / |N| costs one reciprocal root and one multiplication instead of three.
#pragma once

#include "lighting/lobe.h"
#include "simd/approx.h"
#include "simd/lanes.h"

namespace blysk::BLYSK_ISA {

template <class F>
struct V3 {
  F x, y, z;
};

template <class F, class G>
BLYSK_INLINE F dot(const V3<F>& a, const V3<G>& b) {
  return (a.x * F(b.x) + a.y * F(b.y)) + a.z * F(b.z);
}

template <class F>
using Rgb = V3<F>;

/// The light that leaves a point: what Gouraud shading interpolates.
template <class F>
struct Intensity {
  Rgb<F> diffuse;   ///< ambient and diffuse light, times ka and kd: what the colours of vertices multiply
  Rgb<F> specular;  ///< specular light times ks, and emission
};

/// A point's normal and direction to the viewer, of any length but zero, and what makes cosines of their dot
/// products.
template <class F>
struct Stance {
  V3<F> n, v;
  F rn, rv;                     ///< 1 / |n|, 1 / |v|
  decltype(bits_of(F())) side;  ///< the sign bit, where the other side of the surface is lit
  F n_to_v;                     ///< |n| N.V of the side that is lit
};

/// With rn, one over the length of n, from wherever the method has it.
template <class F>
BLYSK_INLINE Stance<F> take_stance(const V3<F>& n, F rn, const V3<F>& v, decltype(bits_of(F())) side) {
  Stance<F> p{n, v, rn, reciprocal_root(dot(v, v)), side, {}};
  p.n_to_v = float_of_bits(bits_of(dot(n, v)) ^ side) * p.rv;
  return p;
}

template <class F>
BLYSK_INLINE Stance<F> take_stance(const V3<F>& n, const V3<F>& v, decltype(bits_of(F())) side) {
  return take_stance(n, reciprocal_root(dot(n, n)), v, side);
}

/// The sign bit where v sees the back of n.
template <class F>
BLYSK_INLINE auto side_seen(const V3<F>& n, const V3<F>& v) {
  return bits_of(dot(n, v)) & decltype(bits_of(F()))(static_cast<std::int32_t>(0x80000000));
}

/// How a lamp stands to a point.
template <class F>
struct LampAngles {
  F cos_l;  ///< N.L, signed
  F lobe;   ///< lobe_of_argument()'s: N.H or R.V or its square, 0 where that is negative
};

/// `where()` gives the point and is called for point lights only.
template <class F, class Where>
BLYSK_INLINE LampAngles<F> lamp_angles(const Surface& s, const Lamp& lamp, const Stance<F>& p, Where where) {
  V3<F> l = {F(lamp.vector[0]), F(lamp.vector[1]), F(lamp.vector[2])};
  if (lamp.point) {
    const V3<F> at = where();
    l = {l.x - at.x, l.y - at.y, l.z - at.z};
    const F rl = reciprocal_root(max(dot(l, l), F(1e-30f)));
    l = {l.x * rl, l.y * rl, l.z * rl};
  }
  const F n_to_l = float_of_bits(bits_of(dot(p.n, l)) ^ p.side);  // |n| N.L
  LampAngles<F> a{n_to_l * p.rn, F(0.0f)};
  if (s.model == LightingModel::lambert) return a;

  const F l_v = dot(p.v, l) * p.rv;
  // The square of the cosine is what a division gives at once, without the root of |L + V|: for unit L and
  // V |L + V|^2 = 2 + 2 L.V. The length of n comes last: the division need not wait for its root. The cosine
  // itself takes neither division nor root, but the polynomial.
  if (s.model == LightingModel::blinn) {
    const F n_to_h = max(n_to_l + p.n_to_v, F(0.0f));
    const F h = max(F(2.0f) + F(2.0f) * l_v, F(1e-12f));
    a.lobe =
        s.lobe == Lobe::power ? n_to_h * n_to_h / h * (p.rn * p.rn) : n_to_h * (p.rn * reciprocal_root(h));
  } else {
    const F r_v = max(F(2.0f) * n_to_l * p.n_to_v * (p.rn * p.rn) - l_v, F(0.0f));
    a.lobe = s.lobe == Lobe::power ? r_v * r_v : r_v;
  }
  return a;
}

/// Before any lamp.
template <class F>
BLYSK_INLINE Intensity<F> own_intensity(const Surface& s) {
  return {{F(s.ambient[0]), F(s.ambient[1]), F(s.ambient[2])},
          {F(s.emission[0]), F(s.emission[1]), F(s.emission[2])}};
}

template <class F>
BLYSK_INLINE Rgb<F> plus_scaled(const Rgb<F>& sum, const float color[3], F by) {
  return {sum.x + F(color[0]) * by, sum.y + F(color[1]) * by, sum.z + F(color[2]) * by};
}

/// Lights a point. `n` and `v` (to the viewer) need not be unit, but not zero; rn is one over the length of
/// n. Where that is an approximation (kNearly) cosines may pass 1, and the lobe is kept in its range.
/// `where()` gives the point and is called for point lights only. The side that faces the viewer is the one
/// that is lit.
template <bool kNearly, class F, class Where>
BLYSK_INLINE Intensity<F> light_scaled(const Surface& s, const V3<F>& n, F rn, const V3<F>& v, Where where) {
  const Stance<F> stance = take_stance(n, rn, v, side_seen(n, v));
  Intensity<F> sum = own_intensity<F>(s);
  for (int i = 0; i < s.lamps; ++i) {
    const LampAngles<F> a = lamp_angles(s, s.lamp[i], stance, where);
    sum.diffuse = plus_scaled(sum.diffuse, s.lamp[i].diffuse, max(a.cos_l, F(0.0f)));
    if (s.model == LightingModel::lambert) continue;
    const F argument = kNearly ? min(a.lobe, F(1.0f)) : a.lobe;
    const F lobe = select(a.cos_l > F(0.0f), lobe_of_argument(argument, s), F(0.0f));
    sum.specular = plus_scaled(sum.specular, s.lamp[i].specular, lobe);
  }
  return sum;
}

template <class F, class Where>
BLYSK_INLINE Intensity<F> light_point(const Surface& s, const V3<F>& n, const V3<F>& v, Where where) {
  return light_scaled<false>(s, n, reciprocal_root(dot(n, n)), v, where);
}

}  // namespace blysk::BLYSK_ISA
