// Phong shading whose normals are made unit by a polynomial in their squared length, without root or
// division.
//
// Based on: relief thesis, formula (1); specification of relief and texturing, sections 2.1 and 2.2. Differs
// in: the normal is evaluated at every pixel instead of added up along the row (no drift, no chain), and
// outside the polynomial's range the reciprocal root serves.
#include "math/inverse_length.h"
#include "shading/plane.h"
#include "shading/shade_tile.h"
#include "shading/unit_normals.h"
#include "simd/kernels.h"

namespace blysk::BLYSK_ISA {
namespace {

struct LengthFit {
  float origin, c[4], lowest;
  explicit constexpr LengthFit(const InverseLength& p)
      : origin(static_cast<float>(p.origin)), c(), lowest(static_cast<float>(p.lowest)) {
    for (int i = 0; i < 4; ++i) c[i] = static_cast<float>(p.c[i]);
  }
};

// In the order of the registry's choices.
constexpr LengthFit kLengthFits[] = {LengthFit(kInverseLengthPaper), LengthFit(kInverseLengthMinimax),
                                     LengthFit(kInverseLengthCubic)};

struct FastNormalize {
  template <class F>
  struct Triangle {
    UnitNormals<F> unit;
    NormalPlane<F> normal;
    Plane<F> sum;  // of the weights, where that is not constant
  };
  template <class F>
  struct Span {
    V3<F> normal;
    F sum;
  };

  template <class F>
  static BLYSK_INLINE Triangle<F> set_up_triangle(const ShadeJob& job, Integer<F> index) {
    Triangle<F> t;
    t.unit = fetch_unit_normals<F>(job, index);
    const PlaneFrame<F> frame = plane_frame(t.unit.corners);
    t.normal = normal_plane(frame, t.unit.normal);
    if (t.unit.divide) t.sum = plane_of(frame, t.unit.corners.q);
    return t;
  }

  template <class F>
  static BLYSK_INLINE Span<F> set_up_span(const ShadeJob&, const Triangle<F>& t, F y) {
    Span<F> span;
    span.normal = row_normal(t.normal, y);
    if (t.unit.divide) span.sum = on_row(t.sum, y - t.normal.y);
    return span;
  }

  // The interpolated normal of unit ones.
  template <class F, class P>
  static BLYSK_INLINE V3<P> normal_at(const Triangle<F>& t, const Span<F>& span, P x) {
    P scale = P(t.unit.inverse_area);
    if (t.unit.divide) scale = share_scale(t.unit, along_row(t.sum, span.sum, x - P(t.normal.x)));
    const V3<P> n = normal_along(t.normal, span.normal, x);
    return {n.x * scale, n.y * scale, n.z * scale};
  }

  template <class P>
  static BLYSK_INLINE P value(const LengthFit& q, P k) {
    const P t = k - P(q.origin);
    P p(q.c[2]);
    if (q.c[3] != 0) p = P(q.c[3]) * t + p;
    return (p * t + P(q.c[1])) * t + P(q.c[0]);
  }

  template <class F, class P, class Y>
  static BLYSK_INLINE Rgb<P> shade(const ShadeJob& job, const Triangle<F>& t, const Span<F>& span, P x, Y y,
                                   P nearness) {
    const V3<P> viewer = viewer_at(job, x, y);
    V3<P> n = normal_at(t, span, x);
    const P k = dot(n, n);
    const LengthFit& fit = kLengthFits[job.settings[0]];
    P inverse = value(fit, k);
    const auto outside = (k < P(fit.lowest)) | (k > P(static_cast<float>(kLargestSquare)));
    if (__builtin_expect(any(outside), 0)) {
      V3<P> other = n;
      const P exact = exact_inverse_length(other, k, viewer);
      n = {select(outside, other.x, n.x), select(outside, other.y, n.y), select(outside, other.z, n.z)};
      inverse = select(outside, exact, inverse);
    }
    const auto where = [&] { return point_at(job, x, y, nearness, viewer); };
    const Intensity<P> light = light_scaled<true>(job.draw->surface, n, inverse, viewer, where);
    return compose(job, t.unit.corners, x, y, light);
  }
};

}  // namespace

void shade_fast_normalize(const ShadeJob& job) { shade_draw<FastNormalize, ColorSink>(job); }

}  // namespace blysk::BLYSK_ISA
