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

/// Structural similarity of the luma (Rec. 601, of the bytes as they are), 1 for equal pictures: the mean
/// over all windows of 11x11 pixels that lie wholly in the picture, weighted by a Gaussian of 1.5 pixels,
/// with K1 = 0.01 and K2 = 0.03. Based on: Wang, Bovik, Sheikh, Simoncelli. Image Quality Assessment: From
/// Error Visibility to Structural Similarity. 2004. Not a number where the pictures differ and no window fits
/// in; ErrorCode::input if the sizes differ. Sums run in one order.
[[nodiscard]] Result<double> ssim(const Image& reference, const Image& candidate);

/// The candidate's error map in false colours, a colour bar with a labelled scale to its right: of each pixel
/// the largest difference of any channel, alpha included. Equal pixels are black, the smallest difference is
/// already blue, `full_scale` (1..255) and more is pale yellow; 0 takes the largest difference there is. The
/// picture stands at the top left, pixel for pixel. ErrorCode::limit where the bar would exceed
/// kMaxPictureSide.
[[nodiscard]] Result<Image> difference_picture(const Image& reference, const Image& candidate,
                                               int full_scale = 0);

/// What the thesis' Table 4.1 calls such a picture: "look the same" (NMSE up to 0.0001), "slight differences"
/// (0.00025), "noticeably different" (0.001), "completely different".
[[nodiscard]] std::string_view nmse_class(double nmse);

}  // namespace blysk
