// Phong shading that makes every other normal of a row unit, and finds the ones between from their
// neighbours.
//
// Based on: relief thesis, dichotomy; specification of relief and texturing, section 2.6 (erratum 13).
// Differs in: normals are evaluated instead of added up along the row; all cosines are computed, as they are
// alike only in rows whose ends are equally long (erratum 11); neighbours too far apart for the form are
// served by the exact one, and nearly opposite ones by the pixel's own normal.
#include "math/inverse_length.h"
#include "math/row_normals.h"
#include "shading/mixed_normals.h"
#include "shading/shade_tile.h"
#include "simd/kernels.h"

namespace blysk::BLYSK_ISA {
namespace {

enum class Form { exact, paper, minimax, half_sum };

template <class P>
BLYSK_INLINE P exact_scale(P c) {
  return reciprocal_root(max(P(2.0f) + P(2.0f) * c, P(1e-6f)));
}

template <const MidVector& kPolynomial, class P>
BLYSK_INLINE P polynomial_scale(P c) {
  constexpr auto q = [](int i) { return static_cast<float>(kPolynomial.q[i]); };
  return (P(q(2)) * c + P(q(1))) * c + P(q(0));
}

// What (a + b) is multiplied with, from the cosine c of a and b.
template <class P>
BLYSK_INLINE P middle_scale(Form form, P c) {
  P scale(0.5f);
  double lowest = kLowestHalfSum;
  switch (form) {
    case Form::exact:
      return exact_scale(c);
    case Form::paper:
      scale = polynomial_scale<kMidVectorPaper>(c);
      lowest = kMidVectorPaper.lowest;
      break;
    case Form::minimax:
      scale = polynomial_scale<kMidVectorMinimax>(c);
      lowest = kMidVectorMinimax.lowest;
      break;
    case Form::half_sum:
      break;
  }
  const auto far = c < P(static_cast<float>(lowest));
  return __builtin_expect(any(far), 0) ? select(far, exact_scale(c), scale) : scale;
}

template <class P>
BLYSK_INLINE V3<P> scaled_sum(const V3<P>& a, const V3<P>& b, P scale) {
  return {(a.x + b.x) * scale, (a.y + b.y) * scale, (a.z + b.z) * scale};
}

// One row of a block: what every second pixel has, and a lane more.
template <int kRegisters>
struct HalfRow {
  static constexpr int kCount = kRegisters * kPartLanes;
  float value[kCount + 1];

  BLYSK_INLINE HalfRow(Floats<kRegisters> lanes, float last) {
    store_all(lanes, value);
    value[kCount] = last;
  }
  [[nodiscard]] BLYSK_INLINE Floats<kRegisters> shifted() const {
    Floats<kRegisters> r;
    load_all(value + 1, r);
    return r;
  }
};

// even, odd, even, odd ...
template <int kRegisters>
BLYSK_INLINE Floats<2 * kRegisters> alternate(Floats<kRegisters> even, Floats<kRegisters> odd) {
  float both[2 * kRegisters * kPartLanes];
  BLYSK_EACH(kRegisters,
             hn::StoreInterleaved2(even.part[i], odd.part[i], FloatTag(), both + 2 * i * kPartLanes))
  Floats<2 * kRegisters> r;
  load_all(both, r);
  return r;
}

struct Dichotomy {
  template <class F>
  using Triangle = MixedNormals<F>;
  template <class F>
  using Span = NormalRow<F>;

  template <class F>
  static BLYSK_INLINE Triangle<F> set_up_triangle(const ShadeJob& job, Integer<F> index) {
    return fetch_mixed_normals<F>(job, index, kShortestArc);
  }

  template <class F>
  static BLYSK_INLINE Span<F> set_up_span(const ShadeJob&, const Triangle<F>& t, F y) {
    return normal_row(t, y);
  }

  static BLYSK_INLINE Form form_of(const ShadeJob& job) { return static_cast<Form>(job.settings[0]); }

