// scene/weld.h - which of many points are the same.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "blysk/array.h"
#include "blysk/vector.h"
#include "core/threads.h"

namespace blysk {

/// Points in memory as they lie in a file: groups of packed floats x, y, z (host byte order), `stride` bytes
/// from one group to the next, at any alignment.
struct PackedPoints {
  const std::byte* first = nullptr;
  std::size_t groups = 0;
  std::size_t points_per_group = 1;
  std::size_t stride = sizeof(Vec3f);

  [[nodiscard]] std::size_t size() const { return groups * points_per_group; }
};

struct Welded {
  Array<Vec3f> positions;    ///< the distinct points in the order of their first appearance; -0 becomes 0
  Array<std::uint32_t> ids;  ///< for every point its place in `positions`
};

/// Welds points that are exactly equal (0 equals -0; a NaN equals itself bit by bit). At most 2^32 - 2
/// points. The result does not depend on the number of threads. Cost: linear; n log n where somebody built
/// the points so that they collide.
[[nodiscard]] Welded weld(const PackedPoints& points, ThreadPool& pool);

struct WeldedIds {
  Array<std::uint32_t> ids;
  std::size_t count = 0;  ///< of distinct points
};

/// The same for callers who want to know no more than which points are equal.
[[nodiscard]] WeldedIds weld_ids(const PackedPoints& points, ThreadPool& pool);

}  // namespace blysk
