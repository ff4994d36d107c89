#include "study/fit_errors.h"

#include <algorithm>
#include <cmath>

#include "math/inverse_length.h"
#include "math/trig.h"
#include "shading/cubic_reference.h"
#include "shading/normals_reference.h"
#include "shading/row_normals_reference.h"

namespace blysk::study {
namespace {

constexpr int kSteps = 200000;

// Largest size of `error` over low..high.
template <class Error>
double largest(double low, double high, Error error) {
  double worst = 0;
  for (int i = 0; i <= kSteps; ++i) {
    worst = std::max(worst, std::abs(error(low + (high - low) * i / kSteps)));
  }
  return worst;
}

double approximate_root(Root root, double m) {
  switch (root) {
    case Root::exact:
      return inverse_root<Root::exact>(m);
    case Root::taylor:
      return inverse_root<Root::taylor>(m);
    case Root::chebyshev:
      return inverse_root<Root::chebyshev>(m);
    case Root::shift:
      return inverse_root<Root::shift>(m);
  }
  return 0;
}

}  // namespace

double root_error(Root root) {
  return largest(-0.5, 0, [&](double m) { return approximate_root(root, m) * std::sqrt(1 + m) - 1; });
}

double normalisation_error() {
  return largest(kInverseLengthPaper.lowest, 1, [](double k) {
    return reference::inverse_length(kInverseLengthPaper, k) * std::sqrt(k) - 1;
  });
}

double lyon_error() {
  return largest(kInverseLengthPaper.lowest, 1, [](double k) { return (3 - k) / 2 * std::sqrt(k) - 1; });
}

double mid_vector_error() {
  return largest(0, 1, [](double c) {
    const Vec3d a = {1, 0, 0}, b = {c, std::sqrt(1 - c * c), 0};
    return length(reference::mid_vector(kMidVectorPaper, a, b)) / 4 - 1;
  });
}

double half_sum_error(double angle_deg) { return 1 - cosine(radians(angle_deg / 2)); }

double step_cosine_error() {
  return largest(0, 1, [](double d) {
    return reference::step_cosine(kChebyshevPaper, d) / reference::exact_step_cosine(d) - 1;
  });
}

double step_weight_error() {
  return largest(reference::exact_step_cosine(0), 1, [](double c) {
    return reference::step_weight(kChebyshevPaper, c) / reference::exact_step_weight(c) - 1;
  });
}

double chebyshev_row_error() {
  return largest(0, 1, [](double d) {
    double worst = 0;
    for (const Vec3d& n :
         reference::chebyshev_row(kChebyshevPaper, {1, 0, 0}, {d, std::sqrt(1 - d * d), 0})) {
      worst = std::max(worst, std::abs(length(n) - 1));
    }
    return worst;
  });
}

double third_error() { return 43.0 / 128 * 3 - 1; }

double printed_cubic_error() {
  return largest(0, 1, [](double p) {
    return reference::printed_row_cubic({1, 1, 1, 1}, 43.0 / 128).at(p) - 1;
  });
}

LobeErrors lobe_errors(const std::function<double(double)>& lobe, double n) {
  LobeErrors e;
  const auto look = [&](double c, double exact) {
    const double error = std::abs(lobe(c) - exact);
    constexpr double kRounding = 1e-12;
    if (exact >= 0.5 - kRounding) e.centre = std::max(e.centre, error / exact);
    if (exact >= 0.25 - kRounding && exact <= 0.5 + kRounding) e.bloom = std::max(e.bloom, error);
    e.largest = std::max(e.largest, error);
  };
  const double end = std::min(kPi / 2, 9 / std::sqrt(n));
  constexpr int kAngles = 20000;
  for (int i = 0; i < kAngles; ++i) {
    const double c = cosine(end * i / kAngles);
    look(c, reference::power_lobe(c, n));
  }
  for (const double level : {0.25, 0.5}) {
    look(reference::power_lobe(level, 1 / n), level);  // where the zones end
  }
  return e;
}

}  // namespace blysk::study
