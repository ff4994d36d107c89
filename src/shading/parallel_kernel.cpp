// Normals of a row from those of its ends alone, at equal angles and nearly unit: nothing is made unit pixel
// by pixel, and no pixel waits for another.
//
// Based on: per-fragment paper, (1) - (14); A-buffer specification, C.1 - C.4. Differs in: rows of any length
// by one polynomial of the place between the ends (ArcFit); the paper's rows of nine pixels start at the
// row's first pixel and every eighth from there, where the normal is Phong's made unit. Between the ends
// perspective does not count. Ends more than 90 degrees apart are halved, and where they are nearly opposite
// normals are linear and made unit.
#include "shading/arc.h"
#include "shading/mixed_normals.h"
#include "shading/shade_tile.h"
#include "simd/kernels.h"

namespace blysk::BLYSK_ISA {
namespace {

// Where the ends say nothing of what is between them: nearly opposite, or a triangle without rows.
template <class P, class F, class Y>
BLYSK_INLINE V3<P> or_linear(const ShadeJob& job, const MixedNormals<F>& t, const V3<P>& n, P d, P x, Y y) {
  const auto lost = d < P(static_cast<float>(kLowestArc));
  if (!any(lost)) return n;
  const V3<P> linear = unit_normal_at(job, t, x, y);
  return {select(lost, linear.x, n.x), select(lost, linear.y, n.y), select(lost, linear.z, n.z)};
}

template <class F>
BLYSK_INLINE F highest_cosine(const Corners<F>& c) {
  return select(c.unplaced, F(-1.0f), F(1.0f));
}

struct Row {
  template <class F>
  using Triangle = MixedNormals<F>;
  template <class F>
  struct Span {
    V3<F> first_normal, last_normal;
    F d;
    bool acute;
    F first, scale;  // t = (x - first) * scale - 1
    Arc<F> arc;
  };

  template <class F>
  static BLYSK_INLINE Triangle<F> set_up_triangle(const ShadeJob& job, Integer<F> index) {
    return fetch_mixed_normals<F>(job, index);
  }

  template <class F>
  static BLYSK_INLINE Span<F> set_up_span(const ShadeJob& job, const Triangle<F>& t, F y) {
    Span<F> s;
    const RowCenters<F> row = row_centers(t.frame, y);
    s.first = row.first;
    s.scale = F(2.0f) / max(row.last - row.first, F(static_cast<float>(kSubpixels)));
    s.first_normal = unit_normal_at(job, t, row.first, y);
    s.last_normal = unit_normal_at(job, t, row.last, y);
    s.d = min(dot(s.first_normal, s.last_normal), highest_cosine(t.corners));
    s.acute = !any(s.d < F(0.0f));
    s.arc = arc_between(s.first_normal, s.last_normal, s.d);
    return s;
  }

