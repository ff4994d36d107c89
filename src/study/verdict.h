// study/verdict.h - when a claim holds.
#pragma once

#include <string>
#include <vector>

#include "blysk/study.h"

namespace blysk::study {

inline constexpr double kReached = 0.9;  ///< share of a claimed gain that counts as reached

/// A claim "at least so much": holds where every measurement reaches it, in part where one does, witnesses
/// not counted. Without measurements the model is judged, in part at best.
[[nodiscard]] Verdict judge_gain(double claimed, double modelled,
                                 const std::vector<StudyMeasurement>& measured);
/// Which measurements reach it and which do not, as a sentence.
[[nodiscard]] std::string tell_gain(double claimed, double modelled,
                                    const std::vector<StudyMeasurement>& measured);

/// A claim "at most so much": holds up to the bound's last printed digit, in part up to a tenth more.
[[nodiscard]] Verdict judge_bound(double bound, double measured, double last_digit);

}  // namespace blysk::study
