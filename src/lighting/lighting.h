// lighting/lighting.h - the lighting models, for plain floats and for lanes.
//
//   I = ka*Ia + sum over lights of Il * (kd*(N.L) + ks*lobe(N.H or R.V)), everything clamped at zero from
//   below
//
// Thesis, formulas (2.1) and section 2.1 of the specification. Only dot products are normalised, never
// vectors: N.L / |N| costs one reciprocal root and one multiplication instead of three.
#pragma once

#include "lighting/lamp.h"
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

/// cos^n from the square of a cosine in [0, 1].
template <class F>
BLYSK_INLINE F power_lobe(F square, const Surface& s) {
  if (s.whole_shininess == 0) {
    return select(square > F(0.0f), power_poly(max(square, F(1e-30f)), 0.5f * s.shininess), F(0.0f));
  }
  if (s.whole_shininess == 1) return sqrt(square);
  // (cos^2)^(n/2) by repeated squaring from the highest bit of n/2: at most two multiplications a bit.
  const int half = s.whole_shininess >> 1;
  F r = square;
  for (int bit = 30 - __builtin_clz(static_cast<unsigned>(half)); bit >= 0; --bit) {
    r = r * r;
    if (((half >> bit) & 1) != 0) r = r * square;
  }
  return (s.whole_shininess & 1) != 0 ? r * sqrt(square) : r;
}

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
  F cos_v;                      ///< N.V of the side that is lit
};

template <class F>
BLYSK_INLINE Stance<F> take_stance(const V3<F>& n, const V3<F>& v, decltype(bits_of(F())) side) {
  Stance<F> p{n, v, reciprocal_root(dot(n, n)), reciprocal_root(dot(v, v)), side, {}};
  p.cos_v = float_of_bits(bits_of(dot(n, v)) ^ side) * p.rn * p.rv;
  return p;
}

/// How a lamp stands to a point.
template <class F>
struct LampAngles {
  F cos_l;   ///< N.L, signed
  F square;  ///< of N.H or R.V, 0 where that is negative
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
  LampAngles<F> a{float_of_bits(bits_of(dot(p.n, l)) ^ p.side) * p.rn, F(0.0f)};
  if (s.model == LightingModel::lambert) return a;

  const F l_v = dot(p.v, l) * p.rv;
  // The square of the cosine is what a division gives at once, without the root of |L + V|: for unit L and
  // V |L + V|^2 = 2 + 2 L.V.
  if (s.model == LightingModel::blinn) {
    const F n_h = max(a.cos_l + p.cos_v, F(0.0f));
    a.square = n_h * n_h / max(F(2.0f) + F(2.0f) * l_v, F(1e-12f));
  } else {
    const F r_v = max(F(2.0f) * a.cos_l * p.cos_v - l_v, F(0.0f));
    a.square = r_v * r_v;
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

/// Lights a point. `n` and `v` (to the viewer) need not be unit, but not zero; `where()` gives the point and
/// is called for point lights only. The side that faces the viewer is the one that is lit.
template <class F, class Where>
BLYSK_INLINE Intensity<F> light_point(const Surface& s, const V3<F>& n, const V3<F>& v, Where where) {
  using I = decltype(bits_of(F()));
  const I side = bits_of(dot(n, v)) & I(static_cast<std::int32_t>(0x80000000));
  const Stance<F> stance = take_stance(n, v, side);
  Intensity<F> sum = own_intensity<F>(s);
  for (int i = 0; i < s.lamps; ++i) {
    const LampAngles<F> a = lamp_angles(s, s.lamp[i], stance, where);
    sum.diffuse = plus_scaled(sum.diffuse, s.lamp[i].diffuse, max(a.cos_l, F(0.0f)));
    if (s.model == LightingModel::lambert) continue;
    const F lobe = select(a.cos_l > F(0.0f), power_lobe(a.square, s), F(0.0f));
    sum.specular = plus_scaled(sum.specular, s.lamp[i].specular, lobe);
  }
  return sum;
}

}  // namespace blysk::BLYSK_ISA
