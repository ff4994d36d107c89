// shading/row_method.h - shading by a law of the normals along a row: the cosines at every pixel follow from
// what the row's ends, and for what is near its middle, give; no pixel has a normal of its own.
//
// Based on: the shading thesis, chapter 3, sections 6 and 7 of its specification. Differs in: directions to
// near lamps and to the viewer change along the row; with perspective, t runs evenly over the row in the
// world. Where a law does not hold, pixels are Phong's own: rows that are short, turn by more than 90
// degrees, show both sides of the surface, or are seen from a lamp or the viewer under too large an angle.
//
// A law is a struct of static templates, as in symmetric_row.h, with turn_along(job, c, direct): what a row
// whose ends are c = |Nb - Na|^2 apart has in common; it sets `direct` where the law does not hold.
// dot_of(job, turn, ends, x) is its dot_along(). kRowSetting is the place of the setting `row`, kEndsSetting
// that of `ends`, -1 if there is none.
#pragma once

#include "shading/corner_light.h"
#include "shading/phong.h"
#include "shading/row.h"
#include "shading/row_edges.h"
#include "shading/row_path.h"
#include "shading/shade_tile.h"

namespace blysk::BLYSK_ISA {

/// The opposite of a comparison: also where something was not a number.
BLYSK_INLINE bool opposite(bool m) { return !m; }
template <int kRegisters>
BLYSK_INLINE Masks<kRegisters> opposite(Masks<kRegisters> m) {
  const Floats<kRegisters> zero(0.0f);
  return and_not(m, zero == zero);
}

/// One lane of a vector in memory, at its own address.
struct Lane {
  float value, rest[kLanes - 1];
  BLYSK_INLINE operator float() const { return value; }  // NOLINT(google-explicit-constructor)
};

template <class Y, class F>
BLYSK_INLINE RowFrame<Y> spread(const RowFrame<F>& f) {
  RowFrame<Y> r;
  for (int k = 0; k < 3; ++k) {
    r.x[k] = Y(f.x[k]);
    r.y[k] = Y(f.y[k]);
  }
  r.area = Y(f.area);
  return r;
}

/// Normals of a row's ends and the way between them, subpixels.
template <class F>
struct LawEnds {
  V3<F> first, last;
  F length;
};

template <class Law>
struct RowMethod {
  /// Sixteen rows of a triangle are set up at once, gathered pixels one by one.
  static constexpr int kSpanPixels = 3;

  template <class F>
  struct LampRow {
    typename Law::template Dot<F> n_l, n_h;
    Parabola<F> l_v;  // of Phong's model, instead of n_h
  };

  /// Of F alone, so that a Span<F32> holds sixteen spans of Lane.
  template <class F>
  struct Span {
    F direct;  // 1: pixels are Phong's
    F first, inverse_length;
    F hurry;  // t on the screen becomes t + hurry t (1 - t) in the world
    typename Law::template Turn<F> turn;
    typename Law::template Dot<F> n_v;  // of Phong's model
    LampRow<F> lamp[kMaxLamps];
  };

  /// Sixteen rows of one triangle, from `base` on. Which they are does not show: they are set up alike.
  /// Copies begin empty.
  template <class F>
  struct Rows {
    static constexpr float kNone = -1e9f;
    float base = kNone;
    Span<F32> of;
    BLYSK_INLINE Rows() {}
    BLYSK_INLINE Rows(const Rows&) {}
    BLYSK_INLINE Rows& operator=(const Rows&) {
      base = kNone;
      return *this;
    }
  };
  template <int kRegisters>
  struct Rows<Floats<kRegisters>> {};

  template <class F>
  struct Triangle {
    Phong::Triangle<F> phong;
    // Of what is not direct.
    RowFrame<F> frame;
    Plane<F> depth;              // 1 over the depth, up to a factor; where perspective counts
    decltype(F() < F()) direct;  // all of its rows
    mutable Rows<F> rows;
  };

  static BLYSK_INLINE bool even_on_screen(const ShadeJob& job) {
    return job.screen_linear || job.rays->orthographic;
  }

