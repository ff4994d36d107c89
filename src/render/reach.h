// render/reach.h - how far a scene reaches along given directions.
#pragma once

#include <array>

#include "blysk/scene.h"
#include "geometry/support.h"

namespace blysk {

/// The largest dot product of any vertex, in world space, with each axis; below -1e200 without vertices.
[[nodiscard]] std::array<double, kSupportAxes> reach(const Scene& scene,
                                                     const std::array<Vec3d, kSupportAxes>& axes);

}  // namespace blysk
