// shading/shading_reference.h - flat, Gouraud and Phong shading of one triangle at a pixel, in double
// precision.
//
// What the kernels are measured against: thesis, section 3 of the specification.
#pragma once

#include <array>

#include "lighting/lighting_reference.h"

namespace blysk::reference {

/// Where the light that reaches the picture comes from.
struct Viewpoint {
  bool orthographic = false;
  Vec3d eye;      ///< perspective
  Vec3d forward;  ///< orthographic

  [[nodiscard]] Vec3d towards_viewer(Vec3d from) const { return orthographic ? -forward : eye - from; }
};

struct Corner {
  double x = 0, y = 0;   ///< on the screen
  double q = 1;          ///< 1 / w where perspective counts, else 1
  Vec3d position;        ///< world
  Vec3d normal;          ///< world, of any length
  Vec3d color{1, 1, 1};  ///< of the vertex: multiplies diffuse light
};

struct ShadedTriangle {
  std::array<Corner, 3> corner;
  Lighting lighting;
  Viewpoint view;
};

/// How much each corner counts at a point of the screen: barycentric, q taken into account. They sum to 1.
std::array<double, 3> weights(const std::array<Corner, 3>& corner, double x, double y);

/// One normal and colour for the triangle, lit at its centroid. Vertex colours are interpolated.
Vec3d flat(const ShadedTriangle& t, const std::array<double, 3>& w);
/// The corners are lit, intensities interpolated.
Vec3d gouraud(const ShadedTriangle& t, const std::array<double, 3>& w);
/// The normal is interpolated and lit at the point that the pixel shows.
Vec3d phong(const ShadedTriangle& t, const std::array<double, 3>& w, Vec3d position);

/// Of the face, not unit: (P1 - P0) x (P2 - P0).
Vec3d face_normal(const std::array<Corner, 3>& corner);

}  // namespace blysk::reference
