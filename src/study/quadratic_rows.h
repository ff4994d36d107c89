// study/quadratic_rows.h - the second-order surface along a row by each formula that table 2.1 of the thesis
// counts (section 4.3 of the specification).
#pragma once

#include <span>
#include <string_view>

#include "shading/quadratic_reference.h"
#include "study/counted.h"

namespace blysk::study {

enum class QuadraticForm { direct, horner, step, pair, triple, values, values_shift, forward };

/// Formula number as the thesis prints it.
inline std::string_view formula_of(QuadraticForm form) {
  constexpr std::string_view kFormulas[] = {"(2.2)", "(2.9)", "(2.3)",           "(2.5)",
                                            "(2.7)", "(2.8)", "(2.8) optimised", "forward differences"};
  return kFormulas[static_cast<int>(form)];
}

/// Pixels x, x + 1, ... of row y; at least four. C y is kept from the first of them; 2 A and 4 A are found
/// anew at every pixel, as the thesis counts, but for forward differences.
template <class T>
void quadratic_row(QuadraticForm form, const reference::SecondOrderSurfaceOf<T>& s, T x, T y,
                   std::span<T> out) {
  if (form == QuadraticForm::direct || form == QuadraticForm::horner) {
    for (T& i : out) {
      i = form == QuadraticForm::horner ? s.at(x, y)
                                        : s.a * x * x + s.b * y * y + s.c * x * y + s.d * x + s.e * y + s.f;
      x = next_input(x);
    }
    return;
  }
  const T cy = s.c * y;
  out[0] = x * (s.a * x + cy + s.d) + y * (s.b * y + s.e) + s.f;
  if (form == QuadraticForm::forward) {
    T difference = 2 * s.a * x + s.a + cy + s.d;
    const T bend = 2 * s.a;
    for (std::size_t k = 1; k < out.size(); ++k) {
      out[k] = out[k - 1] + difference;
      difference = difference + bend;
    }
    return;
  }
  for (std::size_t k = 1; k < out.size(); ++k) {
    const T a = out[k - 1];
    if (form == QuadraticForm::step || k == 1) {
      out[k] = a + (2 * s.a * x + s.a + cy + s.d);
      x = next_input(x);
      continue;
    }
    const T b = out[k - 2];
    if (form == QuadraticForm::pair || k == 2) {
      out[k] = 2 * a - b + 2 * s.a;
      continue;
    }
    const T c = out[k - 3];
    if (form == QuadraticForm::triple) out[k] = a + b - c + 4 * s.a;
    if (form == QuadraticForm::values) out[k] = T(3) * a - T(3) * b + c;
    if (form == QuadraticForm::values_shift) out[k] = 2 * a + a - 2 * b - b + c;
  }
}

}  // namespace blysk::study
