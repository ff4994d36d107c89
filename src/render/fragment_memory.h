// render/fragment_memory.h - what a picture's lists of fragments would take, in the paper's layout and ours.
#pragma once

#include <cstdint>

#include "antialias/fragment_tile.h"
#include "blysk/fragments.h"
#include "render/frame.h"

namespace blysk {

struct PictureSize {
  int width, height;
};

/// `fullest_pool` is the most slots in use in any tile.
[[nodiscard]] FragmentMemory fragment_memory(const ListPlan& plan, PictureSize size,
                                             const antialias::ListStatistics& lists,
                                             std::uint64_t fullest_pool);

}  // namespace blysk
