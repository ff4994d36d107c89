// blysk replicate: the papers' experiments, measured again.
#include <algorithm>

#include "blysk/study.h"
#include "outputs.h"
#include "scene_options.h"
#include "study_report.h"
#include "subcommands.h"
#include "terminal.h"
#include "text.h"

namespace blysk::command {
namespace {

struct Study {
  std::string_view name;
  Result<StudyReport> (*run)(const StudyOptions&);
};

constexpr Study kStudies[] = {{"abuffer", study_abuffer}};

Status write_plots(const StudyReport& report, const std::string& folder) {
  for (const StudySection& section : report.sections) {
    for (const StudyPlot& plot : section.plots) {
      const Status status = write_file(plot.bytes, plot_path(folder, plot.name));
      if (!status) return status.error();
    }
  }
  return Done{};
}

}  // namespace

std::vector<std::string> study_names() {
  std::vector<std::string> names;
  for (const Study& study : kStudies) names.emplace_back(study.name);
  return names;
}

Result<int> run_replicate(const Arguments& arguments) {
  const bool as_json = arguments.has("json"), as_markdown = arguments.has("markdown");
  if (as_json && as_markdown) return usage_error("--markdown", "cannot stand beside --json");
  const std::string plots = arguments.has("plots") ? arguments.text("plots") : "";
  if (!plots.empty()) {
    const Status status = check_place(plot_path(plots, "plot.svg"));
    if (!status) return status.error();
  }

  Progress progress(true);
  StudyOptions options;
  options.threads = threads_of(arguments);
  options.limits = limits_of(arguments);
  options.models = arguments.operands();
  if (arguments.has("scenes")) options.scenes = split(arguments.text("scenes"), ',');
  options.progress = [&](std::string_view what) { progress.phase("measuring " + std::string(what)); };
  const auto study = std::ranges::find(kStudies, arguments.text("study"), &Study::name);
  const Result<StudyReport> report = study->run(options);
  progress.finish();
  if (!report) return report.error();

  if (!plots.empty()) {
    const Status status = write_plots(*report, plots);
    if (!status) return status.error();
  }
  const Status status = as_json       ? print_json(report_json(*report))
                        : as_markdown ? print(report_markdown(*report, plots))
                                      : print(report_text(*report));
  if (!status) return status.error();
  return 0;
}

}  // namespace blysk::command
