// shading/curved_light.h - what a triangle shows as a second-order surface over the screen, and a bound of
// how far that is from Phong shading.
//
// Based on: the shading thesis, chapter 2.1 (six intensities: corners and middles of the edges). Differs in:
// the surface is laid through what the picture shows, all lamps and the transfer function included; and it is
// bounded. docs/auto.md derives the bound: third derivatives along any way through the triangle.
#pragma once

#include "shading/second_order.h"
#include "shading/stand.h"

namespace blysk::BLYSK_ISA {

template <class F>
struct CurvedLight {
  F x, y, slope;              ///< top corner, subpixels; of the long edge, x over y
  SecondOrder<F> channel[3];  ///< s in subpixels below the top corner, v in subpixels right of the long edge
  F error;                    ///< at most, of any channel as shown, 0..1
  decltype(F() < F()) fits;   ///< error says something, is small enough, and the triangle is worth it
};

/// Whether lobes have a third derivative that can be bounded.
BLYSK_INLINE bool has_curved_light(const Draw& draw) {
  if (!has_linear_light(draw)) return false;
  const Surface& s = draw.surface;
  if (s.model == LightingModel::lambert) return true;
  return s.lobe == Lobe::power ? s.shininess >= 3.0f : s.lobe_exponent >= 3;
}

namespace curved_light {

/// How fast directions turn on the way from one point of a triangle to another, in radians at most.
template <class F>
struct Turning {
  F across, along;  ///< the normal: by what is at right angles to it, and how much its length changes
  F stretch;        ///< one over the shortest interpolated normal
  F viewer;         ///< the direction to the viewer
};

template <class F>
BLYSK_INLINE Turning<F> turning_of(const Stand<F>& s) {
  const F one(1.0f), p = s.ratio, stretch = one + s.bow;
  return {s.chord * (one + F(1.7f) * p) * stretch,
          F(1.13f) * (p + (one + p) * F(0.5f) * (s.chord * s.chord)) * stretch, stretch, s.turn};
}

/// The least value of something in the triangle and its first three derivatives on such a way, at most.
template <class F>
struct Jet {
  F least, first, second, third;
};

/// Of an interpolated function whose third derivative is known on the longest way through the triangle.
inline constexpr float kRemainder = 0.0183f;
/// How much six samples that are off by one may move the surface.
inline constexpr float kSampleGain = 1.67f;

/// Single precision turns cosines by so much at most.
inline constexpr float kCosineError = 2.5e-6f;

template <class F>
BLYSK_INLINE F largest_sine(F least_cosine) {
  const F c = max(least_cosine - F(kCosineError), F(0.0f));
  return sqrt(max(F(1.0f) - c * c, F(1e-6f)));
}

/// Of N.L, positive at all corners.
template <class F>
BLYSK_INLINE Jet<F> cosine_jet(const Turning<F>& t, const F cos_l[3]) {
  const F a = t.along, b = t.across, aa = a * a, bb = b * b;
  const F highest = min(most(cos_l) * t.stretch, F(1.0f)), swing = b * largest_sine(least(cos_l));
  return {least(cos_l), swing, bb * highest + (a + a) * swing,
          F(6.0f) * a * bb * highest + max(F(6.0f) * aa, F(3.0f) * bb) * swing};
}

/// Bounds of N.H. Its second derivative is -bent N.H but for `loose`.
template <class F>
struct HalfwayJet {
  F lowest, highest;
  F slip;  ///< what single precision turns it by, at most
  F turn;  ///< of N against H; times the sine of their angle it is the first derivative
  F loose, third;
};

/// `shortest` is the least length of L + V in the triangle, `cos_h` N.H at the corners.
template <class F>
BLYSK_INLINE HalfwayJet<F> halfway_jet(const Turning<F>& t, F shortest, const F cos_h[3]) {
  const F one(1.0f), a = t.along, b = t.across, aa = a * a, bb = b * b;
  const F h = t.viewer / shortest, hh = h * h;
  const F h2 = hh * (one + F(1.16f) * shortest);
  const F h3 = hh * h * (F(3.0f) + shortest * (F(4.1f) + F(3.0f) * shortest));
  HalfwayJet<F> z;
  // Phong's |L + V| loses digits where the lamp is opposite.
  z.slip = F(kCosineError) * (one + one / (shortest * shortest));
  z.lowest = max(least(cos_h) - h - z.slip, F(0.0f));
  z.highest = min((most(cos_h) + h + z.slip) * t.stretch, one);
  const F sine = largest_sine(z.lowest), swing = b * sine;
  z.turn = b + h;
  z.loose = sine * (F(2.0f) * b * (a + h * sine) + h2);
  z.third = F(6.0f) * a * bb + max(F(6.0f) * aa, F(3.0f) * bb) * swing +
            F(3.0f) * b * (h * sqrt(bb + F(4.0f) * aa) + hh + h2) + h3;
  return z;
}

/// A lobe base^k, base = 1 - scale (1 - z), as the bound sees it.
struct LobeShape {
  float k, scale;

