// blysk/limits.h - how much a caller allows. Reaching a limit is ErrorCode::limit, never a worse picture.
#pragma once

#include <cstdint>

namespace blysk {

struct Limits {
  std::uint64_t max_triangles = 200'000'000;  ///< of one scene, instances counted each
  std::uint64_t max_memory = 16ull << 30;     ///< bytes a reader or the renderer may allocate
};

}  // namespace blysk
