#include "math/noise.h"

#include <array>
#include <cstdint>

namespace blysk {
namespace {

constexpr std::array<std::uint8_t, 256> kPermutation = {
    151, 160, 137, 91,  90,  15,  131, 13,  201, 95,  96,  53,  194, 233, 7,   225, 140, 36,  103, 30,
    69,  142, 8,   99,  37,  240, 21,  10,  23,  190, 6,   148, 247, 120, 234, 75,  0,   26,  197, 62,
    94,  252, 219, 203, 117, 35,  11,  32,  57,  177, 33,  88,  237, 149, 56,  87,  174, 20,  125, 136,
    171, 168, 68,  175, 74,  165, 71,  134, 139, 48,  27,  166, 77,  146, 158, 231, 83,  111, 229, 122,
    60,  211, 133, 230, 220, 105, 92,  41,  55,  46,  245, 40,  244, 102, 143, 54,  65,  25,  63,  161,
    1,   216, 80,  73,  209, 76,  132, 187, 208, 89,  18,  169, 200, 196, 135, 130, 116, 188, 159, 86,
    164, 100, 109, 198, 173, 186, 3,   64,  52,  217, 226, 250, 124, 123, 5,   202, 38,  147, 118, 126,
    255, 82,  85,  212, 207, 206, 59,  227, 47,  16,  58,  17,  182, 189, 28,  42,  223, 183, 170, 213,
    119, 248, 152, 2,   44,  154, 163, 70,  221, 153, 101, 155, 167, 43,  172, 9,   129, 22,  39,  253,
    19,  98,  108, 110, 79,  113, 224, 232, 178, 185, 112, 104, 218, 246, 97,  228, 251, 34,  242, 193,
    238, 210, 144, 12,  191, 179, 162, 241, 81,  51,  145, 235, 249, 14,  239, 107, 49,  192, 214, 31,
    181, 199, 106, 157, 184, 84,  204, 176, 115, 121, 50,  45,  127, 4,   150, 254, 138, 236, 205, 93,
    222, 114, 67,  29,  24,  72,  243, 141, 128, 195, 78,  66,  215, 61,  156, 180,
};

unsigned permuted(unsigned index) { return kPermutation[index & 255]; }

// The twelve directions to the middles of a cube's edges, four of them twice.
Vec3d direction(unsigned hash) {
  const unsigned h = hash & 15;
  const double first = (h & 1) != 0 ? -1 : 1, second = (h & 2) != 0 ? -1 : 1;
  Vec3d d;
  (h < 8 ? d.x : d.y) += first;
  (h < 4 ? d.y : (h == 12 || h == 14 ? d.x : d.z)) += second;
  return d;
}

// Weights of the two lattice planes around a coordinate, and how they change along it.
struct Axis {
  unsigned cell;
  double offset[2];
  double weight[2];
  double slope[2];
};

Axis axis(double x) {
  auto whole = static_cast<std::int64_t>(x);
  if (static_cast<double>(whole) > x) --whole;
  const double t = x - static_cast<double>(whole);
  const double fade = t * t * t * (t * (t * 6 - 15) + 10);
  const double slope = 30 * t * t * (t * (t - 2) + 1);
  return {static_cast<unsigned>(whole & 255), {t, t - 1}, {1 - fade, fade}, {-slope, slope}};
}

}  // namespace

Noise gradient_noise(Vec3d p) {
  const Axis x = axis(p.x), y = axis(p.y), z = axis(p.z);
  Noise noise{0, {0, 0, 0}};
  for (unsigned corner = 0; corner < 8; ++corner) {
    const unsigned i = corner & 1, j = corner >> 1 & 1, k = corner >> 2;
    const Vec3d d = direction(permuted(permuted(permuted(x.cell + i) + y.cell + j) + z.cell + k));
    const double plane = d.x * x.offset[i] + d.y * y.offset[j] + d.z * z.offset[k];
    const double weight = x.weight[i] * y.weight[j] * z.weight[k];
    noise.value += weight * plane;
    noise.gradient.x += x.slope[i] * y.weight[j] * z.weight[k] * plane + weight * d.x;
    noise.gradient.y += x.weight[i] * y.slope[j] * z.weight[k] * plane + weight * d.y;
    noise.gradient.z += x.weight[i] * y.weight[j] * z.slope[k] * plane + weight * d.z;
  }
  return noise;
}

}  // namespace blysk
