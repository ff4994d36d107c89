// Shading with a second-order surface: the three corners and the middles of the edges are lit, a quadratic
// surface is laid through the six values of N.L and of cos^n of every lamp.
//
// Based on: the shading thesis, chapter 2.1, section 4 of its specification. Differs in: the surface is
// written in the triangle's own coordinates s and v (shading/row.h), in which slender triangles lose no
// digits; the formulas of a row are read as in shading/second_order.h; samples are what Phong shading shows
// at their points, perspective and near lamps included; a triangle of fewer pixels than samples is lit pixel
// by pixel.
#include "shading/lit_triangle.h"
#include "shading/second_order.h"
#include "shading/shade_tile.h"
#include "simd/kernels.h"

namespace blysk::BLYSK_ISA {
namespace {

constexpr int kSurfaceSamples = 6;
// Twice the area of kSurfaceSamples pixels, in subpixels.
constexpr float kDirectArea = 2.0f * kSurfaceSamples * kSubpixels * kSubpixels;

// kUsual: (2.9) without segments, the form that is meant to be fast; the others share one copy.
template <bool kUsual>
struct Quadratic {
  static constexpr int kSpanPixels = 3;

  template <class F>
  struct Triangle {
    LitTriangle<F> lit;
    RowFrame<F> frame;
    decltype(F() < F()) direct;
    SecondOrder<F> cos_l[kMaxLamps], lobe[kMaxLamps];
  };
  template <class F>
  struct Span {
    RowStart<F> row;
    RowEnds<F> ends;
    RowParabola<F> cos_l[kMaxLamps], lobe[kMaxLamps];
  };

  template <class F>
  static BLYSK_INLINE void place_nodes(const RowFrame<F>& f, Node<F> nodes[kSurfaceSamples]) {
    constexpr int kEnds[kSurfaceSamples][2] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}};
    for (int i = 0; i < kSurfaceSamples; ++i) {
      const int a = kEnds[i][0], b = kEnds[i][1];
      for (int k = 0; k < 3; ++k) {
        nodes[i].weight[k] = F((k == a ? 0.5f : 0.0f) + (k == b ? 0.5f : 0.0f));
      }
      nodes[i].x = (f.x[a] + f.x[b]) * F(0.5f);
      nodes[i].y = (f.y[a] + f.y[b]) * F(0.5f);
    }
  }

  template <class F>
  static BLYSK_INLINE Triangle<F> set_up_triangle(const ShadeJob& job, Integer<F> index) {
    Triangle<F> t;
    t.lit = fetch_lit_triangle<F>(job, index);
    t.frame = row_frame(t.lit.corners);
    const F area = float_of_bits(bits_of(t.frame.area) & Integer<F>(0x7fffffff));
    t.direct = t.lit.corners.unplaced | (area < F(kDirectArea));
    if (all(t.direct)) return t;
    Node<F> nodes[kSurfaceSamples];
    place_nodes(t.frame, nodes);
    LampTerms<F> terms[kSurfaceSamples];
    light_nodes<kSurfaceSamples>(job, t.lit, nodes, terms);
    const Surface& s = job.draw->surface;
    for (int lamp = 0; lamp < s.lamps; ++lamp) {
      F values[kSurfaceSamples];
      for (int i = 0; i < kSurfaceSamples; ++i) values[i] = terms[i].cos_l[lamp];
      t.cos_l[lamp] = second_order(values, t.frame.bend);
      if (s.model == LightingModel::lambert) continue;
      for (int i = 0; i < kSurfaceSamples; ++i) values[i] = terms[i].lobe[lamp];
      t.lobe[lamp] = second_order(values, t.frame.bend);
    }
    return t;
  }

  template <class F>
  static BLYSK_INLINE Span<F> set_up_span(const ShadeJob& job, const Triangle<F>& t, F y) {
    Span<F> span;
    span.row = row_start(t.frame, y);
    if (all(t.direct)) return span;
    if constexpr (!kUsual) span.ends = row_ends(t.frame, y);
    const Surface& s = job.draw->surface;
    for (int lamp = 0; lamp < s.lamps; ++lamp) {
      span.cos_l[lamp] = along_row(t.cos_l[lamp], span.row.s);
      if (s.model != LightingModel::lambert) span.lobe[lamp] = along_row(t.lobe[lamp], span.row.s);
    }
    return span;
  }

  template <class F, class P, class Y>
  static BLYSK_INLINE Rgb<P> shade(const ShadeJob& job, const Triangle<F>& t, const Span<F>& span, P x, Y y,
                                   P nearness) {
    const Surface& s = job.draw->surface;
    return finish(job, t.lit, t.direct, ScreenPoint<P>{x, P(y), nearness}, y, [&](Intensity<P>& sum) {
      const FormedRow<F> row{t.frame, span.row, span.ends.first, span.ends.last};
      const auto at = [&](const RowParabola<F>& parabola, const SecondOrder<F>& q) {
        if constexpr (kUsual) return row.template value<RowForm::horner>(q, parabola, x);
        const auto form = static_cast<RowForm>(job.settings[0]);
        return job.settings[1] == 0 ? row.value(form, q, parabola, x)
                                    : row.segment_value(form, job.settings[1], q, parabola, x);
      };
      for (int lamp = 0; lamp < s.lamps; ++lamp) {
        const P cos_l = at(span.cos_l[lamp], t.cos_l[lamp]);
        const P lobe = s.model == LightingModel::lambert ? P(0.0f) : at(span.lobe[lamp], t.lobe[lamp]);
        add_lamp(s, s.lamp[lamp], cos_l, lobe, sum);
      }
    });
  }
};

}  // namespace

void shade_quadratic(const ShadeJob& job) {
  const bool usual = static_cast<RowForm>(job.settings[0]) == RowForm::horner && job.settings[1] == 0;
  if (usual) return shade_draw<Quadratic<true>, ColorSink>(job);
  shade_draw<Quadratic<false>, ColorSink>(job);
}

}  // namespace blysk::BLYSK_ISA
