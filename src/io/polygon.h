// io/polygon.h - polygons to triangles, for all readers.
#pragma once

#include <cstdint>
#include <span>

#include "blysk/array.h"
#include "blysk/vector.h"

namespace blysk::io {

/// Polygons of more corners are fanned even if concave, lest a hostile file take squared time.
inline constexpr std::size_t kMostEarCorners = 2048;

/// Appends the triangles of a simple polygon as indices of its corners, in its own winding: always
/// corners.size() - 2 of them, none for fewer than three corners. Convex polygons are fanned from the first
/// corner; concave ones are cut into ears, so that the triangles cover the polygon and nothing else.
void triangulate(std::span<const Vec3f> corners, Array<std::uint32_t>& local_indices);

}  // namespace blysk::io
