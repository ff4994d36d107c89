#include "image/panel.h"

#include <algorithm>

namespace blysk::panel {
namespace {

// Rows from the top, the leftmost dot in bit 4.
constexpr std::uint8_t kDigits[10][kDotsHigh] = {
    {14, 17, 19, 21, 25, 17, 14}, {4, 12, 4, 4, 4, 4, 14},  {14, 17, 1, 6, 8, 16, 31},
    {14, 17, 1, 6, 1, 17, 14},    {2, 6, 10, 18, 31, 2, 2}, {31, 16, 30, 1, 1, 17, 14},
    {6, 8, 16, 30, 17, 17, 14},   {31, 1, 2, 4, 8, 8, 8},   {14, 17, 17, 14, 17, 17, 14},
    {14, 17, 17, 15, 1, 2, 12},
};
constexpr std::uint8_t kPlus[kDotsHigh] = {0, 4, 4, 31, 4, 4, 0};
constexpr std::uint8_t kBlank[kDotsHigh] = {};

const std::uint8_t* dots_of(char c) {
  if (c == '+') return kPlus;
  return c >= '0' && c <= '9' ? kDigits[c - '0'] : kBlank;
}

}  // namespace

void fill(Image& image, int left, int top, int width, int height, std::uint32_t color) {
  for (int y = top; y < top + height; ++y) {
    std::uint32_t* row =
        image.pixels.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width);
    std::fill(row + left, row + left + width, color);
  }
}

void draw_label(Image& image, int left, int top, std::string_view text) {
  for (const char c : text) {
    const std::uint8_t* const dots = dots_of(c);
    for (int y = 0; y < kDotsHigh; ++y) {
      for (int x = 0; x < kDotsWide; ++x) {
        if ((dots[y] >> (kDotsWide - 1 - x) & 1) == 0) continue;
        fill(image, left + x * kDot, top + y * kDot, kDot, kDot, kInk);
      }
    }
    left += kDigitAdvance;
  }
}

}  // namespace blysk::panel
