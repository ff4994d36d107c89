// shading/curved_light_reference.h - the bound of docs/auto.md for surfaces, where light and viewer are at
// infinity and the picture is linear on the screen: perspective and the viewer's turn add nothing there.
#pragma once

#include <algorithm>
#include <cmath>

#include "shading/linear_light_reference.h"

namespace blysk::reference {

/// Least value of something in a triangle and its first three derivatives on the longest way through it.
struct Jet {
  double least, first, second, third;
};

inline Jet operator+(const Jet& a, const Jet& b) {
  return {a.least + b.least, a.first + b.first, a.second + b.second, a.third + b.third};
}
inline Jet operator*(double k, const Jet& j) { return {k * j.least, k * j.first, k * j.second, k * j.third}; }

/// How an interpolated normal turns on that way.
struct NormalTurn {
  double across, along, stretch;

  /// Of unit normals.
  explicit NormalTurn(const Vec3d (&normal)[3]) {
    const double bow = largest_bow(normal), square = bow / 0.18;
    stretch = 1 + bow;
    across = std::sqrt(square) * stretch;
    along = 1.13 * square / 2 * stretch;
  }

  /// The third derivative of a cosine against a fixed direction, by its sine and itself.
  [[nodiscard]] double third(double sine, double cosine) const {
    const double a = along, b = across;
    return 6 * a * b * b * cosine + std::max(6 * a * a, 3 * b * b) * b * sine;
  }
};

inline double sine_of(double cosine) {
  const double c = std::max(cosine - kRootShift, 0.0);
  return std::sqrt(std::max(1 - c * c, 1e-6));
}

/// Of N.L.
inline Jet cosine_jet(const NormalTurn& t, const double (&n_l)[3]) {
  const double highest = std::min(most_of(n_l) * t.stretch, 1.0), sine = sine_of(least_of(n_l));
  return {least_of(n_l), t.across * sine, t.across * t.across * highest + 2 * t.along * t.across * sine,
          t.third(sine, highest)};
}

/// Of base^k, base = 1 - scale * (1 - N.H). `l_plus_v` is the length of L + V.
inline Jet lobe_jet(const NormalTurn& t, const double (&n_h)[3], double l_plus_v, double k, double scale) {
  const double slip = kRootShift * (1 + 1 / (l_plus_v * l_plus_v));
  const double low = std::max(least_of(n_h) - slip, 0.0);
  const double high = std::min((most_of(n_h) + slip) * t.stretch, 1.0);
  const auto base = [&](double z) { return std::max(1 - scale * (1 - z), 0.25); };
  // base^of_base sqrt(1 - z^2)^of_sine rises up to its peak and falls after it.
  const auto peak = [&](double of_sine, double of_base) {
    const double p = of_sine * (1 - scale), sum = (of_base + of_sine) * scale;
    const double z = (std::sqrt(p * p + 4 * sum * of_base * scale) - p) / (2 * sum);
    return std::min(std::max(z, low), high);
  };
  const double f1 = k * scale * std::pow(base(high), k - 1);
  const double f2 = k * (k - 1) * scale * scale * std::pow(base(high), k - 2);
  const double third = peak(3, k - 3), second = peak(1, k - 2), b = t.across, sine = sine_of(low);
  const double bending = k * (k - 1) * (k - 2) * std::pow(scale, 3) * std::pow(base(third), k - 3) *
                         std::pow(sine_of(third) * b, 3);
  const double pulling =
      3 * k * (k - 1) * scale * scale * std::pow(base(second), k - 2) * sine_of(second) * b * b * b;
  const double loose = sine * 2 * b * t.along;
  const double least = 1 - scale * (1 - low) > 0.25 ? std::pow(base(low), k) : 0;
  return {least, f1 * b * sine, std::max(f2 * sine * sine, f1) * b * b + f1 * loose,
          std::max(bending, pulling) + 3 * f2 * b * sine * loose +
              f1 * (t.third(sine, 1) + slip * 1.67 / 0.0183)};
}

/// Of the surface through six values of a channel as shown in sRGB.
inline double srgb_surface_bound(const Jet& j) {
  constexpr double kFoot = 0.0031308;
  const double least = std::max(j.least, kFoot), share = j.first / least;
  const double third = share * (0.924 * share * j.first + 1.75 * j.second) + j.third;
  return 0.0183 * 0.44 * std::pow(least, 1 / 2.4 - 1) * third + (j.least < kFoot ? 35 * j.first : 0);
}

/// The same of a channel shown as it is.
inline double surface_bound(const Jet& j) { return 0.0183 * j.third; }

}  // namespace blysk::reference
