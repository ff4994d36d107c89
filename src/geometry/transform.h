// geometry/transform.h - positions to screen vertices.
#pragma once

#include <cstddef>

#include "blysk/vector.h"
#include "geometry/screen_vertex.h"

namespace blysk {

struct TransformJob {
  const Vec3f* positions;
  std::size_t count;
  Projection projection;
  ScreenVertex* out;  ///< count
};

using TransformFunction = void (*)(const TransformJob&);

}  // namespace blysk
