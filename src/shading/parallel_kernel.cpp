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

enum class Fit { row, paper, quadratic, cubic, weights };

BLYSK_INLINE Fit fit_of(const ShadeJob& job) { return static_cast<Fit>(job.settings[0]); }

// Whole rows.
struct Row {
  template <class F>
  struct Span {
    NormalRow<F> row;
    V3<F> first_normal, last_normal;
    F d;
    decltype(F() < F()) own;  // pixels have their own normals: a short row, or opposite ends
    bool acute;
    F scale;  // t = (x - first) * scale - 1
    Arc<F> arc;
  };

  template <class F>
  static BLYSK_INLINE void set_up(const ShadeJob& job, const MixedNormals<F>& t, F y, Span<F>& s) {
    const F length = s.row.last - s.row.first;
    s.own = length < F(static_cast<float>((kShortestArc - 1) * kSubpixels));
    s.acute = true;
    if (all(s.own)) return;
    s.scale = F(2.0f) / max(length, F(static_cast<float>(kSubpixels)));
    s.first_normal = unit_normal_at(job, t, s.row, s.row.first, y);
    s.last_normal = unit_normal_at(job, t, s.row, s.row.last, y);
    s.d = min(dot(s.first_normal, s.last_normal), F(1.0f));
    s.own = s.own | (s.d < F(static_cast<float>(kLowestArc)));
    s.acute = !any(s.d < F(0.0f));
    s.arc = arc_between(s.first_normal, s.last_normal, s.d);
  }

  template <class F, class P, class Y>
  static BLYSK_INLINE V3<P> normal_at(const ShadeJob& job, const MixedNormals<F>& t, const Span<F>& s, P x,
                                      Y y) {
    if (all(s.own)) return unit_normal_at(job, t, s.row, x, y);
    const P one(1.0f);
    const P place = min(max((x - P(s.row.first)) * P(s.scale) - one, P(-1.0f)), one);
    V3<P> n = along(s.arc, place);
    if (__builtin_expect(!s.acute, 0)) {
      const auto lanes = [](const V3<F>& v) { return V3<P>{P(v.x), P(v.y), P(v.z)}; };
      n = along_any(lanes(s.first_normal), lanes(s.last_normal), P(s.d), place);
    }
    if (any(s.own)) n = choose(s.own, unit_normal_at(job, t, s.row, x, y), n);
    return n;
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

template <class P>
BLYSK_INLINE V3<P> at_place(Fit fit, const V3<P>& a, const V3<P>& b, const Place9<P>& at) {
  switch (fit) {
    case Fit::paper:
      return at_place<kChebyshevPaper>(a, b, at);
    case Fit::quadratic:
      return at_place<kChebyshevQuadratic>(a, b, at);
    case Fit::cubic:
      return at_place<kChebyshevCubic>(a, b, at);
    case Fit::row:
    case Fit::weights:
      break;
  }
  return at_place<kRowWeightsCubic>(a, b, at);
}

// Rows of nine pixels.
struct Nines {
  // Pixels have their own normals where the ends say nothing of what is between them: nearly opposite, or of
  // a triangle whose rows are not known.
  template <class F, class P, class Y>
  static __attribute__((noinline)) void normal_at(const ShadeJob& job, const MixedNormals<F>& t,
                                                  const NormalRow<F>& s, P x, Y y, V3<P>& n) {
    using I = Integer<P>;
    const P pixel(static_cast<float>(kSubpixels)), per_pixel(1.0f / kSubpixels);
    const I last = truncate((P(s.last) - P(s.first)) * per_pixel);
    const I column = min(truncate(max((x - P(s.first)) * per_pixel, P(0.0f)) + P(0.5f)), last);
    const I start = shift_left<3>(shift_right<3>(column)), steps = min(last - start, I(8));
    const P x0 = P(s.first) + to_float(start) * pixel;
    const V3<P> a = unit_normal_at(job, t, s, x0, y);
    const V3<P> b = unit_normal_at(job, t, s, x0 + to_float(steps) * pixel, y);
    const P d = min(dot(a, b), P(select(t.narrow, F(-1.0f), F(1.0f))));
    const I k = column - start;
    n = at_place(fit_of(job), a, b, Place9<P>{d, k});
    const auto other = (steps < I(8)) | (d < P(0.0f));
    if (any(other)) {
      const P place = to_float(k + k) / max(to_float(steps), P(1.0f)) - P(1.0f);
      n = choose(other, along_any(a, b, d, place), n);
      const auto own = d < P(static_cast<float>(kLowestArc));
      if (any(own)) n = choose(own, unit_normal_at(job, t, s, x, y), n);
    }
  }
};

struct Parallel {
  template <class F>
  using Triangle = MixedNormals<F>;
  template <class F>
  using Span = Row::Span<F>;

  template <class F>
  static BLYSK_INLINE Triangle<F> set_up_triangle(const ShadeJob& job, Integer<F> index) {
    return fetch_mixed_normals<F>(job, index, fit_of(job) == Fit::row ? kShortestArc : 1);
  }

  template <class F>
  static BLYSK_INLINE Span<F> set_up_span(const ShadeJob& job, const Triangle<F>& t, F y) {
    Span<F> s;
    s.row = normal_row(t, y);
    if (fit_of(job) == Fit::row) Row::set_up(job, t, y, s);
    return s;
  }

  template <class F, class P, class Y>
  static BLYSK_INLINE Rgb<P> shade(const ShadeJob& job, const Triangle<F>& t, const Span<F>& s, P x, Y y,
                                   P nearness) {
    V3<P> n;
    if (fit_of(job) == Fit::row) {
      n = Row::normal_at(job, t, s, x, y);
    } else {
      Nines::normal_at(job, t, s.row, x, y, n);
    }
    return light_unit(job, t.corners, n, x, y, nearness);
  }
};

}  // namespace

void shade_parallel(const ShadeJob& job) { shade_draw<Parallel, ColorSink>(job); }

}  // namespace blysk::BLYSK_ISA
