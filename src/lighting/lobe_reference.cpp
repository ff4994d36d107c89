#include "lighting/lobe_reference.h"

#include <algorithm>
#include <cmath>

namespace blysk::reference {

double power_lobe(double c, double n) { return std::pow(c, n); }  // deterministic: tests only

double w_scale(double n, int k) { return (n + 1) / (k + 1); }

double w_shift_scale(double n, int k) {
  const double m = n + 1;
  switch (k) {
    case 4:
      return m / 4 - m / 16 + m / 64 - m / 256;
    case 8:
      return m / 8 - m / 64 + m / 512;
    case 16:
      return m / 16 - m / 256;
    default:
      return w_scale(n, k);
  }
}

double logarithmic_lobe(double c, double n) {
  int exponent = 0;
  const double mantissa = 2 * std::frexp(c, &exponent);  // [1, 2)
  const double log_power = n * (exponent - 1 + (mantissa - 1));
  const double whole = std::floor(log_power);
  return std::ldexp(1 + (log_power - whole), static_cast<int>(whole));
}

double quadratic_lobe(double c, double n, double s) {
  const double gamma = std::acos(c);  // deterministic: tests only
  return integer_power(std::max(0.0, 1 - s * n * gamma * gamma), 2);
}

double specular_lobe(Lobe lobe, double c, double n) {
  if (!(c > 0)) return 0;
  const auto w = [&](int k) { return n > k ? w_lobe(c, w_shift_scale(n, k), k) : power_lobe(c, n); };
  switch (lobe) {
    case Lobe::power:
      return power_lobe(c, n);
    case Lobe::schlick:
      return schlick_lobe(c, n);
    case Lobe::w3:
      return w(3);
    case Lobe::w4:
      return w(4);
    case Lobe::w7:
      return w(7);
    case Lobe::w8:
      return w(8);
    case Lobe::w15:
      return w(15);
    case Lobe::w16:
      return w(16);
    case Lobe::logarithmic:
      return logarithmic_lobe(c, n);
    case Lobe::quadratic:
      return n > 2.28 ? quadratic_lobe(c, n) : power_lobe(c, n);
    case Lobe::cosine_squared:
      return n > 2.81 ? cosine_squared_lobe(c, n) : power_lobe(c, n);
  }
  return 0;
}

}  // namespace blysk::reference
