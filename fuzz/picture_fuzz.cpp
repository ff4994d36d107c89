// Hostile pictures: a whole picture or one line of error, and memory in proportion.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <string>

#include "blysk/image.h"
#include "blysk/metrics.h"

namespace {

void require(bool promise) {
  if (!promise) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::span bytes(reinterpret_cast<const std::byte*>(data), size);
  const blysk::Result<blysk::Image> image = blysk::read_picture(bytes, "x");
  if (!image) {
    require(!image.error().message.empty() && image.error().message.find('\n') == std::string::npos);
    return 0;
  }
  const std::uint64_t width = static_cast<std::uint64_t>(image->width);
  const std::uint64_t height = static_cast<std::uint64_t>(image->height);
  require(width >= 1 && height >= 1 && width <= blysk::kMaxPictureSide && height <= blysk::kMaxPictureSide);
  require(width * height == image->pixels.size() && width * height <= blysk::kMaxPixelsRead);
  // A PNG's byte inflates to 1032 at most, which are 8 pixels each; its rows begin with a byte more.
  require(width * height <= 8 * 1033 * size);
  require(blysk::compare(*image, *image)->different_pixels == 0);
  return 0;
}
