// Phong shading: the normal is interpolated and lit at every pixel. The reference of all others.
//
// Based on: B. T. Phong. Illumination for computer generated pictures. 1975. Thesis, section 3.3 of the
// specification.
#include "shading/phong.h"
#include "shading/shade_tile.h"
#include "simd/kernels.h"

namespace blysk::BLYSK_ISA {
namespace {

// World normals instead of colours, unit and towards the viewer, for the picture of normals.
struct Normals : Phong {
  template <class F, class P, class Y>
  static BLYSK_INLINE Rgb<P> shade(const ShadeJob& job, const Triangle<F>& t, const Span<F>& row, P x, Y y,
                                   P) {
    const V3<P> viewer = viewer_at(job, x, y);
    const V3<P> n = or_viewer(normal_along(t.normal, row, x), viewer);
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
  static BLYSK_INLINE void blend(const ShadeJob&, const std::int32_t*, int, const Rgb<F32Wide>&, F32Wide) {}
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
