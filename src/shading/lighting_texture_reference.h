// shading/lighting_texture_reference.h - the lighting texture of a triangle in double precision.
//
// A-buffer specification, C.6 - C.8; what differs stands in lighting_texture_kernel.cpp.
#pragma once

#include <algorithm>

#include "blysk/vector.h"
#include "math/lighting_texture.h"

namespace blysk::reference {

/// Steps of an edge by size: the finest level whose points are `texel` pixels apart along the longest edge,
/// 0 where that does not pay. Squared length of the longest edge in pixels, area in pixels.
int texture_steps(int finest, double texel, double longest_squared, double area);

/// The paper's level for the longest edge: 0 is 17 x 17 points, 4 is 2 x 2.
int paper_level(double longest);

/// Points of a level: of the square and of its half.
int square_points(int steps);
int triangle_points(int steps);

inline int whole_part(double v) { return static_cast<int>(v); }
inline double beyond(double v, int whole) { return v - whole; }
inline int whole_part(float v) { return static_cast<int>(v); }
inline float beyond(float v, int whole) { return v - static_cast<float>(whole); }

/// The points around a place and how much it is of each: bilinear, on cells that the far edge cuts linear.
/// u and v are the shares of corners 1 and 2.
template <class T>
struct TextureCellOf {
  int i, j;  ///< steps towards corners 1 and 2
  bool cut;
  T x, y, xy{};

  /// Outside the triangle the nearest place counts: v first, then u.
  TextureCellOf(int steps, const T& u, const T& v) {
    const T over = std::clamp(v, T(0), T(1));
    const T column = std::clamp(u, T(0), 1 - over) * T(steps), row = over * T(steps);
    j = std::min(whole_part(row), steps - 1);
    i = std::min(whole_part(column), steps - 1 - j);
    cut = i + j + 1 >= steps;
    x = beyond(column, i);
    y = beyond(row, j);
    if (!cut) xy = x * y;
  }
  /// Of what the points hold, `point(i, j)`.
  template <class Point>
  [[nodiscard]] T of(const Point& point) const {
    const T a = point(i, j), along = point(i + 1, j) - a, c = point(i, j + 1);
    const T value = a + x * along + y * (c - a);
    return cut ? value : value + xy * (point(i + 1, j + 1) - c - along);
  }
};

template <class Point>
double fetch_texture(int steps, const Point& point, double u, double v) {
  return TextureCellOf<double>(steps, u, v).of(point);
}

}  // namespace blysk::reference
