// shading/row_method.h - shading by a law of the normals along a row: the cosines at every pixel follow from
// what the row's ends, and for what is near its middle, give; no pixel has a normal of its own.
//
// Based on: the shading thesis, chapter 3, sections 6 and 7 of its specification. Differs in: directions to
// near lamps and to the viewer change along the row; with perspective, t runs evenly over the row in the
// world. Where a law does not hold, pixels are lit one by one: rows that are short, turn by more than 90
// degrees, or are seen from a lamp or the viewer under too large an angle.
//
// A law is a struct of static templates, as in symmetric_row.h, and turn_along(job, c, direct): what a row
// whose ends are c = |Nb - Na|^2 apart has in common; it sets `direct` where the law does not hold.
#pragma once

#include "shading/lit_triangle.h"
#include "shading/row_path.h"
#include "shading/shade_tile.h"

namespace blysk::BLYSK_ISA {

/// The settings that methods by rows share, by their index.
inline constexpr int kRowPixelsSetting = 1;

/// The end of a row, or its middle: a point of the triangle.
template <class F>
struct RowNode {
  Weights<F> w;  // of positive sum
  F depth;       // their sum: 1 over the depth, up to a factor; 1 where perspective does not count
  ScreenPoint<F> at;
};

template <class F, class Y>
BLYSK_INLINE RowNode<Y> row_node(const Corners<F>& c, const RowFrame<Y>& f, const RowStart<Y>& row, Y x,
                                 Y y) {
  const Y v = right_of(f, row, x) * f.over;
  const Y u = row.s - f.bend * v;
  const Y weight[3] = {(Y(1.0f) - u) - v, u, v};
  RowNode<Y> node;
  node.at = {x, y, Y(0.0f)};
  for (int k = 0; k < 3; ++k) {
    node.w.of[k] = weight[k] * Y(c.q[k]);
    node.at.nearness = node.at.nearness + weight[k] * Y(c.nearness[k]);
  }
  node.depth = (node.w.of[0] + node.w.of[1]) + node.w.of[2];
  return node;
}

template <class Y, class F>
BLYSK_INLINE RowFrame<Y> spread(const RowFrame<F>& f) {
  RowFrame<Y> r;
  for (int k = 0; k < 3; ++k) {
    r.x[k] = Y(f.x[k]);
    r.y[k] = Y(f.y[k]);
  }
  r.area = Y(f.area);
  r.inverse_height = Y(f.inverse_height);
  r.slope = Y(f.slope);
  r.bend = Y(f.bend);
  r.over = Y(f.over);
  return r;
}

template <class Law>
struct RowMethod {
  template <class F>
  struct LampRow {
    typename Law::template Dot<F> n_l, n_h;
    Parabola<F> l_v;  // of Phong's model, instead of n_h
  };

  /// Of F alone: a row of sixteen is taken out as floats.
  template <class F>
  struct Span {
    F direct;  // 1: pixels are lit one by one
    F first, inverse_length;
    F hurry;  // t on the screen becomes t + hurry t (1 - t) in the world
    typename Law::template Turn<F> turn;
    typename Law::template Dot<F> n_v;  // of Phong's model
    LampRow<F> lamp[kMaxLamps];
  };

  template <class F>
  struct Triangle {
    LitTriangle<F> lit;
    RowFrame<F> frame;
    decltype(F() < F()) direct;
    // Sixteen rows of one triangle, from `base` on. Which they are does not show: they are set up alike.
    struct Rows {
      float base;
      Span<F32> of;
    };
    struct Nothing {};
    mutable std::conditional_t<std::is_same_v<F, float>, Rows, Nothing> rows;
  };

  static BLYSK_INLINE bool even_on_screen(const ShadeJob& job) {
    return job.screen_linear || job.rays->orthographic;
  }

  template <class F>
  static BLYSK_INLINE Triangle<F> set_up_triangle(const ShadeJob& job, Integer<F> index) {
    Triangle<F> t;
    t.lit = fetch_lit_triangle<F>(job, index);
    t.frame = row_frame(t.lit.corners);
    // The longest row is the area over half the height: if it has too few pixels, all have.
    const F longest = magnitude(t.frame.area) * t.frame.inverse_height;
    t.direct = t.lit.corners.unplaced |
               (longest < F(static_cast<float>((job.settings[kRowPixelsSetting] - 1) * kSubpixels)));
    if constexpr (std::is_same_v<F, float>) t.rows.base = -1e9f;
    return t;
  }

