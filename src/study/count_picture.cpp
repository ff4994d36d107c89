#include "study/count_picture.h"

#include <algorithm>

namespace blysk::study {

Image count_picture(const std::vector<std::uint32_t>& counts, int width) {
  constexpr std::uint32_t kColors[] = {0xff000000, 0xffe06020, 0xff40b030,
                                       0xff20e0f0, 0xff1090f0, 0xff2020d0};
  Image image;
  image.resize(width, static_cast<int>(counts.size()) / width);
  std::ranges::transform(counts, image.pixels.begin(), [&](std::uint32_t n) {
    return kColors[std::min<std::size_t>(n, std::size(kColors) - 1)];
  });
  return image;
}

}  // namespace blysk::study
