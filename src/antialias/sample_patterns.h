// antialias/sample_patterns.h - where the samples of a pixel lie.
//
// Offsets are whole 256ths of a pixel, so that coverage is exact and depths take offsets that a float holds
// exactly. Bit s of a mask belongs to sample s.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace blysk::antialias {

using Mask = std::uint32_t;

inline constexpr std::size_t kMostSamples = 32;

struct SamplePattern {
  std::string_view name;
  std::size_t count = 0;
  std::array<int, kMostSamples> x{}, y{};    ///< from the pixel's centre, in 1/256 pixel, y down
  std::array<float, kMostSamples> a{}, b{};  ///< the same in pixels
  float reach_a = 0, reach_b = 0;            ///< largest |a| and |b|

  [[nodiscard]] constexpr Mask full() const { return count == 32 ? ~Mask{0} : (Mask{1} << count) - 1; }

  constexpr void add(int to_x, int to_y) {
    x[count] = to_x;
    y[count] = to_y;
    a[count] = static_cast<float>(to_x) / 256.0f;
    b[count] = static_cast<float>(to_y) / 256.0f;
    const float far_a = a[count] < 0 ? -a[count] : a[count], far_b = b[count] < 0 ? -b[count] : b[count];
    reach_a = far_a > reach_a ? far_a : reach_a;
    reach_b = far_b > reach_b ? far_b : reach_b;
    ++count;
  }
};

[[nodiscard]] inline int samples_in(Mask mask) { return std::popcount(mask); }

namespace detail {

constexpr SamplePattern grid(std::string_view name, int columns, int rows) {
  SamplePattern p;
  p.name = name;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      p.add((2 * column + 1 - columns) * 128 / columns, (2 * row + 1 - rows) * 128 / rows);
    }
  }
  return p;
}

// The usual 16 places of hardware multisampling, moved by 1/32 pixel so that their centre is the pixel's.
constexpr SamplePattern rooks() {
  constexpr int kPlaces[16][2] = {{1, 1},  {-1, -3}, {-3, 2},  {4, -1}, {-5, -2}, {2, 5},  {5, 3}, {3, -5},
                                  {-2, 6}, {0, -7},  {-4, -6}, {-6, 4}, {-8, 0},  {7, -4}, {6, 7}, {-7, -8}};
  SamplePattern p;
  p.name = "rooks16";
  for (const auto& [px, py] : kPlaces) p.add(16 * px + 8, 16 * py + 8);
  return p;
}

constexpr SamplePattern centre() {
  SamplePattern p;
  p.name = "centre";
  p.add(0, 0);
  return p;
}

}  // namespace detail

inline constexpr SamplePattern kGrid16 = detail::grid("grid16", 4, 4);  ///< the paper's 4x4
inline constexpr SamplePattern kGrid32 = detail::grid("grid32", 8, 4);  ///< Carpenter's 4x8: 8 columns
inline constexpr SamplePattern kRooks16 = detail::rooks();  ///< one in each of 16 rows and columns
inline constexpr SamplePattern kCentre = detail::centre();  ///< what a z-buffer without antialiasing sees

}  // namespace blysk::antialias
