#include "study/cells.h"

#include <charconv>
#include <cmath>

namespace blysk::study {
namespace {

std::string text_of(double value, std::chars_format format, int digits) {
  char text[400];  // the largest double has 309 digits before the point
  const auto [end, error] = std::to_chars(text, text + sizeof text, value, format, digits);
  return error == std::errc() ? std::string(text, end) : std::string();
}

}  // namespace

StudyCell words(std::string_view text) { return {std::string(text), {}}; }

StudyCell none() { return words("-"); }

StudyCell count(std::uint64_t value) {
  std::string text = std::to_string(value);
  for (std::size_t i = text.size(); i > 3;) text.insert(i -= 3, ",");
  return {text, static_cast<double>(value)};
}

StudyCell fixed(double value, int digits) {
  return {text_of(value, std::chars_format::fixed, digits), value};
}

StudyCell significant(double value, int digits) {
  if (value == 0) return {"0", 0.0};
  return {text_of(value, std::chars_format::general, digits), value};
}

StudyCell factor(double value) { return {text_of(value, std::chars_format::fixed, 2) + "x", value}; }

StudyCell percent(double share, int digits) {
  return {text_of(100 * share, std::chars_format::fixed, digits) + " %", share};
}

}  // namespace blysk::study
