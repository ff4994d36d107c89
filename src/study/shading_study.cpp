#include "study/cells.h"
#include "study/shading_report.h"

namespace blysk {

Result<StudyReport> study_shading(const StudyOptions& options) {
  const Result<study::ShadingMeasurements> m = study::measure_shading(options);
  if (!m) return m.error();
  StudyReport report;
  report.name = "shading";
  report.title = "Shading methods: operations, errors, speed";
  report.source =
      "The Vinnytsia thesis on shading (\"thesis\"), the paper on simplified Gouraud shading, and the thesis "
      "on "
      "relief and vectors (\"relief thesis\")";
  report.sections = study::shading_sections(*m);
  report.claims = study::shading_claims(*m);
  report.clock = study::fixed_text(m->clock_ghz, 1) + " GHz, " + m->best;
  return report;
}

}  // namespace blysk
