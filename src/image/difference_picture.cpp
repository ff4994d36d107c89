// The error map: differences in false colours beside a colour bar.
#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>
#include <string_view>

#include "image/metrics.h"
#include "image/panel.h"

namespace blysk {
namespace {

using namespace panel;

constexpr std::uint32_t kEqual = 0xff000000;
constexpr int kDifferencePanel = width_for(3);
constexpr int kLeastDifferenceHeight =
    2 * kMargin + 5 * kDigitHeight;  // room for a few labels beside a small picture
constexpr int kLeastTickDistance = 3 * kDigitHeight / 2;

struct Rgb {
  int r, g, b;
};

// Lightness rises from end to end, so that the map can be read in gray too.
constexpr Rgb kRamp[] = {{40, 70, 190},  {120, 60, 200}, {200, 60, 150},
                         {240, 110, 80}, {250, 180, 70}, {255, 250, 190}};
constexpr int kRampSteps = static_cast<int>(std::size(kRamp)) - 1;

int mixed(int low, int high, int part, int whole) { return low + (high - low) * part / whole; }

// The colour of a difference of 1..full_scale.
std::uint32_t false_color(int difference, int full_scale) {
  if (difference <= 0) return kEqual;
  const int span = std::max(full_scale - 1, 1);
  // Place on the ramp in units of 1/span of a step; a scale of one level shows its strongest colour.
  const int place = full_scale == 1 ? kRampSteps : std::min(difference - 1, span) * kRampSteps;
  const int step = std::min(place / span, kRampSteps - 1), part = place - step * span;
  const Rgb a = kRamp[step], b = kRamp[step + 1];
  return 0xff000000u | static_cast<std::uint32_t>(mixed(a.r, b.r, part, span)) |
         static_cast<std::uint32_t>(mixed(a.g, b.g, part, span)) << 8 |
         static_cast<std::uint32_t>(mixed(a.b, b.b, part, span)) << 16;
}

using Palette = std::array<std::uint32_t, 256>;

Palette palette_of(int full_scale) {
  Palette palette;
  for (int d = 0; d < 256; ++d) palette[static_cast<std::size_t>(d)] = false_color(d, full_scale);
  return palette;
}

std::uint32_t largest_difference(std::uint32_t a, std::uint32_t b) {
  std::uint32_t largest = 0;
  for (int shift = 0; shift < 32; shift += 8) {
    const std::uint32_t x = a >> shift & 0xff, y = b >> shift & 0xff;
    largest = std::max(largest, x > y ? x - y : y - x);
  }
  return largest;
}

// Difference between two labels: 1, 2 or 5 times a power of ten, the labels not crowded.
int tick_step(int full_scale, int bar_height) {
  for (const int step : {1, 2, 5, 10, 20, 50, 100}) {
    if (bar_height * step / full_scale >= kLeastTickDistance && full_scale / step <= 6) return step;
  }
  return full_scale;
}

void draw_bar(Image& image, int left, const Palette& palette, int full_scale) {
  const int top = kMargin, bottom = image.height - kMargin - 1, height = bottom - top;
  // The scale's levels, its zero included, each as high as the others; the largest on top.
  for (int y = top; y <= bottom; ++y) {
    const int level = (bottom - y) * (full_scale + 1) / (height + 1);
    fill(image, left, y, kBarWidth, 1, palette[static_cast<std::size_t>(level)]);
  }
  const auto middle = [&](int level) {
    return bottom - (2 * level + 1) * (height + 1) / (2 * (full_scale + 1));
  };
  const auto label = [&](int level) {
    const int y = middle(level);
    fill(image, left + kBarWidth, y, kTick, 1, kInk);
    const int text_top = std::clamp(y - kDigitHeight / 2, 0, image.height - kDigitHeight);
    draw_label(image, left + kBarWidth + kTick + kGap, text_top, std::to_string(level));
  };
  const int step = tick_step(full_scale, height);
  label(full_scale);
  for (int level = 0; level < full_scale; level += step) {
    if (middle(level) - middle(full_scale) >= kDigitHeight + kDot) label(level);
  }
}

}  // namespace

Result<Image> difference_picture(const Image& reference, const Image& candidate, int full_scale) {
  if (const Status status = check_same_size(reference, candidate); !status) return status.error();
  if (reference.width > kMaxPictureSide - kDifferencePanel) {
    return Error{.code = ErrorCode::limit,
                 .message = "there is no room for the colour bar beside a picture wider than " +
                            std::to_string(kMaxPictureSide - kDifferencePanel),
                 .source = {}};
  }
  if (full_scale <= 0) {
    std::uint32_t largest = 1;
    for (std::size_t i = 0; i < reference.pixels.size(); ++i) {
      largest = std::max(largest, largest_difference(reference.pixels[i], candidate.pixels[i]));
    }
    full_scale = static_cast<int>(largest);
  }
  full_scale = std::min(full_scale, 255);

  const Palette palette = palette_of(full_scale);
  Image out;
  out.resize(reference.width + kDifferencePanel, std::max(reference.height, kLeastDifferenceHeight));
  std::fill(out.pixels.begin(), out.pixels.end(), kGround);
  const auto width = static_cast<std::size_t>(reference.width), stride = static_cast<std::size_t>(out.width);
  for (std::size_t y = 0; y < static_cast<std::size_t>(reference.height); ++y) {
    for (std::size_t x = 0; x < width; ++x) {
      const std::size_t at = y * width + x;
      out.pixels[y * stride + x] = palette[largest_difference(reference.pixels[at], candidate.pixels[at])];
    }
  }
  draw_bar(out, reference.width + kMargin, palette, full_scale);
  return out;
}

}  // namespace blysk
