#include "image/metrics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace blysk {
namespace {

// Limits of the classes in Table 4.1 (thesis, chapter 4.3), inclusive from above.
constexpr double kLookTheSame = 0.0001;
constexpr double kSlightlyDifferent = 0.00025;
constexpr double kNoticeablyDifferent = 0.001;

int channel(std::uint32_t pixel, int shift) { return static_cast<int>(pixel >> shift & 0xff); }

std::string size_of(const Image& image) {
  return std::to_string(image.width) + "x" + std::to_string(image.height);
}

}  // namespace

Status check_same_size(const Image& reference, const Image& candidate) {
  if (reference.width == candidate.width && reference.height == candidate.height &&
      reference.pixels.size() == candidate.pixels.size()) {
    return Done{};
  }
  return Error{.code = ErrorCode::input,
               .message = "the pictures differ in size: reference " + size_of(reference) + ", candidate " +
                          size_of(candidate) + "; render both at one size",
               .source = {}};
}

Result<Difference> compare(const Image& reference, const Image& candidate) {
  if (const Status status = check_same_size(reference, candidate); !status) return status.error();
  Difference out;
  // 3 * 255^2 times the largest picture's 2^28 pixels needs 46 bits.
  std::uint64_t squares = 0, reference_squares = 0;
  for (std::size_t i = 0; i < reference.pixels.size(); ++i) {
    const std::uint32_t r = reference.pixels[i], c = candidate.pixels[i];
    out.different_pixels += r != c;
    for (int shift = 0; shift < 32; shift += 8) {
      const int difference = channel(r, shift) - channel(c, shift);
      out.max_difference = std::max(out.max_difference, std::abs(difference));
      if (shift == 24) continue;
      squares += static_cast<std::uint64_t>(difference * difference);
      reference_squares += static_cast<std::uint64_t>(channel(r, shift) * channel(r, shift));
    }
  }
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (squares == 0) {
    out.psnr_db = kInfinity;
    return out;
  }
  const double sum = static_cast<double>(squares);
  out.nmse = reference_squares != 0 ? sum / static_cast<double>(reference_squares) : kInfinity;
  const double mean = sum / (3 * static_cast<double>(reference.pixels.size()));
  out.psnr_db = 10 * std::log10(255.0 * 255.0 / mean);
  return out;
}

std::string_view nmse_class(double nmse) {
  if (nmse <= kLookTheSame) return "look the same";
  if (nmse <= kSlightlyDifferent) return "slight differences";
  if (nmse <= kNoticeablyDifferent) return "noticeably different";
  return "completely different";
}

}  // namespace blysk
