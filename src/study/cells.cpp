#include "study/cells.h"

#include <charconv>
#include <cmath>

namespace blysk::study {

std::string scientific_text(double value) {
  if (value == 0) return "0";
  char digits[32];
  const auto end = std::to_chars(digits, digits + sizeof digits, value, std::chars_format::scientific, 1);
  std::string text(digits, end.ptr);
  const std::size_t exponent = text.find('e') + 2;  // behind its sign
  if (exponent < text.size() - 1 && text[exponent] == '0') text.erase(exponent, 1);
  return text;
}

std::string fixed_text(double value, int digits) {
  if (std::isinf(value)) return "exact";
  char text[64];
  const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::fixed, digits);
  return {text, end.ptr};
}

}  // namespace blysk::study

namespace blysk {

std::string_view verdict_name(Verdict verdict) {
  switch (verdict) {
    case Verdict::confirmed:
      return "confirmed";
    case Verdict::partly:
      return "partly";
    case Verdict::refuted:
      break;
  }
  return "refuted";
}

}  // namespace blysk
