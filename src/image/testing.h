// image/testing.h - what tests of pictures look at.
#pragma once

#include <cstddef>
#include <cstdint>

#include "blysk/image.h"

namespace blysk {

/// The pixel of column x and row y, from the top left.
inline std::uint32_t at(const Image& image, int x, int y) {
  return image.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                      static_cast<std::size_t>(x)];
}

}  // namespace blysk