  // From the first pixel's centre of the shortest row that is not direct to its last one's.
  static BLYSK_INLINE float shortest(const ShadeJob& job) {
    return static_cast<float>((job.settings[Law::kRowSetting] - 1) * kSubpixels);
  }

  template <class F>
  static BLYSK_INLINE Triangle<F> set_up_triangle(const ShadeJob& job, Integer<F> index) {
    Triangle<F> t;
    t.phong = Phong::set_up_triangle<F>(job, index);
    Corners<F> c = t.phong.corners;
    // The longest row is the area over half the height: if it has too few pixels, all have.
    const F height = max(max(c.y[0], c.y[1]), c.y[2]) - min(min(c.y[0], c.y[1]), c.y[2]);
    const F area = (c.x[1] - c.x[0]) * (c.y[2] - c.y[0]) - (c.x[2] - c.x[0]) * (c.y[1] - c.y[0]);
    t.direct = c.unplaced | (magnitude(area) < height * F(shortest(job)));
    if (all(t.direct)) return t;
    t.depth = even_on_screen(job) ? Plane<F>{} : plane_of(plane_frame(c), c.q);
    sort_corners(c);
    t.frame = row_frame(c);
    return t;
  }

  static BLYSK_INLINE const Span<Lane>& set_up_span(const ShadeJob& job, const Triangle<float>& t, float y) {
    const int row = ((truncate(y) >> kSubpixelBits) - job.y) & (kLanes - 1);
    const float base = y - static_cast<float>(row * kSubpixels);
    if (base != t.rows.base) {
      t.rows.base = base;
      if (t.direct) {
        t.rows.of.direct = F32(1.0f);
      } else {
        const F32 each = F32(base) + to_float(iota(0)) * F32(static_cast<float>(kSubpixels));
        const F32 top(t.frame.y[0]), bottom(t.frame.y[1]);
        set_up_rows(job, t, select((each > top) & (each < bottom), each, F32(y)), t.rows.of);
      }
    }
    return *reinterpret_cast<const Span<Lane>*>(reinterpret_cast<const float*>(&t.rows.of) + row);
  }

  static BLYSK_INLINE Span<F32Wide> set_up_span(const ShadeJob& job, const Triangle<F32Wide>& t, F32Wide y) {
    Span<F32Wide> span;
    span.direct = F32Wide(1.0f);
    if (!all(t.direct)) {
      const Triangle<F32Wide> seldom = t;  // what a call sees is memory: the rest stays in registers
      set_up_rows(job, seldom, y, span);
    }
    return span;
  }

  // The end of a row.
  template <class Y>
  struct End {
    V3<Y> sight;   // towards the viewer, not unit
    V3<Y> normal;  // unit
    Y depth;       // 1 over the depth, up to a factor; constant where perspective does not count
  };

  template <class F, class Y>
  static BLYSK_INLINE End<Y> end_at(const ShadeJob& job, const Triangle<F>& t, Y x, Y y) {
    const Phong::Triangle<F>& p = t.phong;
    const Y over = x - Y(p.normal.x), down = y - Y(p.normal.y);
    const auto at = [&](const Plane<F>& q) __attribute__((always_inline)) {
      return (Y(q.start) + down * Y(q.along_y)) + over * Y(q.along_x);
    };
    End<Y> e;
    e.sight = viewer_at(job, x, y);
    e.normal = made_unit(or_viewer(V3<Y>{at(p.normal.n[0]), at(p.normal.n[1]), at(p.normal.n[2])}, e.sight));
    e.depth = even_on_screen(job) ? Y(1.0f) : at(t.depth);
    return e;
  }

  template <class F, class Y>
  static __attribute__((noinline)) void set_up_rows(const ShadeJob& job, const Triangle<F>& t, Y y,
                                                    Span<Y>& span) {
    using I = Integer<Y>;
    const RowEnds<Y> ends = row_ends(spread<Y>(t.frame), y);
    span.first = to_float(ends.first * I(kSubpixels) + I(kSubpixels / 2));
    const Y length = to_float((ends.last - ends.first) * I(kSubpixels));
    const Y one(1.0f);
    span.inverse_length = one / max(length, one);
    auto direct = length < Y(shortest(job));
    if constexpr (std::is_same_v<F, Y>) direct = direct | t.direct;
    if (!all(direct)) light_row(job, t, y, length, span, direct);
    span.direct = select(direct, one, Y(0.0f));
  }

