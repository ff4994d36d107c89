#include "lighting/set_lobe.h"

#include <algorithm>
#include <iterator>

namespace blysk {
namespace {

// max(0, 1 - factor * (n + offset) * t)^exponent, where t is 1 - cos(gamma), for the quadratic lobe gamma^2.
struct EndingLobe {
  Lobe lobe;
  float factor, offset;
  int exponent;
  float above;  // the least n
};

// W(n, gamma): (n + 1) / (k + 1), for k = 4, 8 and 16 by shifts alone (relief thesis, section 4.2 of the
// specification). The others: shading thesis, section 8.2, with the scales of the least error.
constexpr EndingLobe kEnding[] = {
    {Lobe::w3, 1.0f / 4, 1, 3, 3},
    {Lobe::w4, 1.0f / 4 - 1.0f / 16 + 1.0f / 64 - 1.0f / 256, 1, 4, 4},
    {Lobe::w7, 1.0f / 8, 1, 7, 7},
    {Lobe::w8, 1.0f / 8 - 1.0f / 64 + 1.0f / 512, 1, 8, 8},
    {Lobe::w15, 1.0f / 16, 1, 15, 15},
    {Lobe::w16, 1.0f / 16 - 1.0f / 256, 1, 16, 16},
    {Lobe::quadratic, 0.178f, 0, 2, 2.28f},  // 1 / (0.178 * (pi / 2)^2)
    {Lobe::cosine_squared, 1 / 2.81f, 0, 2, 2.81f},
};

}  // namespace

void set_lobe(Surface& s, Lobe lobe) {
  s.lobe = lobe;
  s.lobe_scale = 0;
  s.lobe_exponent = 0;
  const auto* found = std::ranges::find(kEnding, lobe, &EndingLobe::lobe);
  if (found == std::end(kEnding)) return;
  if (!(s.shininess > found->above)) {
    s.lobe = Lobe::power;
    return;
  }
  s.lobe_scale = found->factor * (s.shininess + found->offset);
  s.lobe_exponent = found->exponent;
}

}  // namespace blysk
