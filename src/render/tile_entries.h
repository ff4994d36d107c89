// render/tile_entries.h - the triangles of a tile in the order in which they were submitted.
#pragma once

#include <span>
#include <vector>

#include "antialias/glass.h"
#include "render/frame.h"

namespace blysk {

/// Replaces `to` by the entries of some of a tile's lists, in ascending order of ids whichever thread has
/// which, with their draws' opacities.
void gather_entries(const FramePlan& plan, const TileJob& job, std::span<const Stream> streams,
                    std::vector<GlassEntry>& to);

/// Adds each DotEntry of a tile to its pixel's count.
void count_dots(const TileJob& job, std::uint32_t* counts);

}  // namespace blysk
