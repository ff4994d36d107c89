// shading/corner_light.h - lighting of points of the mesh, for methods that light corners instead of pixels.
#pragma once

#include "shading/corners.h"

namespace blysk::BLYSK_ISA {

template <class F>
BLYSK_INLINE V3<F> world_position(const ShadeJob& job, Integer<F> vertex) {
  const V3<F> p = fetch3<F>(job.draw->positions, vertex);
  if (!job.draw->moved) return p;
  const float* m = job.draw->matrix;
  const V3<F> r = times(m, 4, p);
  return {r.x + F(m[3]), r.y + F(m[7]), r.z + F(m[11])};
}

/// From a world point towards the viewer, not unit.
template <class F>
BLYSK_INLINE V3<F> viewer_from(const ShadeJob& job, const V3<F>& p) {
  const ViewRays& r = *job.rays;
  return r.orthographic ? V3<F>{F(-r.direction[0]), F(-r.direction[1]), F(-r.direction[2])}
                        : V3<F>{F(r.origin[0]) - p.x, F(r.origin[1]) - p.y, F(r.origin[2]) - p.z};
}

/// Lights a world point with a world normal of any length.
template <class F>
BLYSK_INLINE Intensity<F> light_world_point(const ShadeJob& job, const V3<F>& n, const V3<F>& p) {
  return light_point(job.draw->surface, n, viewer_from(job, p), [&] { return p; });
}

/// World normal of a corner, not unit; of meshes that have none the face's.
template <class F>
BLYSK_INLINE V3<F> corner_normal(const ShadeJob& job, const Corners<F>& c, int k) {
  if (job.draw->normals == nullptr) return face_normal(job, c);
  const V3<F> n = fetch3<F>(job.draw->normals, c.vertex[k]);
  return job.draw->moved ? times(job.draw->normal_matrix, 3, n) : n;
}

template <class F>
BLYSK_INLINE Intensity<F> light_corner(const ShadeJob& job, const Corners<F>& c, int k) {
  return light_world_point(job, corner_normal(job, c, k), world_position<F>(job, c.vertex[k]));
}

}  // namespace blysk::BLYSK_ISA
