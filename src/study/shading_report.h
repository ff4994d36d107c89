// study/shading_report.h - what was measured of shading, as sections and claims.
#pragma once

#include <vector>

#include "blysk/study.h"
#include "study/shading_measurements.h"

namespace blysk::study {

[[nodiscard]] std::vector<StudySection> shading_sections(const ShadingMeasurements& m);
[[nodiscard]] std::vector<StudyClaim> shading_claims(const ShadingMeasurements& m);

}  // namespace blysk::study
