// Phong shading: the normal is interpolated and lit at every pixel. The reference of all others.
//
// Based on: B. T. Phong. Illumination for computer generated pictures. 1975. Thesis, section 3.3 of the
// specification.
#include "shading/plane.h"
#include "shading/shade_tile.h"
#include "simd/kernels.h"

namespace blysk::BLYSK_ISA {
namespace {

struct Phong {
  template <class F>
  struct Triangle {
    Corners<F> corners;
    F x, y;  // where the plane starts
    NormalPlane<F> normal;
  };
  template <class F>
  using Span = V3<F>;

  template <class F>
  static BLYSK_INLINE Triangle<F> set_up_triangle(const ShadeJob& job, Integer<F> index) {
    Triangle<F> t;
    t.corners = fetch_corners<F>(job, index);
    V3<F> normal[3];
    if (job.draw->normals == nullptr) {
      normal[0] = normal[1] = normal[2] = face_normal(job, t.corners);
    } else {
      for (int k = 0; k < 3; ++k) {
        const V3<F> n = fetch3<F>(job.draw->normals, t.corners.vertex[k]);
        normal[k] = job.draw->moved ? times(job.draw->normal_matrix, 3, n) : n;
      }
    }
    const PlaneFrame<F> frame = plane_frame(t.corners);
    t.x = frame.x;
    t.y = frame.y;
    t.normal = normal_plane(frame, normal);
    return t;
  }

  template <class F>
  static BLYSK_INLINE Span<F> set_up_span(const ShadeJob&, const Triangle<F>& t, F y) {
    return on_row(t.normal, y - t.y);
  }

  // World normal up to its length.
  template <class F, class P>
  static BLYSK_INLINE V3<P> normal_at(const Triangle<F>& t, const Span<F>& row, P x, const V3<P>& viewer) {
    return or_viewer(along_row(t.normal, row, x - P(t.x)), viewer);
  }

  template <class F, class P, class Y>
  static BLYSK_INLINE Rgb<P> shade(const ShadeJob& job, const Triangle<F>& t, const Span<F>& row, P x, Y y,
                                   P nearness) {
    const V3<P> viewer = viewer_at(job, x, y);
    const V3<P> n = normal_at(t, row, x, viewer);
    const auto where = [&] { return point_at(job, x, y, nearness, viewer); };
    const Intensity<P> light = light_point(job.draw->surface, n, viewer, where);
    return compose(job, t.corners, x, y, light);
  }
};

// World normals instead of colours, unit and towards the viewer, for the picture of normals.
struct Normals : Phong {
  template <class F, class P, class Y>
  static BLYSK_INLINE Rgb<P> shade(const ShadeJob& job, const Triangle<F>& t, const Span<F>& row, P x, Y y,
                                   P) {
    const V3<P> viewer = viewer_at(job, x, y);
    const V3<P> n = normal_at(t, row, x, viewer);
    P scale = P(1.0f) / sqrt(dot(n, n));
    scale = select(dot(n, viewer) < P(0.0f), P(0.0f) - scale, scale);
    return {n.x * scale, n.y * scale, n.z * scale};
  }
};

struct NormalSink {
  static constexpr bool kWide = false;
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
                                   const Rgb<F32Wide>& c) {
    float x[kWideLanes], y[kWideLanes], z[kWideLanes];
    store_all(c.x, x);
    store_all(c.y, y);
    store_all(c.z, z);
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
