// antialias/vertex_opacity.h - opacity that differs from vertex to vertex, where a fragment is shaded.
//
// Weights of the corners are those of their colours (shading/corners.h), in double precision: perspective
// counts unless interpolation is linear on the screen, and pieces of a clipped triangle take those of the
// whole one. Nothing here is inline: kernels are compiled for processors that the rest must not need.
#pragma once

#include <cstdint>

#include "blysk/vector.h"
#include "geometry/screen_vertex.h"

namespace blysk {

/// Of one draw.
struct VertexOpacity {
  const Vec3f* positions;
  const std::uint32_t* indices;
  const Vec4f* colors;  ///< alpha in w, 0..1
  Projection projection;
  std::uint32_t vertex_base, id_base;
  float factor;        ///< of the material, 0..1
  float cutoff;        ///< if `mask`
  bool mask;           ///< opaque from `cutoff` on, else not there
  bool screen_linear;  ///< interpolation
};

/// Of one triangle.
struct TriangleOpacity {
  double x[3], y[3], w[3];  ///< homogeneous corners, subpixels
  double q[3];              ///< weight of a corner's attributes
  double alpha[3];
  float factor, cutoff;
  bool mask;
};

/// `vertices` are the frame's, `id` counts over all instances.
[[nodiscard]] TriangleOpacity triangle_opacity(const VertexOpacity& draw, const ScreenVertex* vertices,
                                               std::uint32_t id);

/// At a place of the picture, in subpixels; 0..1.
[[nodiscard]] float opacity_at(const TriangleOpacity& triangle, Vec2<double> place);
/// At the centre of a pixel of the picture if all sixteen samples are in `mask`, else at their centroid;
/// 0..1.
[[nodiscard]] float opacity_at(const TriangleOpacity& triangle, int column, int row, std::uint32_t mask);

}  // namespace blysk
