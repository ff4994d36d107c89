// blysk/metrics.h - how far a picture is from its reference.
#pragma once

#include <cstdint>
#include <string_view>

#include "blysk/image.h"

namespace blysk {

struct Difference {
  /// Normalised mean square error: the sum of squared differences over the sum of squared reference values,
  /// both over red, green and blue of all pixels (shading thesis, chapter 4.3, the formula before Table 4.1).
  /// Against a black reference 0 if the candidate is black too, else infinity.
  double nmse = 0;
  double psnr_db = 0;                  ///< of red, green and blue; peak 255; infinity if they are equal
  int max_difference = 0;              ///< largest of any channel, alpha included, 0..255
  std::uint64_t different_pixels = 0;  ///< alpha included
};

/// Compares two pictures of one size; ErrorCode::input if the sizes differ. Sums are integers: no order
/// shows.
[[nodiscard]] Result<Difference> compare(const Image& reference, const Image& candidate);

/// What the thesis' Table 4.1 calls such a picture: "look the same" (NMSE up to 0.0001), "slight differences"
/// (0.00025), "noticeably different" (0.001), "completely different".
[[nodiscard]] std::string_view nmse_class(double nmse);

}  // namespace blysk
