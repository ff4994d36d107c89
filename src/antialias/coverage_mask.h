// antialias/coverage_mask.h - which samples of a pixel a triangle covers, and its plane of depths.
#pragma once

#include <array>
#include <cstdint>

#include "antialias/sample_patterns.h"
#include "blysk/vector.h"

namespace blysk::antialias {

/// A place on the screen in 1/256 pixel, or in 1/`unit` pixel where a unit is given. |x|, |y| <= 2^24, so
/// that edge functions stay below 2^52.
struct Subpixel {
  std::int64_t x = 0, y = 0;
};

/// Three half-planes in exact integers, top-left rule at samples: every sample of a mesh belongs to just one
/// of the triangles around it.
class TriangleCoverage {
 public:
  /// `unit`: a multiple of 256.
  TriangleCoverage(std::array<Subpixel, 3> corners, const SamplePattern& pattern, int unit = 256);

  [[nodiscard]] bool empty() const { return area_ == 0; }  ///< no area, no samples
  [[nodiscard]] Mask mask(int column, int row) const;      ///< 0 if empty()

 private:
  struct Edge {
    std::int64_t dx, dy, at;  // of its first corner: value(x, y) = dx * y - dy * x + at
    std::int64_t reach;       // largest |offset|
    std::array<std::int64_t, kMostSamples> offset;
  };
  const SamplePattern* pattern_;
  std::int64_t unit_, area_;
  std::array<Edge, 3> edges_;
};

/// Depths of a triangle as a plane over the screen.
struct DepthPlane {
  double z = 0, zx = 0, zy = 0;  ///< at `origin`, and a pixel to the right and down
  Subpixel origin;
  int unit = 256;

  /// At a pixel's centre.
  [[nodiscard]] double at(int column, int row) const {
    const double right = static_cast<double>(unit * std::int64_t{column} + unit / 2 - origin.x) / unit;
    const double down = static_cast<double>(unit * std::int64_t{row} + unit / 2 - origin.y) / unit;
    return z + right * zx + down * zy;
  }
};

/// The corners must span an area.
[[nodiscard]] DepthPlane depth_plane(const std::array<Subpixel, 3>& corners, const std::array<double, 3>& z,
                                     int unit = 256);

/// Twice the area in units squared, positive where corners turn clockwise on the screen.
[[nodiscard]] inline std::int64_t doubled_area(const std::array<Subpixel, 3>& c) {
  return (c[1].x - c[0].x) * (c[2].y - c[0].y) - (c[2].x - c[0].x) * (c[1].y - c[0].y);
}

}  // namespace blysk::antialias
