// Normals as a quadratic form of the corners' and the edges' middles: nearly unit everywhere, nothing to
// normalise.
//
// Based on: relief thesis, vectors at an arbitrary point of a triangle; specification of relief and
// texturing, section 2.4. Differs in: the coordinates come from the edge functions, and triangles whose
// normals are further apart than the polynomial of the edges' middles reaches are interpolated linearly and
// made unit by the reciprocal root.
#include "math/inverse_length.h"
#include "shading/shade_tile.h"
#include "shading/unit_normals.h"
#include "simd/kernels.h"

namespace blysk::BLYSK_ISA {
namespace {

// Of four times the middle's vector.
struct MidScale {
  float q[3], lowest;
  explicit constexpr MidScale(const MidVector& p) : q(), lowest(static_cast<float>(p.lowest)) {
    for (int i = 0; i < 3; ++i) q[i] = static_cast<float>(4 * p.q[i]);
  }
};

// In the order of the registry's choices.
constexpr MidScale kMidScales[] = {MidScale(kMidVectorPaper), MidScale(kMidVectorMinimax)};

struct Barycentric {
  template <class F>
  struct Triangle {
    UnitNormals<F> linear;
    V3<F> mid[3];  // opposite each corner, four times as long as the vector in the middle
    F wide;        // 1: linear instead
    bool any_wide;
  };
  struct Span {};

  template <class F>
  static BLYSK_INLINE V3<F> mid_vector(const MidScale& p, const V3<F>& a, const V3<F>& b, F c) {
    const F scale = (F(p.q[2]) * c + F(p.q[1])) * c + F(p.q[0]);
    return {(a.x + b.x) * scale, (a.y + b.y) * scale, (a.z + b.z) * scale};
  }

  template <class F>
  static BLYSK_INLINE Triangle<F> set_up_triangle(const ShadeJob& job, Integer<F> index) {
    Triangle<F> t;
    t.linear = fetch_unit_normals<F>(job, index);
    const V3<F>* n = t.linear.normal;
    const F c[3] = {dot(n[1], n[2]), dot(n[2], n[0]), dot(n[0], n[1])};
    const MidScale& fit = kMidScales[job.settings[0]];
    for (int k = 0; k < 3; ++k) t.mid[k] = mid_vector(fit, n[(k + 1) % 3], n[(k + 2) % 3], c[k]);
    const auto wide = min(min(c[0], c[1]), c[2]) < F(fit.lowest);
    t.wide = select(wide, F(1.0f), F(0.0f));
    t.any_wide = any(wide);
    return t;
  }

  template <class F, class Y>
  static BLYSK_INLINE Span set_up_span(const ShadeJob&, const Triangle<F>&, Y) {
    return {};
  }

  template <class F, class P>
  static BLYSK_INLINE V3<P> normal_at(const Triangle<F>& t, const Weights<P>& w) {
    // A pixel's centre lies inside: what rounding put outside comes back.
    const P one(1.0f), zero(0.0f);
    const P c0 = min(max(w.of[0], zero), one), c1 = min(max(w.of[1], zero), one - c0), c2 = (one - c0) - c1;
    const auto corner = [&](P c) { return c * ((c + c) - one); };
    const V3<P> corners = mix(Weights<P>{{corner(c0), corner(c1), corner(c2)}}, t.linear.normal[0],
                              t.linear.normal[1], t.linear.normal[2]);
    const V3<P> edges = mix(Weights<P>{{c1 * c2, c2 * c0, c0 * c1}}, t.mid[0], t.mid[1], t.mid[2]);
    return {corners.x + edges.x, corners.y + edges.y, corners.z + edges.z};
  }

  template <class F, class P, class Y>
  static BLYSK_INLINE Rgb<P> shade(const ShadeJob& job, const Triangle<F>& t, const Span&, P x, Y y,
                                   P nearness) {
    const Weights<P> w = shares_at(t.linear, x, y);
    const V3<P> viewer = viewer_at(job, x, y);
    V3<P> n = normal_at(t, w);
    P inverse(1.0f);
    if (__builtin_expect(t.any_wide, 0)) {
      V3<P> linear = mix(w, t.linear.normal[0], t.linear.normal[1], t.linear.normal[2]);
      const P exact = exact_inverse_length(linear, dot(linear, linear), viewer);
      const auto wide = P(t.wide) > P(0.5f);
      n = {select(wide, linear.x, n.x), select(wide, linear.y, n.y), select(wide, linear.z, n.z)};
      inverse = select(wide, exact, inverse);
    }
    const auto where = [&] { return point_at(job, x, y, nearness, viewer); };
    return compose(job, t.linear.corners, w,
                   light_scaled<true>(job.draw->surface, n, inverse, viewer, where));
  }
};

}  // namespace

void shade_barycentric(const ShadeJob& job) { shade_draw<Barycentric, ColorSink>(job); }

}  // namespace blysk::BLYSK_ISA
