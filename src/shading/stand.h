// shading/stand.h - what is known of the light on a triangle from its corners: common to the bounds of
// docs/auto.md.
#pragma once

#include "shading/unit_normals.h"

namespace blysk::BLYSK_ISA {

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

/// Twice the area of so many pixels, in subpixels.
constexpr float pixels_size(float pixels) { return 2.0f * pixels * kSubpixels * kSubpixels; }

/// The same unit, of placed corners.
template <class F>
BLYSK_INLINE F doubled_area(const Corners<F>& c) {
  return magnitude((c.x[1] - c.x[0]) * (c.y[2] - c.y[0]) - (c.x[2] - c.x[0]) * (c.y[1] - c.y[0]));
}

/// Below it the sRGB transfer function is straight, above it almost the power 1 / 2.4.
inline constexpr float kSrgbFoot = 0.0031308f;

/// The power 1 / 2.4 of what is not below the foot: logarithm and exponential by short polynomials, as
/// colours need no more digits and no division.
///
/// Max error: 5e-6 relative. Valid range: up to 1e6.
template <class F>
BLYSK_INLINE F srgb_root(F linear) {
  using I = decltype(bits_of(linear));
  const F x = max(linear, F(kSrgbFoot));
  const I bits = bits_of(x) - I(0x3f3504f3), exponent = shift_right<23>(bits);
  const F t =
      float_of_bits(bits_of(x) - shift_left<23>(exponent)) - F(1.0f);  // mantissa in sqrt(1/2), sqrt(2)
  F log = F(-0.298072376f) * t + F(0.361390684f);
  log = log * t - F(0.357639746f);
  log = log * t + F(0.474986074f);
  log = log * t - F(0.721367359f);
  log = log * t + F(1.44280951f);
  const F power = (to_float(exponent) + log * t) * F(1.0f / 2.4f);
  const I whole = truncate(power + F(127.5f)) - I(127);
  const F f = power - to_float(whole);
  F exp = F(0.00957010201f) * f + F(0.0559178603f);
  exp = exp * f + F(0.240247448f);
  exp = exp * f + F(0.693121815f);
  exp = exp * f + F(0.999999261f);
  return float_of_bits(bits_of(exp) + shift_left<23>(whole));
}
/// The transfer function, with its root.
template <class F>
BLYSK_INLINE F shown_srgb(F linear, F root) {
  return select(linear < F(kSrgbFoot), linear * F(12.92f), root * F(1.055f) - F(0.055f));
}

BLYSK_INLINE float brightest(const float c[3]) {
  const float m = c[0] > c[1] ? c[0] : c[1];
  return m > c[2] ? m : c[2];
}

template <class F>
BLYSK_INLINE void fetch_normals(const ShadeJob& job, const Corners<F>& c, V3<F> raw[3]) {
  if (job.draw->normals == nullptr) {
    raw[0] = raw[1] = raw[2] = face_normal(job, c);
    return;
  }
  for (int k = 0; k < 3; ++k) {
    const V3<F> n = fetch3<F>(job.draw->normals, c.vertex[k]);
    raw[k] = job.draw->moved ? times(job.draw->normal_matrix, 3, n) : n;
  }
}

/// The corners as the bound sees them.
template <class F>
struct Stand {
  V3<F> raw[3];      ///< normals as they come, world
  V3<F> n[3], v[3];  ///< unit; the normals on the side that is seen
  F bow;             ///< how much interpolation shortens a normal at most, of its length
  F chord, ratio;    ///< between normals; between their weights on the screen, less 1
  F turn;            ///< between directions to the viewer
  decltype(F() < F()) sound;
};

template <class F>
BLYSK_INLINE Stand<F> fetch_stand(const ShadeJob& job, const Corners<F>& c) {
  Stand<F> s;
  V3<F>* raw = s.raw;
  fetch_normals(job, c, raw);
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
  const F wide = spread(c.x) * F(size(r.direction_x)), high = spread(c.y) * F(size(r.direction_y));
  s.turn = sqrt(wide * wide + high * high);

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

}  // namespace blysk::BLYSK_ISA
