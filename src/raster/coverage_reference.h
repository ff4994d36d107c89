// raster/coverage_reference.h - which pixels a triangle covers, and how near it is there, by the book: exact
// integers and doubles, one pixel at a time.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "blysk/vector.h"
#include "geometry/screen_vertex.h"

namespace blysk::reference {

/// A vertex that has a place on the screen, in 1/256 pixel.
struct Place {
  std::int64_t x, y;
  float nearness;
};

/// What the pipeline's float arithmetic makes of a position; none if the triangle has to be clipped.
inline std::optional<Place> place(const Projection& m, Vec3f p) {
  const auto row = [&](int i) {
    return (m.row[i][0] * p.x + m.row[i][1] * p.y) + (m.row[i][2] * p.z + m.row[i][3]);
  };
  const float w = row(3), q = 1.0f / w, x = row(0) * q, y = row(1) * q, nearness = row(2) * q;
  constexpr auto kGuard = static_cast<float>(kGuardBand);
  const bool placed =
      w > 0 && nearness >= 0 && nearness <= 1 && std::abs(x) <= kGuard && std::abs(y) <= kGuard;
  if (!placed) return std::nullopt;
  return Place{std::llrint(x), std::llrint(y), nearness};
}

struct Triangle {
  std::array<Place, 3> corner;

  /// Twice the area; positive if the corners turn clockwise on the screen.
  [[nodiscard]] std::int64_t area() const {
    const auto& [a, b, c] = corner;
    return (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
  }
};

/// Whether the triangle owns the centre of a pixel. A centre on an edge belongs to the triangle into which an
/// infinitely small step to the right leads, or along a level edge one downwards: the top-left rule.
inline bool covers(const Triangle& t, int column, int row) {
  const std::int64_t area = t.area();
  if (area == 0) return false;
  const std::int64_t px = column * std::int64_t{kSubpixels} + kSubpixels / 2;
  const std::int64_t py = row * std::int64_t{kSubpixels} + kSubpixels / 2;
  for (std::size_t k = 0; k < 3; ++k) {
    const Place &a = t.corner[k], &b = t.corner[(k + 1) % 3];
    const std::int64_t turn = area > 0 ? 1 : -1;
    const std::int64_t dx = turn * (b.x - a.x), dy = turn * (b.y - a.y);
    const std::int64_t side = dx * (py - a.y) - dy * (px - a.x);
    const std::int64_t after_step = dy != 0 ? -dy : dx;
    if (side < 0 || (side == 0 && after_step < 0)) return false;
  }
  return true;
}

/// Calls visit(column, row) for every pixel of a picture that the triangle owns.
template <class Visit>
void for_each_covered(const Triangle& t, int width, int height, Visit visit) {
  const auto& [a, b, c] = t.corner;
  const auto [left, right] = std::minmax({a.x, b.x, c.x});
  const auto [top, bottom] = std::minmax({a.y, b.y, c.y});
  const auto pixel = [](std::int64_t v, int size) {
    return static_cast<int>(std::clamp<std::int64_t>(v >> kSubpixelBits, 0, size - 1));
  };
  for (int y = pixel(top, height); y <= pixel(bottom, height); ++y) {
    for (int x = pixel(left, width); x <= pixel(right, width); ++x) {
      if (covers(t, x, y)) visit(x, y);
    }
  }
}

/// Nearness of the triangle's plane at the centre of a pixel.
inline double nearness_at(const Triangle& t, int column, int row) {
  const double px = column * double{kSubpixels} + kSubpixels / 2.0,
               py = row * double{kSubpixels} + kSubpixels / 2.0;
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Place &a = t.corner[(k + 1) % 3], &b = t.corner[(k + 2) % 3];
    const auto ax = static_cast<double>(a.x), ay = static_cast<double>(a.y);
    const double weight =
        (static_cast<double>(b.x) - ax) * (py - ay) - (static_cast<double>(b.y) - ay) * (px - ax);
    sum += weight * static_cast<double>(t.corner[k].nearness);
  }
  return sum / static_cast<double>(t.area());
}

/// What float arithmetic may make of a depth: rounding, and cancellation in the slopes of slender triangles.
inline double depth_error(const Triangle& t) {
  const auto& [a, b, c] = t.corner;
  const auto [low, high] = std::minmax({a.nearness, b.nearness, c.nearness});
  const auto square = [](const Place& p, const Place& q) {
    const auto dx = static_cast<double>(p.x - q.x), dy = static_cast<double>(p.y - q.y);
    return dx * dx + dy * dy;
  };
  const double longest = std::max({square(a, b), square(b, c), square(c, a)});
  const double range = double{high} - double{low};
  return 3e-7 + range * std::min(1.0, 0x1p-20 * longest / std::abs(static_cast<double>(t.area())));
}

/// A triangle that may cross the planes of the view, in homogeneous screen coordinates (subpixels, nearness,
/// w). M. Olano, T. Greer. Triangle scan conversion using 2D homogeneous coordinates. 1997.
class HomogeneousTriangle {
 public:
  HomogeneousTriangle(const Projection& m, const std::array<Vec3f, 3>& p) {
    Vec3d v[3];
    double z[3];
    for (std::size_t k = 0; k < 3; ++k) {
      const auto row = [&](int i) {
        return double{m.row[i][0]} * double{p[k].x} + double{m.row[i][1]} * double{p[k].y} +
               double{m.row[i][2]} * double{p[k].z} + double{m.row[i][3]};
      };
      v[k] = {row(0), row(1), row(3)};
      z[k] = row(2);
    }
    const double volume = dot(v[0], cross(v[1], v[2]));
    Vec3d nearness;
    for (std::size_t k = 0; k < 3; ++k) {
      edge_[k] = cross(v[(k + 1) % 3], v[(k + 2) % 3]) * (volume < 0 ? -1.0 : 1.0);
      nearness = nearness + edge_[k] * z[k];
    }
    nearness = nearness * (1 / std::abs(volume));
    edge_[3] = nearness;                   // inside: nearness >= 0
    edge_[4] = Vec3d{0, 0, 1} - nearness;  // inside: nearness <= 1
    degenerate_ = !(std::abs(volume) > 0);
  }

  /// How deep inside the triangle the centre of a pixel lies, in subpixels: the least of its distances to the
  /// edges' lines and to the lines along which the near and far planes cut it. Negative outside.
  [[nodiscard]] double depth_inside(int column, int row) const { return depth_inside_but(5, column, row); }

  /// The same, one line left out.
  [[nodiscard]] double depth_inside_but(std::size_t line, int column, int row) const {
    double least = 1e30;
    for (std::size_t k = 0; k < edge_.size(); ++k) {
      if (k != line) least = std::min(least, distance(k, column, row));
    }
    return least;
  }

  /// From one line alone: 0 to 2 are the edges opposite to the corners, 3 is the far plane's, 4 the near
  /// plane's.
  [[nodiscard]] double distance(std::size_t line, int column, int row) const {
    if (degenerate_) return -1e30;
    const double px = column * double{kSubpixels} + kSubpixels / 2.0,
                 py = row * double{kSubpixels} + kSubpixels / 2.0;
    const Vec3d& e = edge_[line];
    const double value = e.x * px + e.y * py + e.z, slope = std::sqrt(e.x * e.x + e.y * e.y);
    return std::abs(value) < 1e30 * slope ? value / slope : std::copysign(1e30, value);
  }

 private:
  std::array<Vec3d, 5> edge_;  ///< coefficients of x, y and 1
  bool degenerate_ = false;
};

}  // namespace blysk::reference
