#include "shading/lighting_texture_reference.h"

#include <algorithm>
#include <cmath>

namespace blysk::reference {

int texture_steps(int finest, double texel, double longest_squared, double area) {
  int steps = 0;
  for (int n = 1; n <= finest; n *= 2) {
    if (longest_squared >= texel * n * texel * n) steps = n;
  }
  return area >= kTexturePay * triangle_points(steps) ? steps : 0;
}

int paper_level(double longest) {
  return static_cast<int>(std::clamp(std::floor(std::log2(16 / longest)), 0.0, 4.0));
}

int square_points(int steps) { return (steps + 1) * (steps + 1); }
int triangle_points(int steps) { return (steps + 1) * (steps + 2) / 2; }

}  // namespace blysk::reference
