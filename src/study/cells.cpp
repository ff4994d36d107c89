#include "study/cells.h"

#include <charconv>
#include <cmath>

namespace blysk::study {
namespace {

std::string text_of(double value, std::chars_format format, int digits) {
  char text[400];  // the largest double has 309 digits before the point
  const auto end = std::to_chars(text, text + sizeof text, value, format, digits);
  return {text, end.ptr};
}

}  // namespace

std::string scientific_text(double value) {
  if (value == 0) return "0";
  std::string text = text_of(value, std::chars_format::scientific, 1);
  const std::size_t exponent = text.find('e') + 2;  // behind its sign
  if (exponent < text.size() - 1 && text[exponent] == '0') text.erase(exponent, 1);
  return text;
}

std::string fixed_text(double value, int digits) {
  return std::isinf(value) ? "exact" : text_of(value, std::chars_format::fixed, digits);
}

std::string significant_text(double value, int digits) {
  return value == 0 ? "0" : text_of(value, std::chars_format::general, digits);
}

std::string count_text(std::uint64_t value) {
  const std::string digits = std::to_string(value);
  std::string text;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && (digits.size() - i) % 3 == 0) text += ',';
    text += digits[i];
  }
  return text;
}

}  // namespace blysk::study
