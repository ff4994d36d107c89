// study/shading_study.h - the papers' shading methods, measured again.
#pragma once

#include "blysk/study.h"

namespace blysk::study {

[[nodiscard]] Result<StudyReport> run_shading_study(const StudyOptions& options);

}  // namespace blysk::study
