// shading/linear_light.h - what a triangle shows as a linear function of the screen, and a bound of how far
// that is from Phong shading.
//
// docs/auto.md derives the bound. A plane for each channel is laid through what the picture shows at the
// corners, all lamps and the transfer function included: a pixel then needs neither light nor transfer. That
// is right while every lamp is on one side of the triangle.
#pragma once

#include "image/transfer.h"
#include "shading/stand.h"

namespace blysk::BLYSK_ISA {

template <class F>
struct LinearLight {
  F x, y;                    ///< subpixels: a corner
  Rgb<F> at, per_x, per_y;   ///< colour there, and what a subpixel adds
  F error;                   ///< at most, of any channel as shown, 0..1
  decltype(F() < F()) near;  ///< does not fit, but a surface may
  decltype(F() < F()) fits;  ///< error says something, is small enough, and the triangle is worth it
};

/// Triangles under so many pixels are lit pixel by pixel: three corners cost as much.
inline constexpr float kLinearPixels = 3;

/// Surfaces are tried of triangles of so many pixels, whose planes are not further off than so many times
/// what is allowed: others seldom fit or do not pay.
inline constexpr float kSurfacePixels = 16, kSurfaceErrors = 10;

namespace linear_light {

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
  const F joint(kSrgbFoot);
  const F low = least(of), range = most(of) - low;
  F root[3];
  for (int k = 0; k < 3; ++k) {
    root[k] = srgb_root(of[k]);
    of[k] = shown_srgb(of[k], root[k]);
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
  LinearLight<F> out;
  const Corners<F> c = fetch_corners<F>(job, triangle);
  const F x1 = c.x[1] - c.x[0], y1 = c.y[1] - c.y[0], x2 = c.x[2] - c.x[0], y2 = c.y[2] - c.y[0];
  const F area = x1 * y2 - x2 * y1, size = magnitude(area);
  const F width = spread(c.x), height = spread(c.y), longest = max(width, height);
  // Needles: the area has lost digits. The larger of the sides is at most 2^23.
  out.fits = (size >= F(pixels_size(kLinearPixels))) & (longest * longest < size * F(512.0f)) &
             (select(c.unplaced, F(1.0f), F(0.0f)) < F(0.5f));
  out.near = out.fits;
  if (!any(out.fits)) return out;

  const Stand<F> stand = fetch_stand(job, c);
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
    out.error = out.error + light.error_cos_l * F(brightest(lamp.diffuse));
    for (int k = 0; k < 3; ++k) corner[k] = plus_scaled(corner[k], lamp.diffuse, light.cos_l[k]);
    if (s.model == LightingModel::lambert) continue;
    out.error = out.error + light.error_lobe * F(brightest(lamp.specular));
    for (int k = 0; k < 3; ++k) corner[k] = plus_scaled(corner[k], lamp.specular, light.lobe[k]);
  }
  const F light_error = out.error;
  out.near = out.fits & (size >= F(pixels_size(kSurfacePixels))) &
             (light_error <= F(kSurfaceErrors * job.max_error));
  // Nothing that is shown is less than a third of it off.
  if (job.transfer == Transfer::srgb) out.fits = out.fits & (light_error <= F(3.0f * job.max_error));
  if (!any(out.fits)) return out;

  F shown[3][3];  // channel, corner
  for (int channel = 0; channel < 3; ++channel) {
    F* of = shown[channel];
    for (int k = 0; k < 3; ++k) of[k] = channel == 0 ? corner[k].x : channel == 1 ? corner[k].y : corner[k].z;
    if (job.transfer == Transfer::srgb) out.error = max(out.error, linear_light::show(of, light_error));
  }
  out.fits = out.fits & (out.error <= F(job.max_error));
  out.near = and_not(out.fits, out.near);

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

}  // namespace blysk::BLYSK_ISA