  /// Where base^of_base sqrt(1 - z^2)^of_sine is largest; it falls to both sides.
  [[nodiscard]] float peak(float of_base, float of_sine) const {
    const float p = of_sine * (1.0f - scale), q = of_base * scale, sum = (of_base + of_sine) * scale;
    return (sqrt(p * p + 4.0f * sum * q) - p) / (2.0f * sum);
  }
};

BLYSK_INLINE LobeShape lobe_shape(const Surface& s) {
  if (s.lobe == Lobe::power) return {s.shininess, 1.0f};
  return {static_cast<float>(s.lobe_exponent), s.lobe_scale};
}

/// Of the lobe. The largest parts of the third derivative are f'''' z'^3 and 3 f''' z' z''', of opposite
/// signs: the larger counts.
template <class F>
BLYSK_INLINE Jet<F> lobe_jet(const Surface& surface, const HalfwayJet<F>& z) {
  const F one(1.0f), lowest_base(0.25f);
  const LobeShape shape = lobe_shape(surface);
  const float k = shape.k;
  const F c(shape.scale);
  struct Power {
    F of, inverse, sine;
  };
  const auto power_at = [&](F cosine) {
    const F base = max(one - c * (one - cosine), lowest_base);
    const F of = surface.lobe == Lobe::power ? power_lobe(base * base, surface)
                                             : whole_power(base, surface.lobe_exponent);
    return Power{of, one / base, largest_sine(cosine)};
  };
  const auto peak = [&](float of_sine, float of_base) {
    return power_at(min(max(F(shape.peak(of_base, of_sine)), z.lowest), z.highest));
  };
  const Power high = power_at(z.highest), low = power_at(z.lowest);
  const Power third = peak(3.0f, k - 3.0f), second = peak(1.0f, k - 2.0f);
  const F turn2 = z.turn * z.turn, turn3 = turn2 * z.turn, sine = low.sine;
  const F f1 = high.of * F(k) * c * high.inverse, f2 = f1 * F(k - 1.0f) * c * high.inverse;
  const F step = c * third.inverse;
  const F bending = third.of * F(k * (k - 1.0f) * (k - 2.0f)) * (step * step * step) *
                    (third.sine * third.sine * third.sine) * turn3;
  const F pulling =
      second.of * F(3.0f * k * (k - 1.0f)) * (c * c * second.inverse * second.inverse) * second.sine * turn3;
  const F lowest = select(one - c * (one - z.lowest) > lowest_base, low.of, F(0.0f));
  return {lowest, f1 * z.turn * sine, max(f2 * sine * sine, f1) * turn2 + f1 * z.loose,
          max(bending, pulling) + F(3.0f) * f2 * z.turn * sine * z.loose +
              f1 * (z.third + z.slip * F(kSampleGain / kRemainder))};
}

/// N.L and the lobe of a lamp.
template <class F>
struct LampJets {
  Jet<F> diffuse, specular;
  decltype(F() < F()) sound;  ///< the lamp is on one side, and not opposite to the viewer
};

template <class F>
BLYSK_INLINE Jet<F> kept(decltype(F() < F()) where, const Jet<F>& j) {
  const F zero(0.0f);
  return {select(where, j.least, zero), select(where, j.first, zero), select(where, j.second, zero),
          select(where, j.third, zero)};
}

template <class F>
BLYSK_INLINE LampJets<F> lamp_jets(const Surface& surface, const Lamp& lamp, const Stand<F>& s,
                                   const Turning<F>& t) {
  const F zero(0.0f);
  const V3<float> l = {lamp.vector[0], lamp.vector[1], lamp.vector[2]};
  F cos_l[3], cos_h[3], shortest(2.0f);
  for (int k = 0; k < 3; ++k) {
    cos_l[k] = dot(s.n[k], l);
    const V3<F> h = {s.v[k].x + F(l.x), s.v[k].y + F(l.y), s.v[k].z + F(l.z)};
    const F square = max(dot(h, h), F(1e-12f));
    const F inverse = reciprocal_root(square);
    shortest = min(shortest, square * inverse);
    cos_h[k] = dot(s.n[k], h) * inverse;
  }
  const auto lit = least(cos_l) > zero, dark = most(cos_l) <= zero;
  LampJets<F> out;
  out.diffuse = kept(lit, cosine_jet(t, cos_l));
  out.sound = lit | dark;
  if (surface.model == LightingModel::lambert) return out;
  out.sound = out.sound & (shortest > s.turn + s.turn);
  const F room = max(shortest - s.turn, F(1e-6f));
  out.specular = kept(lit, lobe_jet(surface, halfway_jet(t, room, cos_h)));
  return out;
}

template <class F>
BLYSK_INLINE void add(Jet<F>& sum, float by, const Jet<F>& j) {
  const F k(by);
  sum = {sum.least + k * j.least, sum.first + k * j.first, sum.second + k * j.second,
         sum.third + k * j.third};
}

/// Of a channel through the sRGB transfer function, a power whose derivatives are largest where it is
/// darkest. Its straight foot meets it in a kink, next to which nothing but the function's range is known.
template <class F>
BLYSK_INLINE F shown_error(const Jet<F>& j) {
  const F foot(kSrgbFoot), least = max(j.least, foot), inverse = F(1.0f) / least;
  const F share = j.first * inverse;
  const F third = share * (F(0.924f) * share * j.first + F(1.75f) * j.second) + j.third;
  const F slope = srgb_root(least) * inverse * F(0.44f);
  return slope * third * F(kRemainder) + select(j.least < foot, F(35.0f) * j.first, F(0.0f));
}

}  // namespace curved_light

/// Phong's own light at six points, as shown.
template <class F>
BLYSK_INLINE void show_samples(const ShadeJob& job, const Corners<F>& c, const V3<F> raw[3], F shown[3][6]) {
  constexpr int kEnds[6][2] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}};
  V3<F> n[3];
  for (int k = 0; k < 3; ++k) n[k] = {raw[k].x * c.q[k], raw[k].y * c.q[k], raw[k].z * c.q[k]};
  for (int i = 0; i < 6; ++i) {
    const int a = kEnds[i][0], b = kEnds[i][1];
    const F half(0.5f);
    const F x = (c.x[a] + c.x[b]) * half, y = (c.y[a] + c.y[b]) * half;
    const V3<F> viewer = viewer_at(job, x, y);
    const V3<F> normal = {n[a].x + n[b].x, n[a].y + n[b].y, n[a].z + n[b].z};
    const Intensity<F> light = light_point(job.draw->surface, normal, viewer, [&] { return viewer; });
    const F rgb[3] = {light.diffuse.x + light.specular.x, light.diffuse.y + light.specular.y,
                      light.diffuse.z + light.specular.z};
    for (int k = 0; k < 3; ++k)
      shown[k][i] = job.transfer == Transfer::srgb ? shown_srgb(rgb[k], srgb_root(rgb[k])) : rgb[k];
  }
}

