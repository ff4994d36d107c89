// shading/cubic_reference.h - the cubic polynomial of a row, in double precision.
//
// Specification of the shading thesis, sections 5.1 and 5.2.
#pragma once

namespace blysk::reference {

/// At 0, 1, 1/2 and 1/4 of a row.
struct FourSamples {
  double i1, i2, i3, i4;
};

/// ((a p + b) p + c) p + d, p = 0 at the first pixel's centre and 1 at the last one's.
struct RowCubic {
  double a, b, c, d;

  [[nodiscard]] double at(double p) const { return p * (p * (p * a + b) + c) + d; }
};

/// The robust form: any `third` keeps both ends and every parabola exact.
inline RowCubic row_cubic(const FourSamples& i, double third = 1.0 / 3) {
  const double u = (i.i2 - 3 * i.i1 - 6 * i.i3 + 8 * i.i4) * third;
  const double a = 8 * u, c = u + 2 * (4 * i.i4 - 3 * i.i1 - i.i3);
  return {a, i.i2 - i.i1 - a - c, c, i.i1};
}

/// The form that the thesis prints; a third that is not exact shows (erratum E14).
inline RowCubic printed_row_cubic(const FourSamples& i, double third = 1.0 / 3) {
  return {8 * (i.i2 + 8 * i.i4) * third - 8 * (i.i1 + 2 * i.i3),
          2 * (7 * i.i1 - i.i2 + 10 * i.i3 - 16 * i.i4), (i.i2 + 32 * i.i4) * third - 7 * i.i1 - 4 * i.i3,
          i.i1};
}

}  // namespace blysk::reference
