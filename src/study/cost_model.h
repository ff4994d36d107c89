// study/cost_model.h - processors as the papers reckon with them: clocks for each operation.
#pragma once

#include <string_view>

#include "study/counted.h"

namespace blysk::study {

/// Clocks of one operation each; every other instruction is free, as in the papers.
struct CostModel {
  std::string_view name;
  std::string_view source;
  int add, mul, div, sqrt, shift;
  bool one_bit_shifts = false;  ///< a shift by k bits costs k

  [[nodiscard]] std::uint64_t clocks(const Operations& o) const {
    const auto of = [](int cost, std::uint64_t count) { return static_cast<std::uint64_t>(cost) * count; };
    return of(add, o.add) + of(mul, o.mul) + of(div, o.div) + of(sqrt, o.sqrt) +
           of(shift, one_bit_shifts ? o.shift_bits : o.shift);
  }
};

/// Thesis, tables 4.3 and 4.5. The thesis says Pentium M; the costs are those of the first Pentium (erratum
/// E47).
inline constexpr CostModel kPentium16 = {
    "Pentium, 16-bit division", "thesis, tables 4.3 and 4.5", 3, 11, 25, 70, 1};
/// Thesis, table 4.4. Used where methods are set side by side: one cost of a division for all.
inline constexpr CostModel kPentium32 = {"Pentium, 32-bit division", "thesis, table 4.4", 3, 11, 41, 70, 1};
/// Thesis, table 2.1, which has neither divisions nor roots.
inline constexpr CostModel kXeonPhi = {"Xeon Phi", "thesis, table 2.1", 1, 8, 0, 0, 1, true};

}  // namespace blysk::study
