// blysk/metrics.h - how far a picture is from its reference.
#pragma once

#include "blysk/image.h"

namespace blysk {

struct Difference {
  double nmse = 0;        ///< sum of squared differences over sum of squared reference (RGB)
  double psnr_db = 0;     ///< peak 255; infinity for equal pictures
  int max_difference = 0; ///< largest of any channel, alpha included, 0..255
  std::uint64_t different_pixels = 0;
};

/// Compares two pictures of one size; ErrorCode::input if the sizes differ.
[[nodiscard]] Result<Difference> compare(const Image& reference, const Image& candidate);

}  // namespace blysk
