// shading/gouraud_constant_reference.h - simplified Gouraud shading as the paper writes it, in double
// precision.
//
// Specification of the A-buffer, sections B.1 to B.3.
#pragma once

#include <array>

#include "blysk/vector.h"

namespace blysk::reference {

/// Intensity at a corner of a triangle, pixels.
template <class T>
struct LitCornerOf {
  T x, y, intensity;
};
using LitCorner = LitCornerOf<double>;

template <class T>
struct ConstantIncrementsOf {
  T area;    ///< det: twice the area; 0: nothing is drawn, dx and dy mean nothing
  T dx, dy;  ///< a pixel to the right, a pixel down
};
using ConstantIncrements = ConstantIncrementsOf<double>;

template <class T = double>
ConstantIncrementsOf<T> constant_increments(const std::array<LitCornerOf<T>, 3>& c) {
  const auto& [a, b, d] = c;
  const T area = (b.x - a.x) * (d.y - a.y) - (d.x - a.x) * (b.y - a.y);
  const T rise_b = b.intensity - a.intensity, rise_d = d.intensity - a.intensity;
  return {area, (rise_b * (d.y - a.y) - rise_d * (b.y - a.y)) / area,
          ((b.x - a.x) * rise_d - (d.x - a.x) * rise_b) / area};
}

/// At the centre of a pixel, with the correction for where the corners lie between pixels.
inline double constant_gouraud(const std::array<LitCorner, 3>& c, int column, int row) {
  const ConstantIncrements i = constant_increments(c);
  return c[0].intensity + (column + 0.5 - c[0].x) * i.dx + (row + 0.5 - c[0].y) * i.dy;
}

}  // namespace blysk::reference
