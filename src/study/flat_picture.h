// study/flat_picture.h - pictures that variants of the A-buffer give of a stream of fragments, and how far
// they are from each other.
#pragma once

#include <cstdint>
#include <vector>

#include "study/flat_raster.h"

namespace blysk::study {

/// What the variants are compared with: 16 samples, the paper's grid, a dark blue background.
inline constexpr const antialias::SamplePattern& kPattern = antialias::kGrid16;
inline constexpr Vec3d kBackground = {32, 32, 64};

using Picture = std::vector<Vec3d>;

[[nodiscard]] Picture picture_of(const FragmentStream& stream, antialias::FragmentTile& tile,
                                 std::size_t pixels);

/// Channels run from 0 to 255 and are not rounded.
struct Quality {
  double nmse = 0, psnr_db = 0;    ///< infinite decibels where there is no difference
  double over_8 = 0, over_32 = 0;  ///< share of pixels with a channel that is farther off
};

/// Sums over pixels, so that parts of a picture may be measured apart.
struct PictureError {
  double squares = 0, reference = 0;
  std::uint64_t pixels = 0, over_8 = 0, over_32 = 0;

  void add(Vec3d shown, Vec3d wanted);
  PictureError& operator+=(const PictureError& other);
  [[nodiscard]] Quality quality() const;
};

/// Of pictures of one size.
[[nodiscard]] PictureError error_of(const Picture& picture, const Picture& reference);

}  // namespace blysk::study
