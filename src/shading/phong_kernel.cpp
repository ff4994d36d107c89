// Phong shading: the normal is interpolated and lit at every pixel. The reference of all others.
//
// Based on: B. T. Phong. Illumination for computer generated pictures. 1975. Thesis, section 3.3 of the
// specification.
#include "shading/shade_tile.h"
#include "simd/kernels.h"

namespace blysk::BLYSK_ISA {
namespace {

struct Phong {
  template <class F>
  struct Triangle {
    Corners<F> corners;
    V3<F> normal[3];
  };
  struct Span {};

  template <class F>
  static BLYSK_INLINE Triangle<F> set_up_triangle(const ShadeJob& job, Integer<F> index) {
    Triangle<F> t;
    t.corners = fetch_corners<F>(job, index);
    if (job.draw->normals == nullptr) {
      t.normal[0] = t.normal[1] = t.normal[2] = face_normal(job, t.corners);
    } else {
      for (int k = 0; k < 3; ++k) t.normal[k] = fetch3<F>(job.draw->normals, t.corners.vertex[k]);
    }
    return t;
  }

  template <class F, class Y>
  static BLYSK_INLINE Span set_up_span(const ShadeJob&, const Triangle<F>&, Y) {
    return {};
  }

  // World normal up to its length; a normal that vanishes between opposite ones faces the viewer.
  template <class F>
  static BLYSK_INLINE V3<F32> normal_at(const ShadeJob& job, const Triangle<F>& t, const Weights& w,
                                        const V3<F32>& viewer) {
    V3<F32> n = mix(w, t.normal[0], t.normal[1], t.normal[2]);
    if (job.draw->moved && job.draw->normals != nullptr) n = times(job.draw->normal_matrix, 3, n);
    const Mask gone = dot(n, n) < F32(1e-20f);
    if (__builtin_expect(any(gone), 0)) {
      n = {select(gone, viewer.x, n.x), select(gone, viewer.y, n.y), select(gone, viewer.z, n.z)};
    }
    return n;
  }

  template <class F, class Y>
  static BLYSK_INLINE Rgb<F32> shade(const ShadeJob& job, const Triangle<F>& t, const Span&, F32 x, Y y,
                                     F32 nearness) {
    const Weights w = weights_at(t.corners, x, y);
    const V3<F32> viewer = viewer_at(job, x, y);
    const V3<F32> n = normal_at(job, t, w, viewer);
    const auto where = [&] { return point_at(job, x, y, nearness, viewer); };
    return compose(job, t.corners, w, light_point(job.draw->surface, n, viewer, where));
  }
};

// World normals instead of colours, unit and towards the viewer, for the picture of normals.
struct Normals : Phong {
  template <class F, class Y>
  static BLYSK_INLINE Rgb<F32> shade(const ShadeJob& job, const Triangle<F>& t, const Span&, F32 x, Y y,
                                     F32) {
    const V3<F32> viewer = viewer_at(job, x, y);
    const V3<F32> n = normal_at(job, t, weights_at(t.corners, x, y), viewer);
    F32 scale = F32(1.0f) / sqrt(dot(n, n));
    scale = select(dot(n, viewer) < F32(0.0f), F32(0.0f) - scale, scale);
    return {n.x * scale, n.y * scale, n.z * scale};
  }
};

struct NormalSink {
  static BLYSK_INLINE void row(const ShadeJob& job, int at, Mask m, const Rgb<F32>& c) {
    std::int32_t place[kLanes];
    const int count = store_compressed(m, iota(at), place);
    float x[kLanes], y[kLanes], z[kLanes];
    store(c.x, x);
    store(c.y, y);
    store(c.z, z);
    for (int i = 0; i < count; ++i)
      write(job, place[i], x[place[i] - at], y[place[i] - at], z[place[i] - at]);
  }
  static BLYSK_INLINE void scatter(const ShadeJob& job, const std::int32_t* at, int count,
                                   const Rgb<F32>& c) {
    float x[kLanes], y[kLanes], z[kLanes];
    store(c.x, x);
    store(c.y, y);
    store(c.z, z);
    for (int i = 0; i < count; ++i) write(job, at[i], x[i], y[i], z[i]);
  }
  static BLYSK_INLINE void write(const ShadeJob& job, int at, float x, float y, float z) {
    job.normals[3 * at] = x;
    job.normals[3 * at + 1] = y;
    job.normals[3 * at + 2] = z;
  }
};

}  // namespace

void shade_phong(const ShadeJob& job) { shade_draw<Phong, ColorSink>(job); }
void write_normals(const ShadeJob& job) { shade_draw<Normals, NormalSink>(job); }

}  // namespace blysk::BLYSK_ISA
