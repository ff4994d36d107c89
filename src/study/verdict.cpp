#include "study/verdict.h"

#include <algorithm>

#include "study/cells.h"

namespace blysk::study {
namespace {

bool reaches(double claimed, const StudyMeasurement& m) { return *m.figure.value >= kReached * claimed; }

std::vector<const StudyMeasurement*> judged(const std::vector<StudyMeasurement>& measured) {
  std::vector<const StudyMeasurement*> some;
  for (const StudyMeasurement& m : measured) {
    if (!m.witness) some.push_back(&m);
  }
  return some;
}

// "a; b and c": the places themselves may have commas.
std::string list(const std::vector<const StudyMeasurement*>& some) {
  std::string text;
  for (std::size_t i = 0; i < some.size(); ++i) {
    if (i > 0) text += i + 1 == some.size() ? " and " : "; ";
    text += some[i]->where;
  }
  return text;
}

}  // namespace

Verdict judge_gain(double claimed, double modelled, const std::vector<StudyMeasurement>& measured) {
  const auto figures = judged(measured);
  if (figures.empty()) return modelled >= kReached * claimed ? Verdict::in_part : Verdict::fails;
  const auto reached = std::ranges::count_if(figures, [&](const auto* m) { return reaches(claimed, *m); });
  if (reached == std::ranges::ssize(figures)) return Verdict::holds;
  return reached > 0 ? Verdict::in_part : Verdict::fails;
}

std::string tell_gain(double claimed, double modelled, const std::vector<StudyMeasurement>& measured) {
  std::vector<const StudyMeasurement*> reached, missed;
  for (const StudyMeasurement* m : judged(measured)) (reaches(claimed, *m) ? reached : missed).push_back(m);
  if (reached.empty() && missed.empty()) {
    return std::string("Not measured; by its operations alone the gain is ") + factor(modelled).text + ".";
  }
  if (missed.empty()) return "Reached.";
  if (reached.empty()) return "Reached nowhere.";
  return std::string("Reached by ") + list(reached) + ", not by " + list(missed) + ".";
}

Verdict judge_bound(double bound, double measured, double last_digit) {
  if (measured <= bound + last_digit / 2) return Verdict::holds;
  return measured <= 1.1 * bound ? Verdict::in_part : Verdict::fails;
}

}  // namespace blysk::study