  template <class F, class Y, class M>
  static BLYSK_INLINE void light_row(const ShadeJob& job, const Triangle<F>& t, Y y, Y length, Span<Y>& span,
                                     M& direct) {
    const Surface& s = job.draw->surface;
    End<Y> a = end_at(job, t, span.first, y), b = end_at(job, t, span.first + length, y);
    if constexpr (Law::kEndsSetting >= 0) {
      if (job.settings[Law::kEndsSetting] == 1) {
        Corners<F> c = t.phong.corners;
        sort_corners(c);
        const auto n = edge_normals(job, c, RowCentres<Y>{y, span.first, span.first + length});
        a.normal = n.first;
        b.normal = n.last;
        direct = direct | n.beyond;
      }
    }
    // Both ends show one side.
    const auto side = side_seen(a.normal, a.sight);
    direct = direct | (side_seen(b.normal, b.sight) != side);
    const auto turned = [&](V3<Y> & n) __attribute__((always_inline)) {
      n = {float_of_bits(bits_of(n.x) ^ side), float_of_bits(bits_of(n.y) ^ side),
           float_of_bits(bits_of(n.z) ^ side)};
    };
    turned(a.normal);
    turned(b.normal);
    const V3<Y> difference = minus(b.normal, a.normal);
    const Y c = dot(difference, difference);
    span.turn = Law::turn_along(job, c, direct);

    const Y half(0.5f), share = Y(1.0f) / (a.depth + b.depth);
    // With perspective t is 0.024 hurry^2 off at most: times the turn and the lobe's slope, one of 255 steps.
    const Y power(max(s.shininess, 4.0f));
    span.hurry = Y(2.0f) * (b.depth - a.depth) * share;
    const Y square = span.hurry * span.hurry;
    direct = direct | opposite(c * (square * square) * power <= Y(0.07f));
    // A path that turns by d is 0.008 d^3 off half-way to the viewer: one step of 255 at 0.6 sqrt(n).
    const auto too_near = [&](const Path<Y>& p) __attribute__((always_inline)) {
      const Y turn = squared_turn(p);
      return (turn * turn) * turn * power > Y(0.65f);
    };
    Path<Y> v{made_unit(a.sight), {}, {}, job.rays->orthographic};
    // The middle of the row in the world.
    const V3<Y> sight = viewer_at(job, span.first + length * (a.depth * share), y);
    if (!v.far) {
      v.middle = made_unit(sight);
      v.last = made_unit(b.sight);
      direct = direct | too_near(v);
    }
    const LawEnds<Y> ends = {a.normal, b.normal, length};
    if (s.model == LightingModel::phong) span.n_v = Law::dot_of(job, span.turn, ends, v);
    V3<Y> from[2] = {};
    for (int i = 0; i < s.lamps; ++i) {
      if (!s.lamp[i].point) continue;
      from[0] = world_at(job, t, span.first, y);
      from[1] = world_at(job, t, span.first + length, y);
      break;
    }
    for (int i = 0; i < s.lamps; ++i) {
      const Lamp& lamp = s.lamp[i];
      const V3<Y> at = {Y(lamp.vector[0]), Y(lamp.vector[1]), Y(lamp.vector[2])};
      Path<Y> l{at, at, at, !lamp.point};
      if (lamp.point) {
        l = {made_unit(minus(at, from[0])), made_unit(minus(at, scaled(plus(from[0], from[1]), half))),
             made_unit(minus(at, from[1])), false};
        direct = direct | too_near(l);
      }
      light_lamp(job, ends, v, l, span, span.lamp[i]);
    }
  }

  template <class F, class Y>
  static BLYSK_INLINE V3<Y> world_at(const ShadeJob& job, const Triangle<F>& t, Y x, Y y) {
    V3<F> p[3];
    for (int k = 0; k < 3; ++k) p[k] = world_position<F>(job, t.phong.corners.vertex[k]);
    const Weights<Y> w = weights_at(t.phong.corners, x, y);
    return scaled(mix(w, p[0], p[1], p[2]), inverse_sum(w));
  }

