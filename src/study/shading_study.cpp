#include "study/shading_study.h"

#include "study/shading_tables.h"

namespace blysk::study {

Result<StudyReport> run_shading_study(const StudyOptions& options) {
  const Result<ShadingMeasurements> m = measure_shading(options);
  if (!m) return m.error();
  StudyReport report;
  report.title = "Shading";
  report.introduction = {
      "Operations are counted by running the reference forms, which the tests hold to the papers' formulas, "
      "with a "
      "number type that counts. \"Modelled\" turns the counts into the clocks of the papers' processors. "
      "\"Plain "
      "program\" is the same code in single precision as the compiler translates it; \"scalar kernel\" and "
      "\"" +
          m->best +
          "\" are the shading stage of the renderer without and with SIMD. Methods that are compared were "
          "timed in "
          "turn, so their ratios mean more than their times.",
      "A gain holds where every measurement reaches nine tenths of it, and in part where one does. A bound "
      "holds up to "
      "its last printed digit, and in part up to a tenth more, or in some of the scenes."};
  report.tables = shading_tables(*m);
  report.claims = shading_claims(*m);
  report.plots = shading_plots(*m);
  report.clock_ghz = m->clock_ghz;
  report.instruction_set = m->best;
  return report;
}

}  // namespace blysk::study
