// Structural similarity.
//
// Based on: Wang, Bovik, Sheikh, Simoncelli. Image Quality Assessment: From Error Visibility to Structural
// Similarity. 2004, formula (13) with the constants of its section III.C.
#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

#include "image/metrics.h"

namespace blysk {
namespace {

constexpr int kRadius = 5;
constexpr int kWindow = 2 * kRadius + 1;
// exp(-k^2 / (2 * 1.5^2)) for k = 0 to 5, the sum over -5 to 5 made one.
constexpr double kWeights[kRadius + 1] = {0.26601172486179436, 0.2130055377112537,   0.10936068950970002,
                                          0.03600077212843083, 0.007598758135239185, 0.00102838008447911};
constexpr double kC1 = (0.01 * 255) * (0.01 * 255);
constexpr double kC2 = (0.03 * 255) * (0.03 * 255);

using Row = std::vector<double>;

// Moments of both pictures under the window: x, y, xx, yy, xy.
constexpr std::size_t kMoments = 5;
using Moments = std::array<Row, kMoments>;

double luma(std::uint32_t pixel) {
  const std::uint32_t r = pixel & 0xff, g = pixel >> 8 & 0xff, b = pixel >> 16 & 0xff;
  return static_cast<double>(299 * r + 587 * g + 114 * b) / 1000;
}

// The weighted sum of kWindow neighbours, those at equal distance first.
template <class At>
double weighted(At at) {
  double sum = kWeights[0] * at(0);
  for (int k = 1; k <= kRadius; ++k) sum += kWeights[k] * (at(-k) + at(k));
  return sum;
}

// One row's moments, weighted along the row; entry i is the window that begins at column i.
void filter_row(const Image& reference, const Image& candidate, std::size_t y, Moments& scratch,
                Moments& out) {
  const auto width = static_cast<std::size_t>(reference.width);
  for (std::size_t i = 0; i < width; ++i) {
    const double a = luma(reference.pixels[y * width + i]), b = luma(candidate.pixels[y * width + i]);
    scratch[0][i] = a;
    scratch[1][i] = b;
    scratch[2][i] = a * a;
    scratch[3][i] = b * b;
    scratch[4][i] = a * b;
  }
  for (std::size_t m = 0; m < kMoments; ++m) {
    const double* from = scratch[m].data() + kRadius;
    for (std::size_t i = 0; i < out[m].size(); ++i) {
      out[m][i] = weighted([&](int k) { return from[static_cast<std::ptrdiff_t>(i) + k]; });
    }
  }
}

double similarity(const std::array<double, kMoments>& moments) {
  const auto [a, b, aa, bb, ab] = moments;
  const double variances = (aa - a * a) + (bb - b * b), covariance = ab - a * b;
  return (2 * a * b + kC1) * (2 * covariance + kC2) / ((a * a + b * b + kC1) * (variances + kC2));
}

}  // namespace

Result<double> ssim(const Image& reference, const Image& candidate) {
  if (const Status status = check_same_size(reference, candidate); !status) return status.error();
  if (reference.pixels == candidate.pixels) return 1.0;
  if (std::min(reference.width, reference.height) < kWindow) return std::numeric_limits<double>::quiet_NaN();

  const auto width = static_cast<std::size_t>(reference.width);
  const auto height = static_cast<std::size_t>(reference.height);
  const std::size_t columns = width - kWindow + 1, rows = height - kWindow + 1;
  Moments scratch, sums;
  scratch.fill(Row(width));
  sums.fill(Row(columns));
  // The last kWindow rows, filtered; row y stands at y % kWindow.
  std::vector<Moments> recent(kWindow, sums);
  double total = 0;
  for (std::size_t y = 0; y < height; ++y) {
    filter_row(reference, candidate, y, scratch, recent[y % kWindow]);
    if (y + 1 < kWindow) continue;
    for (std::size_t m = 0; m < kMoments; ++m) {
      const double* window[kWindow];
      for (std::size_t k = 0; k < kWindow; ++k) window[k] = recent[(y + 1 + k) % kWindow][m].data();
      for (std::size_t i = 0; i < columns; ++i) {
        sums[m][i] = weighted([&](int k) { return window[kRadius + k][i]; });
      }
    }
    double row_total = 0;
    for (std::size_t i = 0; i < columns; ++i) {
      row_total += similarity({sums[0][i], sums[1][i], sums[2][i], sums[3][i], sums[4][i]});
    }
    total += row_total;
  }
  return total / (static_cast<double>(columns) * static_cast<double>(rows));
}

}  // namespace blysk