  // Each pixel by itself.
  template <class F, class P, class Y>
  static __attribute__((noinline)) void single_normals(const ShadeJob& job, const Triangle<F>& t,
                                                       const Span<F>& s, P x, Y y, V3<P>& n) {
    using I = Integer<P>;
    const P zero(0.0f), per_pixel(1.0f / kSubpixels);
    // Narrow triangles have no rows: wherever it is, a pixel has its own normal.
    const F anywhere = select(t.narrow, F(1e9f), F(0.0f));
    const P at = min(max(x, P(s.first - anywhere)), P(s.last + anywhere));
    const P from_first = min(max(x - P(s.first), zero), P(s.last - s.first));
    const I column = truncate(from_first * per_pixel + P(0.5f));
    const I last = truncate((P(s.last) - P(s.first)) * per_pixel);
    const auto between = ((column & I(1)) > I(0)) & (column < last);
    const P step = select(between, P(static_cast<float>(kSubpixels)), zero);
    const V3<P> a = unit_normal_at(job, t, s, at - step, y);
    n = a;
    if (!any(between)) return;
    const V3<P> b = unit_normal_at(job, t, s, at + step, y);
    const P c = dot(a, b);
    n = choose(between, scaled_sum(a, b, middle_scale(form_of(job), c)), a);
    const auto lost = between & (c < P(static_cast<float>(kLowestArc)));
    if (any(lost)) n = choose(lost, unit_normal_at(job, t, s, at, y), n);
  }

  template <class F, class P, class Y>
  static BLYSK_INLINE V3<P> normals(const ShadeJob& job, const Triangle<F>& t, const Span<F>& s, P x, Y y) {
    V3<P> n;
    single_normals(job, t, s, x, y, n);
    return n;
  }

  // Neighbours in a row of one triangle: half of them are made unit.
  template <int kRegisters>
  requires(kRegisters % 2 == 0) static BLYSK_INLINE V3<Floats<kRegisters>> normals(
      const ShadeJob& job, const Triangle<float>& t, const Span<float>& s, Floats<kRegisters> x, float y) {
    constexpr int kHalf = kRegisters / 2;
    constexpr float kReach = 2 * kSubpixels * HalfRow<kHalf>::kCount;
    using P = Floats<kRegisters>;
    using H = Floats<kHalf>;
    const float x0 = hn::GetLane(x.part[0]);
    // Fragments of an A-buffer may lie anywhere in their pixels.
    const auto offset = truncate(x0 - s.first);
    const auto steps = to_float(shift_left<kSubpixelBits>(iota<kRegisters>(0)));
    const bool neighbours = (offset & (kSubpixels - 1)) == 0 && !any((x - P(x0)) != steps);
    if (!neighbours || t.narrow) {
      V3<P> n;
      single_normals(job, t, s, x, y, n);
      return n;
    }
    // Lanes 0, 2, ... are a row's first, third, ... pixels, or lanes -1, 1, ... are.
    const bool odd = (offset & kSubpixels) != 0;
    const float start = odd ? x0 - kSubpixels : x0;
    const H at = H(start) + to_float(shift_left<kSubpixelBits + 1>(iota<kHalf>(0)));
    const V3<H> a = unit_normal_at(job, t, s, at, y);
    const V3<float> next = unit_normal_at(job, t, s, start + kReach, y);
    const V3<H> b = {HalfRow<kHalf>(a.x, next.x).shifted(), HalfRow<kHalf>(a.y, next.y).shifted(),
                     HalfRow<kHalf>(a.z, next.z).shifted()};
    const H c = dot(a, b);
    if (__builtin_expect(any(c < H(static_cast<float>(kLowestArc))), 0)) {
      V3<P> n;
      single_normals(job, t, s, x, y, n);
      return n;
    }
    const V3<H> between = scaled_sum(a, b, middle_scale(form_of(job), c));
    const V3<H>&first = odd ? between : a, &second = odd ? b : between;
    V3<P> n = {alternate(first.x, second.x), alternate(first.y, second.y), alternate(first.z, second.z)};
    // A last pixel without a neighbour to its right.
    const float length = s.last - s.first;
    if ((truncate(length) & kSubpixels) != 0 && s.last >= x0 && s.last <= start + kReach) {
      const V3<float> end = unit_normal_at(job, t, s, s.last, y);
      n = choose(x == P(s.last), V3<P>{P(end.x), P(end.y), P(end.z)}, n);
    }
    return n;
  }
  template <class F, class P, class Y>
  static BLYSK_INLINE Rgb<P> shade(const ShadeJob& job, const Triangle<F>& t, const Span<F>& s, P x, Y y,
                                   P nearness) {
    return light_unit(job, t.corners, normals(job, t, s, x, y), x, y, nearness);
  }
};

}  // namespace

void shade_dichotomy(const ShadeJob& job) { shade_draw<Dichotomy, ColorSink>(job); }

}  // namespace blysk::BLYSK_ISA
