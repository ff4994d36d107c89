// shading/linear_light.h - what a triangle shows as a linear function of the screen, and a bound of how far
// that is from Phong shading.
//
// docs/auto.md derives the bound. A plane for each channel is laid through what the picture shows at the
// corners, all lamps and the transfer function included: a pixel then needs neither light nor transfer. That
// is right while every lamp is on one side of the triangle.
#pragma once

#include "image/transfer.h"
#include "shading/unit_normals.h"

namespace blysk::BLYSK_ISA {

template <class F>
struct LinearLight {
  F x, y;                    ///< subpixels: a corner
  Rgb<F> at, per_x, per_y;   ///< colour there, and what a subpixel adds
  F error;                   ///< at most, of any channel as shown, 0..1
  decltype(F() < F()) fits;  ///< error says something, is small enough, and the triangle is worth it
};

/// Triangles under so many pixels are lit pixel by pixel: three corners cost as much.
inline constexpr float kLinearPixels = 3;

/// Whether the light of a draw can be bounded at all: the lobe has to be a convex power of the cosine or of
/// a linear function of it, lamps are far away, and faces have one colour.
BLYSK_INLINE bool has_linear_light(const Draw& draw) {
  const Surface& s = draw.surface;
  if (draw.colors != nullptr) return false;
  for (int i = 0; i < s.lamps; ++i) {
    if (s.lamp[i].point) return false;
  }
  if (s.model == LightingModel::lambert) return true;
  if (s.model != LightingModel::blinn) return false;
  if (s.lobe == Lobe::power) return s.shininess >= 2.0f;
  return s.lobe != Lobe::schlick && s.lobe != Lobe::logarithmic && s.lobe != Lobe::quadratic;
}

namespace linear_light {

template <class F>
BLYSK_INLINE F least(const F v[3]) {
  return min(min(v[0], v[1]), v[2]);
}
template <class F>
BLYSK_INLINE F most(const F v[3]) {
  return max(max(v[0], v[1]), v[2]);
}
template <class F>
BLYSK_INLINE F spread(const F v[3]) {
  return most(v) - least(v);
}

BLYSK_INLINE float brightest(const float c[3]) {
  const float m = c[0] > c[1] ? c[0] : c[1];
  return m > c[2] ? m : c[2];
}

/// The corners as the bound sees them.
template <class F>
struct Stand {
  V3<F> n[3], v[3];  ///< unit; the normals on the side that is seen
  F bow;             ///< how much interpolation shortens a normal at most, of its length
  F chord, ratio;    ///< between normals; between their weights on the screen, less 1
  F turn;            ///< between directions to the viewer
  decltype(F() < F()) sound;
};

template <class F>
BLYSK_INLINE Stand<F> take_stand(const ShadeJob& job, const Corners<F>& c, const V3<F> raw[3]) {
  Stand<F> s;
  F weight[3], facing[3];
  const F tiny(1e-20f);
  F shortest(1.0f);
  for (int k = 0; k < 3; ++k) {
    const F square = dot(raw[k], raw[k]);
    shortest = min(shortest, square);
    const F inverse = reciprocal_root(max(square, tiny));
    weight[k] = c.q[k] * (square * inverse);
    s.v[k] = made_unit(viewer_at(job, c.x[k], c.y[k]));
    s.n[k] = {raw[k].x * inverse, raw[k].y * inverse, raw[k].z * inverse};
    facing[k] = dot(s.n[k], s.v[k]);
  }
  const auto square_between = [](const V3<F>& a, const V3<F>& b) {
    const V3<F> d = {a.x - b.x, a.y - b.y, a.z - b.z};
    return dot(d, d);
  };
  const F square = max(max(square_between(s.n[0], s.n[1]), square_between(s.n[1], s.n[2])),
                       square_between(s.n[2], s.n[0]));
  s.chord = sqrt(square);
  s.bow = F(0.18f) * square;
  s.ratio = most(weight) / max(least(weight), tiny) - F(1.0f);
  // Unit vectors are no farther apart than the longer ones that the picture's plane gives.
  const ViewRays& r = *job.rays;
  const auto size = [](const float v[3]) { return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]); };
  s.turn = spread(c.x) * F(size(r.direction_x)) + spread(c.y) * F(size(r.direction_y));

  const auto sign = bits_of(facing[0]) & Integer<F>(static_cast<std::int32_t>(0x80000000));
  const auto turned = [&](F v) { return float_of_bits(bits_of(v) ^ sign); };
  for (int k = 0; k < 3; ++k) {
    s.n[k] = {turned(s.n[k].x), turned(s.n[k].y), turned(s.n[k].z)};
    facing[k] = turned(facing[k]);
  }
  // Seen from one side everywhere, and within what the bound allows itself.
  s.sound =
      (least(facing) > s.turn + F(1e-4f)) & (shortest > tiny) & (square < F(0.25f)) & (s.ratio < F(0.25f));
  return s;
}

