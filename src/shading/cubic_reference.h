// shading/cubic_reference.h - the cubic polynomial of a row, in double precision.
//
// Specification of the shading thesis, sections 5.1 and 5.2.
#pragma once

#include <type_traits>

namespace blysk::reference {

/// At 0, 1, 1/2 and 1/4 of a row.
template <class T>
struct FourSamplesOf {
  T i1, i2, i3, i4;
};
using FourSamples = FourSamplesOf<double>;

/// ((a p + b) p + c) p + d, p = 0 at the first pixel's centre and 1 at the last one's.
template <class T>
struct RowCubicOf {
  T a, b, c, d;

  [[nodiscard]] T at(T p) const { return p * (p * (p * a + b) + c) + d; }
};
using RowCubic = RowCubicOf<double>;

/// The robust form: any `third` keeps both ends and every parabola exact.
template <class T = double>
RowCubicOf<T> row_cubic(const FourSamplesOf<T>& i, std::type_identity_t<T> third = T(1.0 / 3)) {
  const T u = (i.i2 - 3 * i.i1 - 6 * i.i3 + 8 * i.i4) * third;
  const T a = 8 * u, c = u + 2 * (4 * i.i4 - 3 * i.i1 - i.i3);
  return {a, i.i2 - i.i1 - a - c, c, i.i1};
}

/// The form that the thesis prints; a third that is not exact shows (erratum E14).
template <class T = double>
RowCubicOf<T> printed_row_cubic(const FourSamplesOf<T>& i, std::type_identity_t<T> third = T(1.0 / 3)) {
  return {8 * (i.i2 + 8 * i.i4) * third - 8 * (i.i1 + 2 * i.i3),
          2 * (7 * i.i1 - i.i2 + 10 * i.i3 - 16 * i.i4), (i.i2 + 32 * i.i4) * third - 7 * i.i1 - 4 * i.i3,
          i.i1};
}

}  // namespace blysk::reference
