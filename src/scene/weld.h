// scene/weld.h - which of many points are the same.
#pragma once

#include <cstddef>
#include <cstdint>

#include "blysk/array.h"
#include "blysk/vector.h"
#include "core/threads.h"

namespace blysk {

struct WeldedIds {
  Array<std::uint32_t> ids;  ///< for every point that of all its equals, in the order of first appearance
  std::size_t count = 0;     ///< of distinct points
};

/// Finds the points that are exactly equal (0 equals -0; a NaN equals itself bit by bit). At most 2^32 - 2
/// points. The result does not depend on the number of threads. Cost: linear; n log n where somebody built
/// the points so that they collide.
[[nodiscard]] WeldedIds weld_ids(const Array<Vec3f>& points, ThreadPool& pool);

}  // namespace blysk
