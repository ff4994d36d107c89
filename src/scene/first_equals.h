// scene/first_equals.h - which points of a mesh lie where an earlier one does.
#pragma once

#include <cstdint>

#include "blysk/array.h"
#include "blysk/vector.h"
#include "core/threads.h"

namespace blysk {

/// For every point the first one that equals it (0 equals -0; a NaN equals itself bit by bit), which may be
/// itself; empty where all points differ. At most 2^32 - 2 points. The result does not depend on the number
/// of threads. For meshes, few of whose points are equal: there it is several times as fast as weld_ids().
[[nodiscard]] Array<std::uint32_t> first_equals(const Array<Vec3f>& points, ThreadPool& pool);

}  // namespace blysk
