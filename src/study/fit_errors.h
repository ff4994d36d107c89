// study/fit_errors.h - the largest errors of the papers' approximations, by dense sampling of their range.
#pragma once

#include <functional>

#include "study/walks_rows.h"

namespace blysk::study {

/// Relative error of a form of 1 / sqrt(1 + m) over -0.5..0.
[[nodiscard]] double root_error(Root root);
/// Relative error of the length after relief formula (1), K in 0.499..1, and after Lyon's (3 - K) / 2.
[[nodiscard]] double normalisation_error();
[[nodiscard]] double lyon_error();
/// Length error of the mid vector between unit vectors up to 90 degrees apart.
[[nodiscard]] double mid_vector_error();
/// Length error of half the sum of two unit vectors so far apart.
[[nodiscard]] double half_sum_error(double angle_deg);
/// Of the per-fragment paper's parabolas (14) for the cosine of a row's step, and (11) for its weight, and of
/// the lengths of the vectors that both lead to; rows of up to 90 degrees.
[[nodiscard]] double step_cosine_error();
[[nodiscard]] double step_weight_error();
[[nodiscard]] double chebyshev_row_error();
/// Of 43/128 for 1/3, relative; and of a constant intensity of 1 at the end of a row by the printed cubic.
[[nodiscard]] double third_error();
[[nodiscard]] double printed_cubic_error();

/// Errors of a lobe against the exact power at shininess n: largest absolute one over all angles, largest
/// relative one where the power is at least 0.5 ("centre"), largest absolute one between 0.25 and 0.5
/// ("bloom").
struct LobeErrors {
  double largest = 0, centre = 0, bloom = 0;
};
[[nodiscard]] LobeErrors lobe_errors(const std::function<double(double cosine)>& lobe, double n);

}  // namespace blysk::study
