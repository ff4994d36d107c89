// shading/lit_triangle.h - what interpolation of light starts from: Phong's light at single points of a
// triangle, lamp by lamp, and the way back from interpolated values to a colour.
//
// Of each lamp two numbers are interpolated, N.L and cos^n: that is right for lamps of any number and colour.
// N.L is signed, and clamped after interpolation: a clamped sample would put a kink into the triangle
// (specification of the shading thesis, sections 0.2 and 4.6). Which side of the surface is seen is decided
// once a triangle, by the mean of its normals: samples of one triangle must not jump from side to side, and
// the face of a sliver says little.
#pragma once

#include "shading/corner_light.h"
#include "shading/row.h"

namespace blysk::BLYSK_ISA {

template <class F>
struct LitTriangle {
  Corners<F> corners;  ///< sorted
  V3<F> normal[3];     ///< world, on the side that is seen
};

template <class F>
BLYSK_INLINE LitTriangle<F> fetch_lit_triangle(const ShadeJob& job, Integer<F> index) {
  LitTriangle<F> t;
  t.corners = fetch_corners<F>(job, index);
  sort_corners(t.corners);
  V3<F>* n = t.normal;
  for (int k = 0; k < 3; ++k) n[k] = corner_normal(job, t.corners, k);
  V3<F> p[3];
  for (int k = 0; k < 3; ++k) p[k] = world_position<F>(job, t.corners.vertex[k]);
  const auto mean = [](const V3<F>* of) {
    const F third(1.0f / 3.0f);
    return V3<F>{(of[0].x + of[1].x + of[2].x) * third, (of[0].y + of[1].y + of[2].y) * third,
                 (of[0].z + of[1].z + of[2].z) * third};
  };
  const auto sign =
      bits_of(dot(mean(n), viewer_from(job, mean(p)))) & Integer<F>(static_cast<std::int32_t>(0x80000000));
  const auto turn = [&](F v) { return float_of_bits(bits_of(v) ^ sign); };
  for (int k = 0; k < 3; ++k) n[k] = {turn(n[k].x), turn(n[k].y), turn(n[k].z)};
  return t;
}

/// What the lamps give a point. Only the surface's lamps are filled in, and no lobe for Lambert's model.
template <class F>
struct LampTerms {
  F cos_l[kMaxLamps];  ///< N.L, signed
  F lobe[kMaxLamps];   ///< cos^n, also where the lamp is behind the surface
};

/// A point of the picture: subpixels, and how near the triangle is there.
template <class P>
struct ScreenPoint {
  P x, y, nearness;
};

/// Weights of any positive scale.
template <class F, class P>
BLYSK_INLINE void light_lamps(const ShadeJob& job, const LitTriangle<F>& t, const Weights<P>& w,
                              const ScreenPoint<P>& at, LampTerms<P>& out) {
  const Surface& s = job.draw->surface;
  const V3<P> viewer = viewer_at(job, at.x, at.y);
  const V3<P> n = or_viewer(mix(w, t.normal[0], t.normal[1], t.normal[2]), viewer);
  const Stance<P> stance = take_stance(n, viewer, Integer<P>(0));
  const auto where = [&] { return point_at(job, at.x, at.y, at.nearness, viewer); };
  for (int i = 0; i < s.lamps; ++i) {
    const LampAngles<P> a = lamp_angles(s, s.lamp[i], stance, where);
    out.cos_l[i] = a.cos_l;
    if (s.model != LightingModel::lambert) out.lobe[i] = lobe_of_argument(a.lobe, s);
  }
}

/// Adds a lamp's light; both numbers are clamped here, after interpolation.
template <class P>
BLYSK_INLINE void add_lamp(const Surface& s, const Lamp& lamp, P cos_l, P lobe, Intensity<P>& sum) {
  const P one(1.0f), zero(0.0f);
  sum.diffuse = plus_scaled(sum.diffuse, lamp.diffuse, min(max(cos_l, zero), one));
  if (s.model == LightingModel::lambert) return;
  const P seen = select(cos_l > zero, min(max(lobe, zero), one), zero);
  sum.specular = plus_scaled(sum.specular, lamp.specular, seen);
}

/// Pixels that are not interpolated.
template <class F, class P, class Y>
__attribute__((noinline)) void light_directly(const ShadeJob& job, const LitTriangle<F>& t,
                                              const ScreenPoint<P>& at, Y y, Intensity<P>& sum) {
  const Surface& s = job.draw->surface;
  Weights<P> w = weights_at(t.corners, at.x, y);
  // Their common factor may be negative.
  const auto sign =
      bits_of((w.of[0] + w.of[1]) + w.of[2]) & Integer<P>(static_cast<std::int32_t>(0x80000000));
  for (P& weight : w.of) weight = float_of_bits(bits_of(weight) ^ sign);
  LampTerms<P> terms;
  light_lamps(job, t, w, at, terms);
  sum = own_intensity<P>(s);
  for (int i = 0; i < s.lamps; ++i) add_lamp(s, s.lamp[i], terms.cos_l[i], terms.lobe[i], sum);
}

/// A sample: weights of the corners on the screen, which sum to 1, and the point they give.
template <class F>
struct Node {
  F weight[3];
  F x, y;
};

template <class F, class P>
BLYSK_INLINE void light_node(const ShadeJob& job, const LitTriangle<F>& t, const Node<P>& node,
                             LampTerms<P>& out) {
  const Corners<F>& c = t.corners;
  Weights<P> w;
  for (int k = 0; k < 3; ++k) w.of[k] = node.weight[k] * P(c.q[k]);
  const P nearness = (node.weight[0] * P(c.nearness[0]) + node.weight[1] * P(c.nearness[1])) +
                     node.weight[2] * P(c.nearness[2]);
  light_lamps(job, t, w, {node.x, node.y, nearness}, out);
}

/// Lights the samples of sixteen triangles, one after the other.
template <int kNodes, int kRegisters>
__attribute__((noinline)) void light_nodes(const ShadeJob& job, const LitTriangle<Floats<kRegisters>>& t,
                                           const Node<Floats<kRegisters>>* nodes,
                                           LampTerms<Floats<kRegisters>>* out) {
  for (int i = 0; i < kNodes; ++i) light_node(job, t, nodes[i], out[i]);
}

/// Lights the samples of one triangle side by side.
template <int kNodes>
__attribute__((noinline)) void light_nodes(const ShadeJob& job, const LitTriangle<float>& t,
                                           const Node<float>* nodes, LampTerms<float>* out) {
  using P = Floats<(kNodes + kPartLanes - 1) / kPartLanes>;
  constexpr int kRoom = static_cast<int>(sizeof(P) / sizeof(float));
  const auto across = [&](auto of) {
    float values[kRoom];
    for (int i = 0; i < kRoom; ++i) values[i] = of(nodes[i < kNodes ? i : 0]);
    P lanes;
    load_all(values, lanes);
    return lanes;
  };
  Node<P> all_nodes;
  for (int k = 0; k < 3; ++k) all_nodes.weight[k] = across([&](const Node<float>& n) { return n.weight[k]; });
  all_nodes.x = across([](const Node<float>& n) { return n.x; });
  all_nodes.y = across([](const Node<float>& n) { return n.y; });
  LampTerms<P> terms;
  light_node(job, t, all_nodes, terms);
  const Surface& s = job.draw->surface;
  for (int lamp = 0; lamp < s.lamps; ++lamp) {
    float cos_l[kRoom], lobe[kRoom];
    store_all(terms.cos_l[lamp], cos_l);
    if (s.model != LightingModel::lambert) store_all(terms.lobe[lamp], lobe);
    for (int i = 0; i < kNodes; ++i) {
      out[i].cos_l[lamp] = cos_l[i];
      if (s.model != LightingModel::lambert) out[i].lobe[lamp] = lobe[i];
    }
  }
}

/// The colour of pixels. `interpolate(sum)` adds the lamps; where `direct` holds, they are lit one by one
/// instead.
template <class F, class P, class Y, class M, class Interpolate>
BLYSK_INLINE Rgb<P> finish(const ShadeJob& job, const LitTriangle<F>& t, M direct, const ScreenPoint<P>& at,
                           Y y, Interpolate interpolate) {
  Intensity<P> sum;
  if (__builtin_expect(all(direct), 0)) {
    light_directly(job, t, at, y, sum);
  } else {
    sum = own_intensity<P>(job.draw->surface);
    interpolate(sum);
    if (any(direct)) {
      Intensity<P> lit;
      light_directly(job, t, at, y, lit);
      sum = {choose(direct, lit.diffuse, sum.diffuse), choose(direct, lit.specular, sum.specular)};
    }
  }
  Weights<P> w{};
  if (job.draw->colors != nullptr) w = weights_at(t.corners, at.x, y);
  return compose(job, t.corners, w, sum);
}

}  // namespace blysk::BLYSK_ISA