/// What a lamp gives the corners, and how far from it Phong shading may be.
template <class F>
struct LampLight {
  F cos_l[3], lobe[3];  ///< clamped
  F error_cos_l, error_lobe;
  decltype(F() < F()) sound;  ///< the lamp is on one side
};

template <class F>
BLYSK_INLINE void light_lobe(const Surface& surface, const Lamp& lamp, const Stand<F>& s, LampLight<F>& out) {
  const F one(1.0f);
  F z[3], shortest(2.0f);
  for (int k = 0; k < 3; ++k) {
    const V3<F> h = {s.v[k].x + F(lamp.vector[0]), s.v[k].y + F(lamp.vector[1]),
                     s.v[k].z + F(lamp.vector[2])};
    const F square = max(dot(h, h), F(1e-12f));
    const F inverse = reciprocal_root(square);
    shortest = min(shortest, square * inverse);
    z[k] = dot(s.n[k], h) * inverse;
    const F clamped = min(max(z[k], F(0.0f)), one);
    out.lobe[k] = specular_lobe(clamped * clamped, surface);
  }
  out.sound = out.sound & (shortest > s.turn + s.turn);
  const F turn = s.turn / max(shortest - s.turn, F(1e-6f));  // of the half vector
  const F range = spread(z);
  // Two reciprocal roots are up to 1.2e-6 off, which the lobe multiplies.
  const F shift = (s.chord * turn + s.ratio * (range + turn + turn)) * F(1.0f / 3.0f) +
                  F(1.5f) * turn * turn + F(2.5e-6f);
  // The lobe is base^k, base = 1 - scale (1 - z): it, its slope and its bend are largest where z is.
  const bool power = surface.lobe == Lobe::power;
  const float k = power ? surface.shininess : static_cast<float>(surface.lobe_exponent);
  const float scale = power ? 1.0f : surface.lobe_scale;
  const F highest = min((most(z) + shift) * (one + s.bow), one);
  const F base = max(one - F(scale) * (one - highest), F(0.25f));
  const F inverse = one / (base * base);
  const F value = power ? power_lobe(base * base, surface) : whole_power(base, surface.lobe_exponent);
  const F chord = F(0.125f * (k - 1.0f) * scale) * (range * range);
  out.error_lobe = value * F(k * scale) * inverse * (max(s.bow, chord) + shift * F(1.1f));
}

template <class F>
BLYSK_INLINE LampLight<F> light_corners(const Surface& surface, const Lamp& lamp, const Stand<F>& s) {
  LampLight<F> out;
  const F zero(0.0f);
  F cos_l[3];
  for (int k = 0; k < 3; ++k)
    cos_l[k] = dot(s.n[k], V3<float>{lamp.vector[0], lamp.vector[1], lamp.vector[2]});
  const auto lit = least(cos_l) > zero, dark = most(cos_l) <= zero;
  out.sound = lit | dark;
  const auto if_lit = [&](F v) { return select(lit, v, zero); };
  for (int k = 0; k < 3; ++k) out.cos_l[k] = if_lit(cos_l[k]);
  out.error_cos_l = if_lit(s.bow * most(cos_l) + s.ratio * spread(cos_l) * F(0.34f));
  if (surface.model == LightingModel::lambert) return out;
  light_lobe(surface, lamp, s, out);
  for (F& v : out.lobe) v = if_lit(v);
  out.error_lobe = if_lit(out.error_lobe);
  return out;
}

/// Takes a channel of the corners through the sRGB transfer function; returns the error that this leaves of
/// `error` in linear light. The function is concave, its slope and bend are largest where it is darkest.
template <class F>
BLYSK_INLINE F show(F of[3], F error) {
  const F joint(0.0031308f);
  const F low = least(of), range = most(of) - low;
  F root[3];
  for (int k = 0; k < 3; ++k) {
    root[k] = power_poly(max(of[k], joint), 1.0f / 2.4f);
    of[k] = select(of[k] < joint, of[k] * F(12.92f), root[k] * F(1.055f) - F(0.055f));
  }
  const F inverse = F(1.0f) / max(low - error, joint);
  const F root_over = least(root) * inverse;
  const F kink = select(low - error < joint, range * F(0.06f), F(0.0f));
  return root_over * (F(0.45f) * error + F(0.0321f) * inverse * (range * range)) + kink;
}

}  // namespace linear_light

