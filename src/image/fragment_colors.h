// image/fragment_colors.h - the false colours of how many fragments a pixel has.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>

namespace blysk {

/// Of 0, 1, 2, 3, 4, and 5 or more: black, blue, green, yellow, orange, red (A-buffer paper, specification
/// A.10).
inline constexpr std::uint32_t kFragmentColors[] = {0xff000000, 0xffe06020, 0xff40b030,
                                                    0xff20e0f0, 0xff1090f0, 0xff2020d0};

constexpr std::uint32_t fragment_color(std::uint32_t fragments) {
  return kFragmentColors[std::min<std::size_t>(fragments, std::size(kFragmentColors) - 1)];
}

}  // namespace blysk