  template <class Y>
  static BLYSK_INLINE void light_lamp(const ShadeJob& job, const LawEnds<Y>& ends, const Path<Y>& v,
                                      const Path<Y>& l, const Span<Y>& span, LampRow<Y>& lamp) {
    const Surface& s = job.draw->surface;
    lamp.n_l = Law::dot_of(job, span.turn, ends, l);
    const V3<Y>& v_middle = v.far ? v.first : v.middle;
    const V3<Y>& v_last = v.far ? v.first : v.last;
    if (s.model == LightingModel::phong) {
      lamp.l_v = parabola(dot(l.first, v.first), dot(l.middle, v_middle), dot(l.last, v_last));
    } else if (s.model == LightingModel::blinn) {
      Path<Y> h{made_unit(plus(l.first, v.first)), {}, {}, v.far && l.far};
      if (!h.far) {
        h.middle = made_unit(plus(l.middle, v_middle));
        h.last = made_unit(plus(l.last, v_last));
      }
      lamp.n_h = Law::dot_of(job, span.turn, ends, h);
    }
  }

  template <class F, class P>
  static BLYSK_INLINE Intensity<P> light(const ShadeJob& job, const Span<F>& span, P x) {
    const P zero(0.0f), one(1.0f);
    // A point outside its row is lit as the row's end.
    P along = min(max((x - P(span.first)) * P(span.inverse_length), zero), one);
    P z = along - along * along;
    if (!even_on_screen(job)) {
      along = along + P(span.hurry) * z;
      z = along - along * along;
    }
    const auto point = Law::point(job, span.turn, RowPoint<P>{along, z});
    const Surface& s = job.draw->surface;
    const bool far_viewer = job.rays->orthographic;
    P n_v(0.0f);
    if (s.model == LightingModel::phong) n_v = Law::cosine(span.n_v, point, far_viewer);
    Intensity<P> sum = own_intensity<P>(s);
    for (int i = 0; i < s.lamps; ++i) {
      const LampRow<F>& row = span.lamp[i];
      const bool far = !s.lamp[i].point;
      const P n_l = min(Law::cosine(row.n_l, point, far), one);
      sum.diffuse = plus_scaled(sum.diffuse, s.lamp[i].diffuse, max(n_l, zero));
      if (s.model == LightingModel::lambert) continue;
      P c = s.model == LightingModel::blinn ? Law::cosine(row.n_h, point, far && far_viewer)
                                            : P(2.0f) * n_l * n_v - value(row.l_v, point.at);
      c = min(max(c, zero), one);
      const P lobe = select(n_l > zero, lobe_of_cosine(c, s), zero);
      sum.specular = plus_scaled(sum.specular, s.lamp[i].specular, lobe);
    }
    return sum;
  }

  template <class F, class G, class P, class Y>
  static BLYSK_INLINE Rgb<P> shade(const ShadeJob& job, const Triangle<F>& t, const Span<G>& span, P x, Y y,
                                   P nearness) {
    const auto direct = F(span.direct) > F(0.0f);
    if (all(direct)) return phong(job, t.phong, x, y, nearness);
    const Rgb<P> c = compose(job, t.phong.corners, x, y, light(job, span, x));
    if (!any(direct)) return c;
    const Phong::Triangle<F> seldom = t.phong;
    return choose(direct, phong_among_others(job, seldom, x, y, nearness), c);
  }

  template <class F, class P, class Y>
  static BLYSK_INLINE Rgb<P> phong(const ShadeJob& job, const Phong::Triangle<F>& t, P x, Y y, P nearness) {
    return Phong::shade(job, t, Phong::set_up_span(job, t, y), x, y, nearness);
  }

  template <class F, class P, class Y>
  static __attribute__((noinline)) Rgb<P> phong_among_others(const ShadeJob& job, const Phong::Triangle<F>& t,
                                                             P x, Y y, P nearness) {
    return phong(job, t, x, y, nearness);
  }
};

}  // namespace blysk::BLYSK_ISA
