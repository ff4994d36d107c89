// study/shading_tables.h - what was measured of shading, as tables, claims and plots.
#pragma once

#include <vector>

#include "blysk/study.h"
#include "study/shading_measurements.h"

namespace blysk::study {

[[nodiscard]] std::vector<StudyTable> shading_tables(const ShadingMeasurements& m);
[[nodiscard]] std::vector<StudyClaim> shading_claims(const ShadingMeasurements& m);
[[nodiscard]] std::vector<StudyPlot> shading_plots(const ShadingMeasurements& m);

}  // namespace blysk::study
