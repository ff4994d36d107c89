// study/count_picture.h - how many fragments each pixel holds, in false colours.
#pragma once

#include <cstdint>
#include <vector>

#include "blysk/image.h"

namespace blysk::study {

/// 0 black, 1 blue, 2 green, 3 yellow, 4 orange, 5 and more red.
[[nodiscard]] Image count_picture(const std::vector<std::uint32_t>& counts, int width);

}  // namespace blysk::study
