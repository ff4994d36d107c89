// Counts of fragments as a picture with its key, and coverage as gray.
#include <algorithm>
#include <string>

#include "blysk/fragments.h"
#include "image/fragment_colors.h"
#include "image/panel.h"

namespace blysk {
namespace {

using namespace panel;

constexpr int kFragmentPanel = width_for(2), kSwatch = kDigitHeight + 6;
constexpr int kSwatches = static_cast<int>(std::size(kFragmentColors));
constexpr int kLeastFragmentHeight = 2 * kMargin + kSwatches * kSwatch;

// The largest on top, as on a scale.
void draw_key(Image& image, int left) {
  for (int i = 0; i < kSwatches; ++i) {
    const int top = kMargin + (kSwatches - 1 - i) * kSwatch;
    fill(image, left, top, kBarWidth, kSwatch, kFragmentColors[i]);
    fill(image, left + kBarWidth, top + kSwatch / 2, kTick, 1, kInk);
    draw_label(image, left + kBarWidth + kTick + kGap, top + (kSwatch - kDigitHeight) / 2,
               std::to_string(i) + (i + 1 == kSwatches ? "+" : ""));
  }
}

}  // namespace

int widest_fragment_picture() { return kMaxPictureSide - kFragmentPanel; }

Result<Image> fragment_picture(std::span<const std::uint32_t> counts, int width) {
  if (width < 1 || counts.empty() || counts.size() % static_cast<std::size_t>(width) != 0) {
    return Error{ErrorCode::usage, "counts of fragments must be whole rows of a picture", {}, 0};
  }
  const std::size_t rows = counts.size() / static_cast<std::size_t>(width);
  if (width > widest_fragment_picture() || rows > std::size_t{kMaxPictureSide}) {
    return Error{ErrorCode::limit,
                 "there is no room for the key beside a picture wider than " +
                     std::to_string(widest_fragment_picture()),
                 {},
                 0};
  }
  Image out;
  out.resize(width + kFragmentPanel, std::max(static_cast<int>(rows), kLeastFragmentHeight));
  std::fill(out.pixels.begin(), out.pixels.end(), kGround);
  for (std::size_t y = 0; y < rows; ++y) {
    const auto row = counts.subspan(y * static_cast<std::size_t>(width), static_cast<std::size_t>(width));
    std::ranges::transform(
        row, out.pixels.begin() + static_cast<std::ptrdiff_t>(y * static_cast<std::size_t>(out.width)),
        fragment_color);
  }
  draw_key(out, width + kMargin);
  return out;
}

Image coverage_picture(const FloatImage& coverage) {
  Image out;
  out.resize(coverage.width, coverage.height);
  std::ranges::transform(coverage.values, out.pixels.begin(), [](float share) {
    const float bounded = share > 0 ? std::min(share, 1.0f) : 0.0f;  // not a number: 0
    return 0xff000000u | 0x010101u * static_cast<std::uint32_t>(bounded * 255.0f + 0.5f);
  });
  return out;
}

}  // namespace blysk
