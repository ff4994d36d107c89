// The error map: differences in false colours beside a colour bar.
#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>
#include <string_view>

#include "image/metrics.h"

namespace blysk {
namespace {

constexpr std::uint32_t kPanel = 0xff202020, kInk = 0xffe8e8e8, kEqual = 0xff000000;

// The panel to the right of the picture, in pixels: margin, bar, tick, label, margin.
constexpr int kMargin = 8, kBarWidth = 16, kTick = 4, kGap = 3;
constexpr int kLabelDigits = 3;

// Digits are 5x7 dots, drawn 2x2 pixels each.
constexpr int kDotsWide = 5, kDotsHigh = 7, kDot = 2;
constexpr int kDigitAdvance = (kDotsWide + 1) * kDot, kDigitHeight = kDotsHigh * kDot;
constexpr int kPanelWidth = 2 * kMargin + kBarWidth + kTick + kGap + kLabelDigits * kDigitAdvance;
constexpr int kLeastHeight = 2 * kMargin + 5 * kDigitHeight;  // room for a few labels beside a small picture
constexpr int kLeastTickDistance = 3 * kDigitHeight / 2;

// Rows from the top, the leftmost dot in bit 4.
constexpr std::uint8_t kDigits[10][kDotsHigh] = {
    {14, 17, 19, 21, 25, 17, 14}, {4, 12, 4, 4, 4, 4, 14},  {14, 17, 1, 6, 8, 16, 31},
    {14, 17, 1, 6, 1, 17, 14},    {2, 6, 10, 18, 31, 2, 2}, {31, 16, 30, 1, 1, 17, 14},
    {6, 8, 16, 30, 17, 17, 14},   {31, 1, 2, 4, 8, 8, 8},   {14, 17, 17, 14, 17, 17, 14},
    {14, 17, 17, 15, 1, 2, 12},
};

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

void fill(Image& image, int left, int top, int width, int height, std::uint32_t color) {
  for (int y = top; y < top + height; ++y) {
    std::uint32_t* row =
        image.pixels.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width);
    std::fill(row + left, row + left + width, color);
  }
}

void draw_number(Image& image, int left, int top, int number) {
  for (const char c : std::to_string(number)) {
    for (int y = 0; y < kDotsHigh; ++y) {
      for (int x = 0; x < kDotsWide; ++x) {
        if ((kDigits[c - '0'][y] >> (kDotsWide - 1 - x) & 1) == 0) continue;
        fill(image, left + x * kDot, top + y * kDot, kDot, kDot, kInk);
      }
    }
    left += kDigitAdvance;
  }
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
    draw_number(image, left + kBarWidth + kTick + kGap, text_top, level);
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
  if (reference.width > kMaxPictureSide - kPanelWidth) {
    return Error{.code = ErrorCode::limit,
                 .message = "there is no room for the colour bar beside a picture wider than " +
                            std::to_string(kMaxPictureSide - kPanelWidth),
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
  out.resize(reference.width + kPanelWidth, std::max(reference.height, kLeastHeight));
  std::fill(out.pixels.begin(), out.pixels.end(), kPanel);
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
