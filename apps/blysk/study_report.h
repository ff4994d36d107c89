// study_report.h - the studies' reports as text, Markdown or JSON.
#pragma once

#include <string>
#include <vector>

#include "blysk/study.h"
#include "json.h"

namespace blysk::command {

[[nodiscard]] std::string plot_path(const std::string& folder, const std::string& name);

[[nodiscard]] std::string reports_text(const std::vector<StudyReport>& reports);
/// One page. `folder` is that of the plots' files as seen from the working directory; a leading "docs/" is
/// left out, as the page itself lies there. Empty: there are no plots. `models` were measured besides.
[[nodiscard]] std::string reports_markdown(const std::vector<StudyReport>& reports, const std::string& folder,
                                           const std::vector<std::string>& models);
[[nodiscard]] Json reports_json(const std::vector<StudyReport>& reports);

}  // namespace blysk::command
