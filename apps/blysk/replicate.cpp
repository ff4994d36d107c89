// blysk replicate: the papers' tables and claims, measured again.
#include <chrono>
#include <filesystem>
#include <fstream>

#include "blysk/image.h"
#include "blysk/study.h"
#include "blysk/version.h"
#include "json.h"
#include "outputs.h"
#include "subcommands.h"
#include "terminal.h"
#include "text.h"

namespace blysk::command {
namespace {

constexpr int kWidth = 110;

// As the system calls the processor; where it does not, "this machine".
std::string machine_name() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  }
  return "this machine";
}

std::string today() {
  const std::chrono::year_month_day day =
      std::chrono::floor<std::chrono::days>(std::chrono::system_clock::now());
  const auto two = [](unsigned v) { return std::string(v < 10 ? "0" : "") + std::to_string(v); };
  return std::to_string(static_cast<int>(day.year())) + "-" + two(static_cast<unsigned>(day.month())) + "-" +
         two(static_cast<unsigned>(day.day()));
}

std::string head_line(const std::vector<StudyReport>& reports) {
  std::string line = "Measured " + today() + " on " + printable(machine_name());
  for (const StudyReport& report : reports) {
    if (report.clock_ghz == 0) continue;
    line += ", " + fixed_text(report.clock_ghz, 1) + " GHz, " + report.instruction_set;
    break;
  }
  return line + "; blysk " + std::string(version()) + ".";
}

std::string measured_text(const StudyClaim& claim) {
  std::vector<std::string> parts;
  for (const StudyMeasurement& m : claim.measured) parts.push_back(m.figure.text + " " + m.where);
  return parts.empty() ? "-" : join(parts, "; ");
}

std::string tally(const StudyReport& report) {
  std::string text;
  for (const Verdict verdict : {Verdict::holds, Verdict::in_part, Verdict::fails}) {
    std::size_t n = 0;
    for (const StudyClaim& claim : report.claims) n += claim.verdict == verdict ? 1 : 0;
    text += (text.empty() ? "" : ", ") + std::to_string(n) + " " + std::string(verdict_name(verdict));
  }
  return counted(report.claims.size(), "claim") + ": " + text;
}

std::vector<std::string> texts_of(const std::vector<StudyCell>& row) {
  std::vector<std::string> texts;
  for (const StudyCell& cell : row) texts.push_back(cell.text);
  return texts;
}

std::string report_text(const StudyReport& report) {
  std::string text = report.title + "\n\n";
  for (const std::string& paragraph : report.introduction) text += wrap(paragraph, kWidth, 0) + "\n\n";
  for (const StudyTable& t : report.tables) {
    std::vector<std::vector<std::string>> rows = {t.columns};
    for (const auto& row : t.rows) rows.push_back(texts_of(row));
    text += t.title + "\n" + table(rows);
    for (const std::string& note : t.notes) text += "  " + wrap(note, kWidth - 2, 2) + "\n";
    text += "\n";
  }
  text += tally(report) + "\n\n";
  for (const StudyClaim& claim : report.claims) {
    text += std::string(verdict_name(claim.verdict)) + ": " +
            wrap(claim.text + " (" + claim.source + ")", kWidth - 16, 4) + "\n    claimed " +
            claim.claimed.text + ", modelled " + claim.modelled.text + ", measured " +
            wrap(measured_text(claim), kWidth - 8, 8) + "\n    " + wrap(claim.why, kWidth - 4, 4) + "\n";
  }
  return text;
}

// A cell must not end its column.
std::string cell_text(std::string_view text) {
  std::string safe;
  for (const char c : text) {
    if (c == '|') safe += '\\';
    safe += c;
  }
  return safe;
}

std::string markdown_row(const std::vector<std::string>& cells) {
  std::string line = "|";
  for (const std::string& cell : cells) line += " " + cell_text(cell) + " |";
  return line + "\n";
}

std::string markdown_table(const std::vector<std::vector<std::string>>& rows, std::size_t words) {
  std::string text = markdown_row(rows.front()) + "|";
  for (std::size_t i = 0; i < rows.front().size(); ++i) text += i < words ? "---|" : "---:|";
  text += "\n";
  for (std::size_t i = 1; i < rows.size(); ++i) text += markdown_row(rows[i]);
  return text;
}

std::string claims_markdown(const StudyReport& report) {
  std::vector<std::vector<std::string>> rows = {
      {"claim", "source", "claimed", "modelled", "measured here", "verdict", "why"}};
  for (const StudyClaim& claim : report.claims) {
    rows.push_back({claim.text, claim.source, claim.claimed.text, claim.modelled.text, measured_text(claim),
                    "**" + std::string(verdict_name(claim.verdict)) + "**", claim.why});
  }
  return "### Claims\n\n" + tally(report) + ".\n\n" + markdown_table(rows, rows.front().size());
}

std::string report_markdown(const StudyReport& report) {
  std::string text = "\n## " + report.title + "\n\n";
  for (const std::string& paragraph : report.introduction) text += wrap(paragraph, kWidth, 0) + "\n\n";
  text += claims_markdown(report);
  for (const StudyPlot& plot : report.plots) {
    text += "\n![" + plot.title + "](images/" + plot.id + ".svg)\n";
  }
  for (const StudyTable& t : report.tables) {
    std::vector<std::vector<std::string>> rows = {t.columns};
    for (const auto& row : t.rows) rows.push_back(texts_of(row));
    text += "\n### " + t.title + "\n\n" + markdown_table(rows, 1);
    for (const std::string& note : t.notes) text += "\n" + wrap(note, kWidth, 0) + "\n";
  }
  return text;
}

