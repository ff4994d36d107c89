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

/// Lights a point. `n` and `v` (to the viewer) need not be unit, but not zero; rn is one over the length of
/// n. Where that is an approximation (kNearly) cosines may pass 1, and the lobe is kept in its range.
/// `where()` gives the point and is called for point lights only. The side that faces the viewer is the one
/// that is lit.
template <bool kNearly, class F, class Where>
BLYSK_INLINE Intensity<F> light_scaled(const Surface& s, const V3<F>& n, F rn, const V3<F>& v, Where where) {
  const F rv = reciprocal_root(dot(v, v));
  const F n_v = dot(n, v);
  const auto side = bits_of(n_v) & decltype(bits_of(n_v))(static_cast<std::int32_t>(0x80000000));
  const F cos_v = float_of_bits(bits_of(n_v) ^ side) * rn * rv;

  Intensity<F> sum = {{F(s.ambient[0]), F(s.ambient[1]), F(s.ambient[2])},
                      {F(s.emission[0]), F(s.emission[1]), F(s.emission[2])}};
  for (int i = 0; i < s.lamps; ++i) {
    const Lamp& lamp = s.lamp[i];
    V3<F> l = {F(lamp.vector[0]), F(lamp.vector[1]), F(lamp.vector[2])};
    if (lamp.point) {
      const V3<F> p = where();
      l = {l.x - p.x, l.y - p.y, l.z - p.z};
      const F rl = reciprocal_root(max(dot(l, l), F(1e-30f)));
      l = {l.x * rl, l.y * rl, l.z * rl};
    }
    const F n_l = dot(n, l);
    const F cos_l = float_of_bits(bits_of(n_l) ^ side) * rn;
    const F d = max(cos_l, F(0.0f));
    sum.diffuse = {sum.diffuse.x + F(lamp.diffuse[0]) * d, sum.diffuse.y + F(lamp.diffuse[1]) * d,
                   sum.diffuse.z + F(lamp.diffuse[2]) * d};
    if (s.model == LightingModel::lambert) continue;

    const F l_v = dot(v, l) * rv;
    // The square of the cosine is what a division gives at once, without the root of |L + V|: for unit L and
    // V |L + V|^2 = 2 + 2 L.V.
    F square;
    if (s.model == LightingModel::blinn) {
      const F n_h = max(cos_l + cos_v, F(0.0f));
      square = n_h * n_h / max(F(2.0f) + F(2.0f) * l_v, F(1e-12f));
    } else {
      const F r_v = max(F(2.0f) * cos_l * cos_v - l_v, F(0.0f));
      square = r_v * r_v;
    }
    if constexpr (kNearly) square = min(square, F(1.0f));
    const F lobe = select(cos_l > F(0.0f), power_lobe(square, s), F(0.0f));
    sum.specular = {sum.specular.x + F(lamp.specular[0]) * lobe, sum.specular.y + F(lamp.specular[1]) * lobe,
                    sum.specular.z + F(lamp.specular[2]) * lobe};
  }
  return sum;
}

template <class F, class Where>
BLYSK_INLINE Intensity<F> light_point(const Surface& s, const V3<F>& n, const V3<F>& v, Where where) {
  return light_scaled<false>(s, n, reciprocal_root(dot(n, n)), v, where);
}

}  // namespace blysk::BLYSK_ISA