  static BLYSK_INLINE Span<float> set_up_span(const ShadeJob& job, const Triangle<float>& t, float y) {
    Span<float> span;
    span.direct = 1.0f;
    if (t.direct) return span;
    const int row = ((truncate(y) >> kSubpixelBits) - job.y) & (kLanes - 1);
    const float base = y - static_cast<float>(row * kSubpixels);
    if (base != t.rows.base) {
      const F32 all = F32(base) + to_float(iota(0)) * F32(static_cast<float>(kSubpixels));
      const F32 top(t.frame.y[0]), bottom(t.frame.y[1]);
      set_up_rows(job, t, select((all > top) & (all < bottom), all, F32(y)), t.rows.of);
      t.rows.base = base;
    }
    const std::size_t floats =
        (offsetof(Span<float>, lamp) + sizeof(LampRow<float>) * static_cast<std::size_t>(job.draw->surface.lamps)) /
        sizeof(float);
    const auto* from = reinterpret_cast<const char*>(&t.rows.of) + static_cast<std::size_t>(row) * sizeof(float);
    auto* to = reinterpret_cast<char*>(&span);
    for (std::size_t i = 0; i < floats; ++i) {
      std::memcpy(to + i * sizeof(float), from + i * sizeof(F32), sizeof(float));
    }
    return span;
  }

  static BLYSK_INLINE Span<F32Wide> set_up_span(const ShadeJob& job, const Triangle<F32Wide>& t, F32Wide y) {
    Span<F32Wide> span;
    span.direct = F32Wide(1.0f);
    if (!all(t.direct)) set_up_rows(job, t, y, span);
    return span;
  }

  template <class F, class Y>
  static __attribute__((noinline)) void set_up_rows(const ShadeJob& job, const Triangle<F>& t, Y y,
                                                    Span<Y>& span) {
    using I = Integer<Y>;
    const RowFrame<Y> f = spread<Y>(t.frame);
    const RowEnds<Y> ends = row_ends(f, y);
    span.first = to_float(ends.first * I(kSubpixels) + I(kSubpixels / 2));
    const Y length = to_float((ends.last - ends.first) * I(kSubpixels));
    const Y subpixel(1.0f);
    span.inverse_length = subpixel / max(length, subpixel);
    auto direct = length < Y(static_cast<float>((job.settings[kRowPixelsSetting] - 1) * kSubpixels));
    if constexpr (std::is_same_v<F, Y>) direct = direct | t.direct;
    if (!all(direct)) {
      const RowStart<Y> row = row_start(f, y);
      RowNode<Y> node[3] = {row_node(t.lit.corners, f, row, span.first, y), {},
                            row_node(t.lit.corners, f, row, span.first + length, y)};
      const Y depths = node[0].depth + node[2].depth;
      const Y share = subpixel / depths;
      span.hurry = Y(2.0f) * (node[2].depth - node[0].depth) * share;
      // The middle in the world.
      node[1] = row_node(t.lit.corners, f, row, span.first + length * (node[0].depth * share), y);
      light_row(job, t, node, span, direct);
    }
    span.direct = select(direct, subpixel, Y(0.0f));
  }