// docs/replication.md.
std::string page(const std::vector<StudyReport>& reports) {
  std::string text = "# Replication\n\n" +
                     wrap(
                         "What the papers claim, and what is found here. This page is what "
                         "`blysk replicate --markdown -o docs/images` prints.",
                         kWidth, 0) +
                     "\n\n" + head_line(reports) + "\n";
  for (const StudyReport& report : reports) text += report_markdown(report);
  return text;
}

Json cell_json(const StudyCell& cell) { return cell.value ? Json(*cell.value) : Json(cell.text); }

Json table_json(const StudyTable& t) {
  Json rows = Json::array();
  for (const auto& row : t.rows) {
    Json cells = Json::array();
    for (const StudyCell& cell : row) cells.push_back(cell_json(cell));
    rows.push_back(std::move(cells));
  }
  return {{"id", t.id},
          {"title", t.title},
          {"columns", t.columns},
          {"rows", std::move(rows)},
          {"notes", t.notes}};
}

Json claim_json(const StudyClaim& claim) {
  Json measured = Json::array();
  for (const StudyMeasurement& m : claim.measured) {
    measured.push_back({{"where", m.where}, {"value", cell_json(m.figure)}});
  }
  return {{"id", claim.id},
          {"claim", claim.text},
          {"source", claim.source},
          {"claimed", cell_json(claim.claimed)},
          {"modelled", claim.modelled.value ? Json(*claim.modelled.value) : Json()},
          {"measured", std::move(measured)},
          {"verdict", verdict_name(claim.verdict)},
          {"why", claim.why}};
}

Json plot_json(const StudyPlot& plot) {
  Json points = Json::array();
  for (const StudyPoint& p : plot.points) points.push_back({{"label", p.label}, {"x", p.x}, {"y", p.y}});
  return {{"id", plot.id},
          {"title", plot.title},
          {"x", plot.x_label},
          {"y", plot.y_label},
          {"points", std::move(points)}};
}

Json report_json(const StudyReport& report) {
  Json json = {{"name", report.name}, {"title", report.title}};
  json["tables"] = Json::array();
  for (const StudyTable& t : report.tables) json["tables"].push_back(table_json(t));
  json["claims"] = Json::array();
  for (const StudyClaim& claim : report.claims) json["claims"].push_back(claim_json(claim));
  json["plots"] = Json::array();
  for (const StudyPlot& plot : report.plots) json["plots"].push_back(plot_json(plot));
  return json;
}

Json document(const std::vector<StudyReport>& reports) {
  Json json = {{"version", version()}, {"date", today()}, {"machine", printable(machine_name())}};
  json["studies"] = Json::array();
  for (const StudyReport& report : reports) {
    json["studies"].push_back(report_json(report));
    if (report.clock_ghz == 0) continue;
    json["clock_ghz"] = report.clock_ghz;
    json["simd"] = report.instruction_set;
  }
  return json;
}

std::string plot_path(const Arguments& arguments, const StudyPlot& plot) {
  return (std::filesystem::path(arguments.text("output")) / (plot.id + ".svg")).string();
}

Status write_plots(const std::vector<StudyReport>& reports, const Arguments& arguments) {
  for (const StudyReport& report : reports) {
    for (const StudyPlot& plot : report.plots) {
      if (const Status s = write_file(plot_svg(plot), plot_path(arguments, plot)); !s) return s;
    }
  }
  return Done{};
}

Result<std::vector<StudyReport>> run_studies(const Arguments& arguments) {
  Progress progress(!arguments.has("quiet"));
  std::vector<StudyReport> reports;
  for (const Study& study : studies()) {
    if (arguments.has("study") && arguments.text("study") != study.name) continue;
    StudyOptions options;
    options.quick = arguments.has("quick");
    options.progress = [&](std::string_view what) { progress.phase(what); };
    Result<StudyReport> report = study.run(options);
    if (!report) return report.error();
    report->name = study.name;
    reports.push_back(std::move(*report));
  }
  progress.finish();
  return reports;
}

}  // namespace

Result<int> run_replicate(const Arguments& arguments) {
  if (arguments.has("json") && arguments.has("markdown")) {
    return usage_error("--markdown", "standard output holds one document; leave out --json or --markdown");
  }
  if (arguments.has("output")) {
    const std::string within = (std::filesystem::path(arguments.text("output")) / "plot.svg").string();
    if (const Status status = check_place(within); !status) return status.error();
  }
  const Result<std::vector<StudyReport>> reports = run_studies(arguments);
  if (!reports) return reports.error();
  if (arguments.has("output")) {
    if (const Status status = write_plots(*reports, arguments); !status) return status.error();
  }
  Status status = Done{};
  if (arguments.has("json")) {
    status = print_json(document(*reports));
  } else if (arguments.has("markdown")) {
    status = print(page(*reports));
  } else {
    std::string text = head_line(*reports) + "\n\n";
    for (const StudyReport& report : *reports) text += report_text(report);
    status = print(text);
  }
  if (!status) return status.error();
  return 0;
}

}  // namespace blysk::command
