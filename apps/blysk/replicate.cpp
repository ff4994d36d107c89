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

Status check_replicate_options(const Arguments& arguments) {
  if (arguments.has("json") && arguments.has("markdown")) {
    return usage_error("--markdown", "cannot stand beside --json");
  }
  const bool chosen = arguments.has("study");
  for (const Study& study : studies()) {
    if (chosen && study.name == arguments.text("study") && study.has_scenes) return Done{};
  }
  for (const char* of_scenes : {"scenes", "threads"}) {
    if (arguments.has(of_scenes)) {
      return usage_error("--" + std::string(of_scenes), "is for a study with scenes: --study abuffer");
    }
  }
  return Done{};
}

Result<std::vector<StudyReport>> run_studies(const Arguments& arguments) {
  Progress progress(!arguments.has("quiet"));
  StudyOptions options;
  options.threads = threads_of(arguments);
  options.quick = arguments.has("quick");
  options.limits = limits_of(arguments);
  options.models = arguments.operands();
  if (arguments.has("scenes")) options.scenes = split(arguments.text("scenes"), ',');
  options.progress = [&](std::string_view what) { progress.phase(what); };
  std::vector<StudyReport> reports;
  for (const Study& study : studies()) {
    if (arguments.has("study") && arguments.text("study") != study.name) continue;
    Result<StudyReport> report = study.run(options);
    if (!report) return report.error();
    reports.push_back(std::move(*report));
  }
  progress.finish();
  return reports;
}

Status write_plots(const std::vector<StudyReport>& reports, const std::string& folder) {
  for (const StudyReport& report : reports) {
    for (const StudySection& section : report.sections) {
      for (const StudyPlot& plot : section.plots) {
        const Status status = write_file(plot.bytes, plot_path(folder, plot.name));
        if (!status) return status;
      }
    }
  }
  return Done{};
}

}  // namespace

Result<int> run_replicate(const Arguments& arguments) {
  if (const Status status = check_replicate_options(arguments); !status) return status.error();
  const std::string folder = arguments.has("output") ? arguments.text("output") : "";
  if (!folder.empty()) {
    if (const Status status = check_place(plot_path(folder, "plot")); !status) return status.error();
  }
  const Result<std::vector<StudyReport>> reports = run_studies(arguments);
  if (!reports) return reports.error();
  if (!folder.empty()) {
    if (const Status status = write_plots(*reports, folder); !status) return status.error();
  }
  const Status status = arguments.has("json") ? print_json(reports_json(*reports))
                        : arguments.has("markdown")
                            ? print(reports_markdown(*reports, folder, arguments.operands()))
                            : print(reports_text(*reports));
  if (!status) return status.error();
  return 0;
}

}  // namespace blysk::command
