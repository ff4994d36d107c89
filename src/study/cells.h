// study/cells.h - numbers as the tables of a report show them.
#pragma once

#include <cstdint>
#include <string>

#include "blysk/study.h"

namespace blysk::study {

[[nodiscard]] std::string scientific_text(double value);         ///< "2.9e-4", "0"
[[nodiscard]] std::string fixed_text(double value, int digits);  ///< "2.90"; "exact" where it is infinite

[[nodiscard]] inline StudyCell word(std::string text) { return {std::move(text), {}}; }
[[nodiscard]] inline StudyCell scientific(double value) { return {scientific_text(value), value}; }
[[nodiscard]] inline StudyCell fixed(double value, int digits) { return {fixed_text(value, digits), value}; }
[[nodiscard]] inline StudyCell whole(std::uint64_t value) {
  return {std::to_string(value), static_cast<double>(value)};
}
[[nodiscard]] inline StudyCell percent(double share) { return {fixed_text(100 * share, 1) + " %", share}; }

}  // namespace blysk::study