  template <class F, class Y, class M>
  static BLYSK_INLINE void light_row(const ShadeJob& job, const Triangle<F>& t, const RowNode<Y> node[3],
                                     Span<Y>& span, M& direct) {
    const Surface& s = job.draw->surface;
    V3<Y> sight[3];
    for (int i = 0; i < 3; ++i) sight[i] = viewer_at(job, node[i].at.x, node[i].at.y);
    const auto normal = [&](int i) {
      return made_unit(
          or_viewer(mix(node[i].w, t.lit.normal[0], t.lit.normal[1], t.lit.normal[2]), sight[i]));
    };
    const V3<Y> na = normal(0), nb = normal(2);
    const V3<Y> difference = minus(nb, na);
    const Y c = dot(difference, difference);
    span.turn = Law::turn_along(job, c, direct);
    // With perspective t is 0.024 hurry^2 off at most: times the turn and the lobe's slope, one of 255 steps.
    const Y power(max(s.shininess, 4.0f));
    const Y square = span.hurry * span.hurry;
    direct = direct | (c * (square * square) * power > Y(0.07f));

    // A path that turns by d is 0.008 d^3 off half-way to the viewer: one step of 255 at 0.6 sqrt(n).
    const auto too_near = [&](const Path<Y>& p) {
      const Y turn = squared_turn(p);
      return (turn * turn) * turn * power > Y(0.28f);
    };
    Path<Y> v{made_unit(sight[0]), {}, {}, job.rays->orthographic};
    if (!v.far) {
      v.middle = made_unit(sight[1]);
      v.last = made_unit(sight[2]);
      direct = direct | too_near(v);
    }
    if (s.model == LightingModel::phong) span.n_v = Law::dot_along(span.turn, na, nb, v);
    for (int i = 0; i < s.lamps; ++i) {
      const Lamp& lamp = s.lamp[i];
      const V3<Y> at = {Y(lamp.vector[0]), Y(lamp.vector[1]), Y(lamp.vector[2])};
      Path<Y> l{at, at, at, !lamp.point};
      if (lamp.point) {
        const auto to_lamp = [&](int k) {
          const ScreenPoint<Y>& p = node[k].at;
          return made_unit(minus(at, point_at(job, p.x, p.y, p.nearness, sight[k])));
        };
        l = {to_lamp(0), to_lamp(1), to_lamp(2), false};
        direct = direct | too_near(l);
      }
      span.lamp[i].n_l = Law::dot_along(span.turn, na, nb, l);
      if (s.model == LightingModel::phong) {
        span.lamp[i].l_v = v.far && l.far ? Parabola<Y>{dot(l.first, v.first), Y(0.0f), Y(0.0f)}
                                          : along(l, v);
      } else if (s.model == LightingModel::blinn) {
        Path<Y> h{made_unit(plus(l.first, v.first)), {}, {}, v.far && l.far};
        if (!h.far) {
          const bool still = v.far;
          h.middle = made_unit(plus(l.middle, still ? v.first : v.middle));
          h.last = made_unit(plus(l.last, still ? v.first : v.last));
        }
        span.lamp[i].n_h = Law::dot_along(span.turn, na, nb, h);
      }
    }
  }

  template <class Y>
  static BLYSK_INLINE Parabola<Y> along(const Path<Y>& l, const Path<Y>& v) {
    return parabola(dot(l.first, v.first), dot(l.middle, v.far ? v.first : v.middle),
                    dot(l.last, v.far ? v.first : v.last));
  }

  template <class F, class P, class Y>
  static BLYSK_INLINE Rgb<P> shade(const ShadeJob& job, const Triangle<F>& t, const Span<F>& span, P x, Y y,
                                   P nearness) {
    const auto direct = span.direct > F(0.0f);
    return finish(job, t.lit, direct, ScreenPoint<P>{x, P(y), nearness}, y, [&](Intensity<P>& sum) {
      const P zero(0.0f), one(1.0f);
      // A point outside its row is lit as the row's end.
      P along = min(max((x - P(span.first)) * P(span.inverse_length), zero), one);
      P z = along - along * along;
      if (!even_on_screen(job)) {
        along = along + P(span.hurry) * z;
        z = along - along * along;
      }
      const auto point = Law::point(span.turn, RowPoint<P>{along, z});
      const Surface& s = job.draw->surface;
      const bool far_viewer = job.rays->orthographic;
      P n_v(0.0f);
      if (s.model == LightingModel::phong) n_v = Law::cosine(span.n_v, point, far_viewer);
      for (int i = 0; i < s.lamps; ++i) {
        const LampRow<F>& lamp = span.lamp[i];
        const bool far = !s.lamp[i].point;
        const P n_l = Law::cosine(lamp.n_l, point, far);
        P c = zero;
        if (s.model == LightingModel::blinn) {
          c = Law::cosine(lamp.n_h, point, far && far_viewer);
        } else if (s.model == LightingModel::phong) {
          c = P(2.0f) * n_l * n_v - value(lamp.l_v, point.at);
        }
        c = min(max(c, zero), one);
        const P lobe = s.model == LightingModel::lambert ? zero : specular_lobe(c * c, s);
        add_lamp(s, s.lamp[i], n_l, lobe, sum);
      }
    });
  }
};

}  // namespace blysk::BLYSK_ISA
