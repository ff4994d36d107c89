// shading/lighting_texture_reference.h - the lighting texture of a triangle in double precision.
//
// A-buffer specification, C.6 - C.8; what differs stands in lighting_texture_kernel.cpp.
#pragma once

#include <cstdint>
#include <functional>

#include "blysk/vector.h"
#include "math/lighting_texture.h"

namespace blysk::reference {

/// Steps of an edge by size: the finest level whose points are `texel` pixels apart along the longest edge,
/// 0 where that does not pay. Squared length of the longest edge in pixels, area in pixels.
int texture_steps(int finest, double texel, double longest_squared, double area);

/// The paper's level for the longest edge: 0 is 17 x 17 points, 4 is 2 x 2.
int paper_level(double longest);

/// Points of a level: of the square and of its half.
int square_points(int steps);
int triangle_points(int steps);

/// What a point of the texture holds, (i, j) steps towards corners 1 and 2.
using TexturePoint = std::function<double(int i, int j)>;
/// Bilinear, on cells that the far edge cuts linear; u and v are the shares of corners 1 and 2.
double fetch_texture(int steps, const TexturePoint& point, double u, double v);

}  // namespace blysk::reference
