// shading/corners.h - a triangle's corners, and how much each counts at a pixel.
//
// F and I are float and int32 for one triangle, F32 and I32 for sixteen.
#pragma once

#include "lighting/lighting.h"
#include "shading/shade.h"
#include "simd/lanes.h"

namespace blysk::BLYSK_ISA {

template <class F>
struct IntegerOf;
template <>
struct IntegerOf<float> {
  using type = std::int32_t;
};
template <int kRegisters>
struct IntegerOf<Floats<kRegisters>> {
  using type = Ints<kRegisters>;
};
template <class F>
using Integer = typename IntegerOf<F>::type;

// Four neighbouring words at base + stride * index. Blocks of Array have room to be read past their end.
template <int kStride>
BLYSK_INLINE void fetch_row(const float* base, std::int32_t index, float row[4]) {
  std::memcpy(row, base + std::ptrdiff_t{kStride} * index, 4 * sizeof(float));
}
template <int kStride, int kRegisters>
BLYSK_INLINE void fetch_row(const float* base, Ints<kRegisters> index, Floats<kRegisters> row[4]) {
  gather_rows<kStride>(base, index, row);
}

template <class F>
BLYSK_INLINE V3<F> fetch3(const Vec3f* base, Integer<F> index) {
  F row[4];
  fetch_row<3>(reinterpret_cast<const float*>(base), index, row);
  return {row[0], row[1], row[2]};
}

template <class F>
BLYSK_INLINE V3<F> times(const float* m, int stride, const V3<F>& v) {
  const auto row = [&](int i) {
    return (F(m[i * stride]) * v.x + F(m[i * stride + 1]) * v.y) + F(m[i * stride + 2]) * v.z;
  };
  return {row(0), row(1), row(2)};
}

/// Corners on the screen, homogeneous: a pixel at (x, y) is x[k] - w[k] * x away.
template <class F>
struct Corners {
  Integer<F> vertex[3];          ///< of the mesh
  F x[3], y[3], w[3];            ///< subpixels; w is 1 unless the triangle was clipped
  F q[3];                        ///< weight of a corner's attributes: 1 / w where perspective counts, else 1
  F nearness[3];                 ///< of placed corners
  bool clipped;                  ///< any w is not 1
  decltype(F() < F()) unplaced;  ///< has an unplaced corner: only pieces of it, clipped, are drawn
};

/// Triangles with unplaced corners keep their homogeneous coordinates: the same weights hold for every
/// clipped piece, and no attribute is ever clipped.  M. Olano, T. Greer. Triangle scan conversion using 2D
/// homogeneous coordinates. 1997.
template <class F>
__attribute__((noinline)) void unplace(const ShadeJob& job, Corners<F>& c) {
  const Projection& m = job.draw->projection;
  const auto clipped = c.unplaced;
  for (int k = 0; k < 3; ++k) {
    const V3<F> p = fetch3<F>(job.draw->positions, c.vertex[k]);
    const auto row = [&](int i) {
      return (F(m.row[i][0]) * p.x + F(m.row[i][1]) * p.y) + (F(m.row[i][2]) * p.z + F(m.row[i][3]));
    };
    c.x[k] = select(clipped, row(0), c.x[k]);
    c.y[k] = select(clipped, row(1), c.y[k]);
    c.w[k] = select(clipped, row(3), c.w[k]);
    c.q[k] = select(clipped, F(1.0f), c.q[k]);
  }
  c.clipped = true;
}

/// `triangle` counts within the mesh.
template <class F>
BLYSK_INLINE Corners<F> fetch_corners(const ShadeJob& job, Integer<F> triangle) {
  Corners<F> c;
  F index[4];
  fetch_row<3>(reinterpret_cast<const float*>(job.draw->indices), triangle, index);
  for (int k = 0; k < 3; ++k) {
    F vertex[4];
    c.vertex[k] = bits_of(index[k]);
    fetch_row<4>(reinterpret_cast<const float*>(job.vertices + job.draw->vertex_base), c.vertex[k], vertex);
    c.x[k] = to_float(bits_of(vertex[0]));
    c.y[k] = to_float(bits_of(vertex[1]));
    c.w[k] = F(1.0f);
    c.q[k] = job.screen_linear ? F(1.0f) : vertex[3];
    c.nearness[k] = vertex[2];
  }
  c.clipped = false;
  const F mark(static_cast<float>(kUnplaced));
  c.unplaced = (c.x[0] == mark) | (c.x[1] == mark) | (c.x[2] == mark);
  if (__builtin_expect(any(c.unplaced), 0)) unplace(job, c);
  return c;
}

/// Weights of the corners at pixel centres, up to one common factor (of either sign).
template <class P>
struct Weights {
  P of[3];
};

template <class F, class P, class Y>
BLYSK_INLINE Weights<P> weights_at(const Corners<F>& c, P x, Y y) {
  P dx[3], dy[3];
  for (int k = 0; k < 3; ++k) {
    dx[k] = c.clipped ? P(c.x[k]) - P(c.w[k]) * x : P(c.x[k]) - x;
    dy[k] = c.clipped ? P(c.y[k] - c.w[k] * y) : P(c.y[k] - y);
  }
  Weights<P> w;
  w.of[0] = (dx[1] * dy[2] - dx[2] * dy[1]) * P(c.q[0]);
  w.of[1] = (dx[2] * dy[0] - dx[0] * dy[2]) * P(c.q[1]);
  w.of[2] = (dx[0] * dy[1] - dx[1] * dy[0]) * P(c.q[2]);
  return w;
}

template <class F, class P>
BLYSK_INLINE V3<P> mix(const Weights<P>& w, const V3<F>& a, const V3<F>& b, const V3<F>& c) {
  return {(w.of[0] * P(a.x) + w.of[1] * P(b.x)) + w.of[2] * P(c.x),
          (w.of[0] * P(a.y) + w.of[1] * P(b.y)) + w.of[2] * P(c.y),
          (w.of[0] * P(a.z) + w.of[1] * P(b.z)) + w.of[2] * P(c.z)};
}

/// The sum of the weights, inverted: only attributes whose length matters need it.
template <class P>
BLYSK_INLINE P inverse_sum(const Weights<P>& w) {
  return P(1.0f) / ((w.of[0] + w.of[1]) + w.of[2]);
}

/// A power of two that brings the larger of two vectors near length 1, so that products of them neither
/// vanish nor overflow whatever the unit of length.
template <class F>
BLYSK_INLINE F unit_scale(const V3<F>& a, const V3<F>& b) {
  using I = Integer<F>;
  const auto magnitude = [](F v) { return bits_of(v) & I(0x7fffffff); };
  const I of_a = max(max(magnitude(a.x), magnitude(a.y)), magnitude(a.z));
  const I of_b = max(max(magnitude(b.x), magnitude(b.y)), magnitude(b.z));
  return float_of_bits(I(0x7f000000) - (max(of_a, of_b) & I(0x7f800000)));
}

/// World normal of the face, not unit.
template <class F>
BLYSK_INLINE V3<F> face_normal(const ShadeJob& job, const Corners<F>& t) {
  const V3<F> p0 = fetch3<F>(job.draw->positions, t.vertex[0]);
  const V3<F> p1 = fetch3<F>(job.draw->positions, t.vertex[1]);
  const V3<F> p2 = fetch3<F>(job.draw->positions, t.vertex[2]);
  const V3<F> a = {p1.x - p0.x, p1.y - p0.y, p1.z - p0.z};
  const V3<F> b = {p2.x - p0.x, p2.y - p0.y, p2.z - p0.z};
  const F scale = unit_scale(a, b);
  const V3<F> c = {a.x * scale, a.y * scale, a.z * scale}, d = {b.x * scale, b.y * scale, b.z * scale};
  const V3<F> n = {c.y * d.z - c.z * d.y, c.z * d.x - c.x * d.z, c.x * d.y - c.y * d.x};
  return job.draw->moved ? times(job.draw->normal_matrix, 3, n) : n;
}

/// A normal that vanishes between opposite ones faces the viewer.
template <class P>
BLYSK_INLINE V3<P> or_viewer(const V3<P>& n, const V3<P>& viewer) {
  const auto gone = dot(n, n) < P(1e-20f);
  if (__builtin_expect(!any(gone), 1)) return n;
  return {select(gone, viewer.x, n.x), select(gone, viewer.y, n.y), select(gone, viewer.z, n.z)};
}

/// Towards the viewer, not unit.
template <class P, class Y>
BLYSK_INLINE V3<P> viewer_at(const ShadeJob& job, P x, Y y) {
  const ViewRays& r = *job.rays;
  const auto along = [&](int i) {
    return P(Y(-r.direction[i]) - y * Y(r.direction_y[i])) - x * P(r.direction_x[i]);
  };
  return {along(0), along(1), along(2)};
}

/// The world point that a pixel shows.
template <class P, class Y>
BLYSK_INLINE V3<P> point_at(const ShadeJob& job, P x, Y y, P nearness, const V3<P>& viewer) {
  const ViewRays& r = *job.rays;
  const P d = r.orthographic ? P(r.depth_a) + P(r.depth_b) * nearness
                             : P(r.depth_a) / (P(1.0f) + P(r.depth_b) * nearness);
  const auto from = [&](int i) { return P(Y(r.origin[i]) + y * Y(r.origin_y[i])) + x * P(r.origin_x[i]); };
  return {from(0) - d * viewer.x, from(1) - d * viewer.y, from(2) - d * viewer.z};
}

/// Where `m` holds `yes`, else `no`; `m` of one triangle or of its sixteen.
template <class P>
BLYSK_INLINE Rgb<P> choose(bool m, const Rgb<P>& yes, const Rgb<P>& no) {
  return m ? yes : no;
}
template <int kRegisters>
BLYSK_INLINE Rgb<Floats<kRegisters>> choose(Masks<kRegisters> m, const Rgb<Floats<kRegisters>>& yes,
                                            const Rgb<Floats<kRegisters>>& no) {
  return {select(m, yes.x, no.x), select(m, yes.y, no.y), select(m, yes.z, no.z)};
}

/// Intensities and the colours of the vertices to a colour. `w` is read only where vertices have colours.
template <class F, class P>
BLYSK_INLINE Rgb<P> compose(const ShadeJob& job, const Corners<F>& c, const Weights<P>& w,
                            const Intensity<P>& i) {
  Rgb<P> diffuse = i.diffuse;
  if (job.draw->colors != nullptr) {
    V3<F> color[3];
    for (int k = 0; k < 3; ++k) {
      F row[4];
      fetch_row<4>(reinterpret_cast<const float*>(job.draw->colors), c.vertex[k], row);
      color[k] = {row[0], row[1], row[2]};
    }
    const V3<P> mixed = mix(w, color[0], color[1], color[2]);
    const P inverse = inverse_sum(w);
    diffuse = {diffuse.x * (mixed.x * inverse), diffuse.y * (mixed.y * inverse),
               diffuse.z * (mixed.z * inverse)};
  }
  return {diffuse.x + i.specular.x, diffuse.y + i.specular.y, diffuse.z + i.specular.z};
}

/// The same for methods that need the weights for nothing else.
template <class F, class P, class Y>
BLYSK_INLINE Rgb<P> compose(const ShadeJob& job, const Corners<F>& c, P x, Y y, const Intensity<P>& i) {
  if (job.draw->colors != nullptr) return compose(job, c, weights_at(c, x, y), i);
  return {i.diffuse.x + i.specular.x, i.diffuse.y + i.specular.y, i.diffuse.z + i.specular.z};
}

}  // namespace blysk::BLYSK_ISA
