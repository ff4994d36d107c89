// study/paper_tables.h - tables 2.1 and 4.2 to 4.5 of the shading thesis as they are printed, and what they
// add up to.
//
// Sections 10.2 to 10.4 of the specification.
#pragma once

#include <span>
#include <string_view>

#include "study/cost_model.h"

namespace blysk::study {

struct PaperRow {
  std::string_view procedure;
  Operations operations;
};

/// Operations for 100 points.
struct PaperTable {
  std::string_view id, title, method;
  std::string_view walk;  ///< of ours that does the same
  std::span<const PaperRow> rows;
  Operations printed_sum;
  Operations clocked;  ///< what the printed clocks are made of
  CostModel model;
  std::uint64_t printed_clocks;
  std::string_view difference;  ///< why what is counted here differs

  [[nodiscard]] Operations true_sum() const;
  [[nodiscard]] std::uint64_t true_clocks() const { return model.clocks(true_sum()); }
};

/// 4.3, 4.4, 4.5.
[[nodiscard]] std::span<const PaperTable> paper_tables();
[[nodiscard]] const PaperTable& paper_table(std::string_view id);  ///< must exist

/// Multiplications for the powers of 100 points, which table 4.3 has beside it.
inline constexpr Operations kPaperPowers = {.mul = 800};

/// Table 2.1: clocks for 16 pixels of a row on a Xeon Phi.
struct FormulaRow {
  int form;                              ///< of QuadraticForm
  std::uint64_t mul_clocks, add, shift;  ///< as printed
  std::uint64_t total;

  [[nodiscard]] std::uint64_t true_total() const { return mul_clocks + add + shift; }
};
[[nodiscard]] std::span<const FormulaRow> formula_table();

/// Table 4.2: the largest NMSE that the thesis found.
struct ErrorRow {
  std::string_view title, method;
  double nmse;
};
[[nodiscard]] std::span<const ErrorRow> error_table();

}  // namespace blysk::study
