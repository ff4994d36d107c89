// study/cells.h - numbers as the tables of a report show them.
#pragma once

#include <cstdint>
#include <string>

#include "blysk/study.h"

namespace blysk::study {

[[nodiscard]] std::string scientific_text(double value);         ///< "2.9e-4", "0"
[[nodiscard]] std::string fixed_text(double value, int digits);  ///< "2.90"; "exact" where it is infinite
[[nodiscard]] std::string significant_text(double value, int digits);  ///< "0.00012", "1.2e-07", "0"
[[nodiscard]] std::string count_text(std::uint64_t value);             ///< "1,234,567"

[[nodiscard]] inline StudyCell word(std::string text) { return {std::move(text), {}}; }
[[nodiscard]] inline StudyCell word(std::string_view text) { return {std::string(text), {}}; }
[[nodiscard]] inline StudyCell word(const char* text) { return {text, {}}; }
[[nodiscard]] inline StudyCell none() { return word("-"); }
[[nodiscard]] inline StudyCell scientific(double value) { return {scientific_text(value), value}; }
[[nodiscard]] inline StudyCell fixed(double value, int digits) { return {fixed_text(value, digits), value}; }
[[nodiscard]] inline StudyCell significant(double value, int digits) {
  return {significant_text(value, digits), value};
}
[[nodiscard]] inline StudyCell whole(std::uint64_t value) {
  return {std::to_string(value), static_cast<double>(value)};
}
[[nodiscard]] inline StudyCell count(std::uint64_t value) {
  return {count_text(value), static_cast<double>(value)};
}
[[nodiscard]] inline StudyCell percent(double share, int digits = 1) {
  return {fixed_text(100 * share, digits) + " %", share};
}
[[nodiscard]] inline StudyCell factor(double value) { return {fixed_text(value, 2) + "x", value}; }

}  // namespace blysk::study
