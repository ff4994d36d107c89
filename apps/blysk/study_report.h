// study_report.h - a study's report as text, Markdown or JSON.
#pragma once

#include <string>

#include "blysk/study.h"
#include "json.h"

namespace blysk::command {

[[nodiscard]] std::string plot_path(const std::string& folder, const std::string& name);

[[nodiscard]] std::string report_text(const StudyReport& report);
/// `plots` is the folder of the plots' files, as the page shall name it; empty: they are left out.
[[nodiscard]] std::string report_markdown(const StudyReport& report, const std::string& plots);
[[nodiscard]] Json report_json(const StudyReport& report);

}  // namespace blysk::command
