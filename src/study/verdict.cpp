#include "study/verdict.h"

#include <algorithm>

#include "study/cells.h"

namespace blysk::study {
namespace {

bool reaches(double claimed, const StudyMeasurement& m) { return *m.figure.value >= kReached * claimed; }

std::string list(const std::vector<const StudyMeasurement*>& some) {
  std::string text;
  for (std::size_t i = 0; i < some.size(); ++i) {
    if (i > 0) text += i + 1 == some.size() ? " and " : ", ";
    text += some[i]->where + " (" + some[i]->figure.text + ")";
  }
  return text;
}

}  // namespace

Verdict judge_gain(double claimed, double modelled, const std::vector<StudyMeasurement>& measured) {
  if (measured.empty()) return modelled >= kReached * claimed ? Verdict::in_part : Verdict::fails;
  const auto reached = std::ranges::count_if(measured, [&](const auto& m) { return reaches(claimed, m); });
  if (reached == std::ranges::ssize(measured)) return Verdict::holds;
  return reached > 0 ? Verdict::in_part : Verdict::fails;
}

std::string tell_gain(double claimed, double modelled, const std::vector<StudyMeasurement>& measured) {
  if (measured.empty()) {
    return std::string("Not measured: by its operations alone the gain is ") + factor(modelled).text + ".";
  }
  std::vector<const StudyMeasurement*> reached, missed;
  for (const StudyMeasurement& m : measured) (reaches(claimed, m) ? reached : missed).push_back(&m);
  if (missed.empty()) return "Reached everywhere: " + list(reached) + ".";
  if (reached.empty()) return "Reached nowhere: " + list(missed) + ".";
  return "Reached by " + list(reached) + ", not by " + list(missed) + ".";
}

Verdict judge_bound(double bound, double measured, double last_digit) {
  if (measured <= bound + last_digit / 2) return Verdict::holds;
  return measured <= 1.1 * bound ? Verdict::in_part : Verdict::fails;
}

}  // namespace blysk::study