/// Not to be asked for draws without has_curved_light().
template <class F>
BLYSK_INLINE CurvedLight<F> fetch_curved_light(const ShadeJob& job, Integer<F> triangle) {
  CurvedLight<F> out;
  Corners<F> c = fetch_corners<F>(job, triangle);
  sort_corners(c);
  const RowFrame<F> frame = row_frame(c);
  const F size = magnitude(frame.area), longest = max(spread(c.x), spread(c.y));
  // Slender ones lose digits of the surface.
  out.fits = (longest * longest < size * F(64.0f)) & (select(c.unplaced, F(1.0f), F(0.0f)) < F(0.5f));
  if (!any(out.fits)) return out;

  const Stand<F> stand = fetch_stand(job, c);
  out.fits = out.fits & stand.sound;
  const auto turning = curved_light::turning_of(stand);
  const Surface& s = job.draw->surface;
  curved_light::Jet<F> sum[3];
  for (int i = 0; i < 3; ++i) sum[i] = {F(s.ambient[i] + s.emission[i]), F(0.0f), F(0.0f), F(0.0f)};
  for (int l = 0; l < s.lamps; ++l) {
    const Lamp& lamp = s.lamp[l];
    const auto jets = curved_light::lamp_jets(s, lamp, stand, turning);
    out.fits = out.fits & jets.sound;
    for (int i = 0; i < 3; ++i) {
      add(sum[i], lamp.diffuse[i], jets.diffuse);
      if (s.model != LightingModel::lambert) add(sum[i], lamp.specular[i], jets.specular);
    }
  }
  out.error = F(0.0f);
  for (int i = 0; i < 3; ++i) {
    const F error = job.transfer == Transfer::srgb ? curved_light::shown_error(sum[i])
                                                   : sum[i].third * F(curved_light::kRemainder);
    out.error = max(out.error, error);
  }
  out.fits = out.fits & (out.error <= F(job.max_error));
  if (!any(out.fits)) return out;

  F shown[3][6];
  show_samples(job, c, stand.raw, shown);
  out.x = frame.x[0];
  out.y = frame.y[0];
  out.slope = frame.slope;
  const F down = frame.inverse_height, over = frame.over;
  for (int i = 0; i < 3; ++i) {
    for (F& v : shown[i]) v = v * F(255.0f);
    SecondOrder<F> q = second_order(shown[i], frame.bend);
    q.a = q.a * down;
    q.c = q.c * (down * down);
    q.b = q.b * over;
    q.e = q.e * (down * over);
    q.d = q.d * (over * over);
    out.channel[i] = q;
  }
  return out;
}

}  // namespace blysk::BLYSK_ISA
