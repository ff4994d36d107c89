// image/panel.h - the panel to the right of a picture: its colours and its digits.
#pragma once

#include <cstdint>
#include <string_view>

#include "blysk/image.h"

namespace blysk::panel {

inline constexpr std::uint32_t kGround = 0xff202020, kInk = 0xffe8e8e8;

// In pixels: margin, bar, tick, label, margin.
inline constexpr int kMargin = 8, kBarWidth = 16, kTick = 4, kGap = 3;

// Digits are 5x7 dots, drawn 2x2 pixels each.
inline constexpr int kDotsWide = 5, kDotsHigh = 7, kDot = 2;
inline constexpr int kDigitAdvance = (kDotsWide + 1) * kDot, kDigitHeight = kDotsHigh * kDot;

constexpr int width_for(int label_digits) {
  return 2 * kMargin + kBarWidth + kTick + kGap + label_digits * kDigitAdvance;
}

void fill(Image& image, int left, int top, int width, int height, std::uint32_t color);

/// Digits and '+'; of other characters only their place is left.
void draw_label(Image& image, int left, int top, std::string_view text);

}  // namespace blysk::panel
