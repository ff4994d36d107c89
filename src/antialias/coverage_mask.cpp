#include "antialias/coverage_mask.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace blysk::antialias {

TriangleCoverage::TriangleCoverage(std::array<Subpixel, 3> corners, const SamplePattern& pattern, int unit)
    : pattern_(&pattern), unit_(unit), area_(doubled_area(corners)) {
  if (area_ < 0) {
    std::swap(corners[1], corners[2]);
    area_ = -area_;
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const Subpixel &a = corners[k], &b = corners[(k + 1) % 3];
    Edge& e = edges_[k];
    e.dx = b.x - a.x;
    e.dy = b.y - a.y;
    const bool owns_its_samples = e.dy < 0 || (e.dy == 0 && e.dx > 0);
    e.at = e.dy * a.x - e.dx * a.y - (owns_its_samples ? 0 : 1);
    e.reach = 0;
    for (std::size_t s = 0; s < pattern.count; ++s) {
      e.offset[s] = (e.dx * pattern.y[s] - e.dy * pattern.x[s]) * (unit / 256);
      e.reach = std::max<std::int64_t>(e.reach, std::abs(e.offset[s]));
    }
  }
}

Mask TriangleCoverage::mask(int column, int row) const {
  if (area_ == 0) return 0;
  const std::int64_t x = unit_ * column + unit_ / 2, y = unit_ * row + unit_ / 2;
  Mask inside = pattern_->full();
  for (const Edge& e : edges_) {
    const std::int64_t centre = e.dx * y - e.dy * x + e.at;
    if (centre >= e.reach) continue;
    if (centre < -e.reach) return 0;
    Mask right_side = 0;
    for (std::size_t s = 0; s < pattern_->count; ++s) {
      right_side |= static_cast<Mask>(centre + e.offset[s] >= 0) << s;
    }
    inside &= right_side;
  }
  return inside;
}

DepthPlane depth_plane(const std::array<Subpixel, 3>& c, const std::array<double, 3>& z, int unit) {
  const double scale = unit / static_cast<double>(doubled_area(c));
  const auto side = [](std::int64_t to, std::int64_t from) { return static_cast<double>(to - from); };
  return {.z = z[0],
          .zx = ((z[1] - z[0]) * side(c[2].y, c[0].y) - (z[2] - z[0]) * side(c[1].y, c[0].y)) * scale,
          .zy = (side(c[1].x, c[0].x) * (z[2] - z[0]) - side(c[2].x, c[0].x) * (z[1] - z[0])) * scale,
          .origin = c[0],
          .unit = unit};
}

}  // namespace blysk::antialias