  template <class F, class P, class Y>
  static BLYSK_INLINE Rgb<P> shade(const ShadeJob& job, const Triangle<F>& t, const Span<F>& s, P x, Y y,
                                   P nearness) {
    const P one(1.0f);
    const P place = min(max((x - P(s.first)) * P(s.scale) - one, P(-1.0f)), one);
    V3<P> n = along(s.arc, place);
    if (__builtin_expect(!s.acute, 0)) {
      const auto lanes = [](const V3<F>& v) { return V3<P>{P(v.x), P(v.y), P(v.z)}; };
      n = along_any(lanes(s.first_normal), lanes(s.last_normal), P(s.d), place);
      n = or_linear(job, t, n, P(s.d), x, y);
    }
    return light_unit(job, t, n, x, y, nearness);
  }
};

// A pixel's place in its row of nine.
template <class P>
struct Place9 {
  P d;           // of the ends
  Integer<P> k;  // 0..7
};

template <const ChebyshevRow& kRow, class P>
BLYSK_INLINE V3<P> at_place(const V3<P>& a, const V3<P>& b, const Place9<P>& at) {
  constexpr auto cq = [](int i) { return static_cast<float>(kRow.c[i]); };
  constexpr auto gq = [](int i) { return static_cast<float>(kRow.g[i]); };
  const P one(1.0f), d = at.d;
  P c = (P(cq(2)) * d + P(cq(1))) * d + P(cq(0));
  if (kRow.from_one) c = one - (one - d) * c;
  const P e = kRow.from_one ? one - c : c;
  const P g = ((P(gq(3)) * e + P(gq(2))) * e + P(gq(1))) * e + P(gq(0));
  // N_(k+1) = u N_2 - before N_1 with u, before = U_(k-1), U_(k-2).
  P u(0.0f), before(-1.0f);
  for (int i = 0; i < 7; ++i) {
    const auto on = at.k > Integer<P>(i);
    const P next = (c + c) * u - before;
    before = select(on, u, before);
    u = select(on, next, u);
  }
  const P of_a = (c - d * g) * u - before, of_b = g * u;
  return {a.x * of_a + b.x * of_b, a.y * of_a + b.y * of_b, a.z * of_a + b.z * of_b};
}

template <const RowWeights& kWeights, class P>
BLYSK_INLINE V3<P> at_place(const V3<P>& a, const V3<P>& b, const Place9<P>& at) {
  static constexpr auto kTable = [] {
    struct {
      float q[9 * 4];
    } table{};
    for (int k = 0; k <= 8; ++k) {
      table.q[4 * k] = static_cast<float>(k) / 8;
      for (int i = 0; i < 3 && k > 0 && k < 8; ++i)
        table.q[4 * k + 1 + i] = static_cast<float>(kWeights[k - 1][i]);
    }
    return table;
  }();
  const auto weight = [&](Integer<P> k) {
    P q[4];
    fetch_row<4>(kTable.q, k, q);
    return q[0] + (P(1.0f) - at.d) * (q[1] + at.d * (q[2] + at.d * q[3]));
  };
  const P of_a = weight(Integer<P>(8) - at.k), of_b = weight(at.k);
  return {a.x * of_a + b.x * of_b, a.y * of_a + b.y * of_b, a.z * of_a + b.z * of_b};
}

// kFit is a ChebyshevRow or RowWeights.
template <const auto& kFit>
struct Nines {
  template <class F>
  using Triangle = MixedNormals<F>;
  template <class F>
  using Span = RowCenters<F>;

  template <class F>
  static BLYSK_INLINE Triangle<F> set_up_triangle(const ShadeJob& job, Integer<F> index) {
    return fetch_mixed_normals<F>(job, index);
  }

  template <class F>
  static BLYSK_INLINE Span<F> set_up_span(const ShadeJob&, const Triangle<F>& t, F y) {
    return row_centers(t.frame, y);
  }

  template <class F, class P, class Y>
  static BLYSK_INLINE Rgb<P> shade(const ShadeJob& job, const Triangle<F>& t, const Span<F>& s, P x, Y y,
                                   P nearness) {
    using I = Integer<P>;
    const P pixel(static_cast<float>(kSubpixels));
    const I last = truncate((P(s.last) - P(s.first)) * P(1.0f / kSubpixels));
    const P from_first = max((x - P(s.first)) * P(1.0f / kSubpixels), P(0.0f));
    const I column = min(truncate(from_first + P(0.5f)), last);
    const I start = shift_left<3>(shift_right<3>(column)), steps = min(last - start, I(8));
    const P x0 = P(s.first) + to_float(start) * pixel;
    const V3<P> a = unit_normal_at(job, t, x0, y);
    const V3<P> b = unit_normal_at(job, t, x0 + to_float(steps) * pixel, y);
    const P d = min(dot(a, b), P(highest_cosine(t.corners)));
    const I k = column - start;
    V3<P> n = at_place<kFit>(a, b, Place9<P>{d, k});
    const auto other = (steps < I(8)) | (d < P(0.0f));
    if (any(other)) {
      const P place = to_float(k + k) / max(to_float(steps), P(1.0f)) - P(1.0f);
      const V3<P> arc = or_linear(job, t, along_any(a, b, d, place), d, x, y);
      n = {select(other, arc.x, n.x), select(other, arc.y, n.y), select(other, arc.z, n.z)};
    }
    return light_unit(job, t, n, x, y, nearness);
  }
};

}  // namespace

void shade_parallel(const ShadeJob& job) {
  enum class Fit { row, paper, quadratic, cubic, weights };
  switch (static_cast<Fit>(job.settings[0])) {
    case Fit::row:
      return shade_draw<Row, ColorSink>(job);
    case Fit::paper:
      return shade_draw<Nines<kChebyshevPaper>, ColorSink>(job);
    case Fit::quadratic:
      return shade_draw<Nines<kChebyshevQuadratic>, ColorSink>(job);
    case Fit::cubic:
      return shade_draw<Nines<kChebyshevCubic>, ColorSink>(job);
    case Fit::weights:
      return shade_draw<Nines<kRowWeightsCubic>, ColorSink>(job);
  }
}

}  // namespace blysk::BLYSK_ISA
