// study/cells.h - numbers as the tables show them; the C locale always.
#pragma once

#include <cstdint>
#include <string>

#include "blysk/study.h"

namespace blysk::study {

[[nodiscard]] StudyCell words(std::string_view text);
[[nodiscard]] StudyCell none();                      ///< "-"
[[nodiscard]] StudyCell count(std::uint64_t value);  ///< with commas
[[nodiscard]] StudyCell fixed(double value, int digits);
[[nodiscard]] StudyCell significant(double value, int digits);
[[nodiscard]] StudyCell factor(double value);               ///< "1.83x"
[[nodiscard]] StudyCell percent(double share, int digits);  ///< 0.0036 as "0.36 %"; the value is the share

}  // namespace blysk::study
