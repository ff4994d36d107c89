// geometry/support.h - how far a mesh reaches along given directions.
#pragma once

#include <cstddef>

#include "blysk/vector.h"

namespace blysk {

inline constexpr int kSupportAxes = 6;

/// reach[k] = max(reach[k], largest dot product of any point with axis[k]).
using SupportFunction = void (*)(const Vec3f* points, std::size_t count, const Vec3f axis[kSupportAxes],
                                 float reach[kSupportAxes]);

}  // namespace blysk
