// fragment_report.h - what a frame's pixels had to hold, for programs and in words.
#pragma once

#include "blysk/render.h"
#include "json.h"

namespace blysk::command {

/// `fragments` of --json. Distributions are there where they were counted.
[[nodiscard]] Json fragments_json(const FrameStatistics& statistics);

/// Memory of the main and the common buffer; of methods that have them.
[[nodiscard]] Json buffers_json(const FrameStatistics& statistics);

/// Says what there is to say of all that.
void say_fragments(const FrameStatistics& statistics);

}  // namespace blysk::command
