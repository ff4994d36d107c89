// Shading with a cubic polynomial on each row: four points of the row are lit, a cubic is laid through the
// four values of N.L and of cos^n of every lamp.
//
// Based on: the shading thesis, chapter 2.2, section 5 of its specification; the robust form of the
// coefficients (5.2) unless the printed one is asked for. Differs in: samples are what Phong shading shows at
// their points, perspective and near lamps included; rows of up to four pixels are lit pixel by pixel.
#include "shading/lit_triangle.h"
#include "shading/shade_tile.h"
#include "simd/kernels.h"

namespace blysk::BLYSK_ISA {
namespace {

constexpr int kRowSamples = 4;
constexpr float kPlaces[kRowSamples] = {0.0f, 1.0f, 0.5f, 0.25f};  // the thesis' I1, I2, I3, I4

template <class F>
struct CubicRow {
  F a, b, c, d;  // ((a p + b) p + c) p + d
};

// How a third is taken: divided by 3, 1/2 - 1/8 - 1/32 - 1/128, the same in the formulas as printed.
enum class Third { exact, shift, printed };

template <class F>
BLYSK_INLINE CubicRow<F> fit(Third how, const F i[kRowSamples]) {
  const F three(3.0f), four(4.0f), eight(8.0f);
  const F third(how == Third::exact ? 1.0f / 3.0f : 43.0f / 128.0f);
  CubicRow<F> q;
  q.d = i[0];
  if (how == Third::printed) {
    q.a = eight * (i[1] + eight * i[3]) * third - eight * (i[0] + F(2.0f) * i[2]);
    q.b = F(2.0f) * (((F(7.0f) * i[0] - i[1]) + F(10.0f) * i[2]) - F(16.0f) * i[3]);
    q.c = ((i[1] + F(32.0f) * i[3]) * third - F(7.0f) * i[0]) - four * i[2];
    return q;
  }
  // The third difference: 0 for any parabola, so that a constant stays constant.
  const F difference = ((i[1] - three * i[0]) - F(6.0f) * i[2]) + eight * i[3];
  const F u = difference * third;
  q.a = eight * u;
  q.c = u + F(2.0f) * ((four * i[3] - three * i[0]) - i[2]);
  q.b = ((i[1] - i[0]) - q.a) - q.c;
  return q;
}

struct Cubic {
  static constexpr int kSpanPixels = 3;

  template <class F>
  struct Triangle {
    LitTriangle<F> lit;
    RowFrame<F> frame;
  };
  template <class F>
  struct Span {
    decltype(F() < F()) direct;
    F first, inverse_length;  // subpixels: centre of the first pixel, from there to the last
    CubicRow<F> cos_l[kMaxLamps], lobe[kMaxLamps];
  };

  template <class F>
  static BLYSK_INLINE Triangle<F> set_up_triangle(const ShadeJob& job, Integer<F> index) {
    Triangle<F> t;
    t.lit = fetch_lit_triangle<F>(job, index);
    t.frame = row_frame(t.lit.corners);
    return t;
  }

  // Points of a row, evenly spaced in x.
  template <class F>
  static BLYSK_INLINE void place_nodes(const RowFrame<F>& f, const Span<F>& span, F y, F length,
                                       Node<F> nodes[kRowSamples]) {
    const RowStart<F> row = row_start(f, y);
    for (int i = 0; i < kRowSamples; ++i) {
      nodes[i].x = span.first + F(kPlaces[i]) * length;
      nodes[i].y = y;
      const F v = right_of(f, row, nodes[i].x) * f.over;
      const F u = row.s - f.bend * v;
      nodes[i].weight[0] = (F(1.0f) - u) - v;
      nodes[i].weight[1] = u;
      nodes[i].weight[2] = v;
    }
  }

  template <class F>
  static BLYSK_INLINE Span<F> set_up_span(const ShadeJob& job, const Triangle<F>& t, F y) {
    Span<F> span;
    span.direct = t.lit.corners.unplaced;
    if (all(span.direct)) return span;
    const RowEnds<F> ends = row_ends(t.frame, y);
    span.first = to_float(ends.first * Integer<F>(kSubpixels) + Integer<F>(kSubpixels / 2));
    const F length = to_float((ends.last - ends.first) * Integer<F>(kSubpixels));
    span.inverse_length = F(1.0f) / length;
    span.direct = span.direct | (length < F(kRowSamples * kSubpixels));
    if (all(span.direct)) return span;

    Node<F> nodes[kRowSamples];
    place_nodes(t.frame, span, y, length, nodes);
    LampTerms<F> terms[kRowSamples];
    light_nodes<kRowSamples>(job, t.lit, nodes, terms);
    const Surface& s = job.draw->surface;
    const auto third = static_cast<Third>(job.settings[0]);
    for (int lamp = 0; lamp < s.lamps; ++lamp) {
      F values[kRowSamples];
      for (int i = 0; i < kRowSamples; ++i) values[i] = terms[i].cos_l[lamp];
      span.cos_l[lamp] = fit(third, values);
      if (s.model == LightingModel::lambert) continue;
      for (int i = 0; i < kRowSamples; ++i) values[i] = terms[i].lobe[lamp];
      span.lobe[lamp] = fit(third, values);
    }
    return span;
  }

  template <class F, class P, class Y>
  static BLYSK_INLINE Rgb<P> shade(const ShadeJob& job, const Triangle<F>& t, const Span<F>& span, P x, Y y,
                                   P nearness) {
    const Surface& s = job.draw->surface;
    return finish(job, t.lit, span.direct, ScreenPoint<P>{x, P(y), nearness}, y, [&](Intensity<P>& sum) {
      const P p = (x - P(span.first)) * P(span.inverse_length);
      const auto at = [&](const CubicRow<F>& q) { return P(q.d) + p * (P(q.c) + p * (P(q.b) + p * P(q.a))); };
      for (int lamp = 0; lamp < s.lamps; ++lamp) {
        const P cos_l = at(span.cos_l[lamp]);
        const P lobe = s.model == LightingModel::lambert ? P(0.0f) : at(span.lobe[lamp]);
        add_lamp(s, s.lamp[lamp], cos_l, lobe, sum);
      }
    });
  }
};

}  // namespace

void shade_cubic(const ShadeJob& job) { shade_draw<Cubic, ColorSink>(job); }

}  // namespace blysk::BLYSK_ISA