/// Not to be asked for draws without has_linear_light().
template <class F>
BLYSK_INLINE LinearLight<F> fetch_linear_light(const ShadeJob& job, Integer<F> triangle) {
  using linear_light::spread;
  LinearLight<F> out;
  const Corners<F> c = fetch_corners<F>(job, triangle);
  const F x1 = c.x[1] - c.x[0], y1 = c.y[1] - c.y[0], x2 = c.x[2] - c.x[0], y2 = c.y[2] - c.y[0];
  const F area = x1 * y2 - x2 * y1, size = magnitude(area);
  const F width = spread(c.x), height = spread(c.y), longest = max(width, height);
  // Needles: the area has lost digits. The larger of the sides is at most 2^23.
  out.fits = (size >= F(2.0f * kLinearPixels * kSubpixels * kSubpixels)) &
             (longest * longest < size * F(512.0f)) & (select(c.unplaced, F(1.0f), F(0.0f)) < F(0.5f));
  if (!any(out.fits)) return out;

  V3<F> raw[3];
  if (job.draw->normals == nullptr) {
    raw[0] = raw[1] = raw[2] = face_normal(job, c);
  } else {
    for (int k = 0; k < 3; ++k) {
      const V3<F> n = fetch3<F>(job.draw->normals, c.vertex[k]);
      raw[k] = job.draw->moved ? times(job.draw->normal_matrix, 3, n) : n;
    }
  }
  const auto stand = linear_light::take_stand(job, c, raw);
  const Surface& s = job.draw->surface;
  Rgb<F> corner[3];
  for (Rgb<F>& i : corner) {
    i = {F(s.ambient[0] + s.emission[0]), F(s.ambient[1] + s.emission[1]), F(s.ambient[2] + s.emission[2])};
  }
  out.error = F(0.0f);
  out.fits = out.fits & stand.sound;
  for (int l = 0; l < s.lamps; ++l) {
    const Lamp& lamp = s.lamp[l];
    const auto light = linear_light::light_corners(s, lamp, stand);
    out.fits = out.fits & light.sound;
    out.error = out.error + light.error_cos_l * F(linear_light::brightest(lamp.diffuse));
    for (int k = 0; k < 3; ++k) corner[k] = plus_scaled(corner[k], lamp.diffuse, light.cos_l[k]);
    if (s.model == LightingModel::lambert) continue;
    out.error = out.error + light.error_lobe * F(linear_light::brightest(lamp.specular));
    for (int k = 0; k < 3; ++k) corner[k] = plus_scaled(corner[k], lamp.specular, light.lobe[k]);
  }
  const F light_error = out.error;
  F shown[3][3];  // channel, corner
  for (int channel = 0; channel < 3; ++channel) {
    F* of = shown[channel];
    for (int k = 0; k < 3; ++k) of[k] = channel == 0 ? corner[k].x : channel == 1 ? corner[k].y : corner[k].z;
    if (job.transfer == Transfer::srgb) out.error = max(out.error, linear_light::show(of, light_error));
  }
  out.fits = out.fits & (out.error <= F(job.max_error));

  const F inverse = F(255.0f) / area;
  const F x1a = x1 * inverse, y1a = y1 * inverse, x2a = x2 * inverse, y2a = y2 * inverse;
  const auto slopes = [&](const F v[3], F& at, F& per_x, F& per_y) {
    at = v[0] * F(255.0f);
    per_x = (v[1] - v[0]) * y2a - (v[2] - v[0]) * y1a;
    per_y = (v[2] - v[0]) * x1a - (v[1] - v[0]) * x2a;
  };
  slopes(shown[0], out.at.x, out.per_x.x, out.per_y.x);
  slopes(shown[1], out.at.y, out.per_x.y, out.per_y.y);
  slopes(shown[2], out.at.z, out.per_x.z, out.per_y.z);
  out.x = c.x[0];
  out.y = c.y[0];
  return out;
}

/// What a pixel shows: 0..255, not rounded.
template <class F, class P, class Y>
BLYSK_INLINE Rgb<P> shown_at(const LinearLight<F>& l, P x, Y y) {
  const P dx = x - P(l.x), dy = P(y) - P(l.y);
  const auto value = [&](F at, F per_x, F per_y) {
    return min(max((P(at) + dy * P(per_y)) + dx * P(per_x), P(0.0f)), P(255.0f));
  };
  return {value(l.at.x, l.per_x.x, l.per_y.x), value(l.at.y, l.per_x.y, l.per_y.y),
          value(l.at.z, l.per_x.z, l.per_y.z)};
}

}  // namespace blysk::BLYSK_ISA
