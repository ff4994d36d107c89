#include "study_report.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "blysk/version.h"
#include "text.h"

namespace blysk::command {
namespace {

constexpr int kTextWidth = 110;

using Rows = std::vector<std::vector<std::string>>;

Rows rows_of(const StudyTable& table) {
  Rows rows = {table.columns};
  for (const auto& row : table.rows) {
    std::vector<std::string> words;
    for (const StudyCell& cell : row) words.push_back(cell.text);
    rows.push_back(std::move(words));
  }
  return rows;
}

std::string measured_text(const StudyClaim& claim) {
  std::vector<std::string> parts;
  for (const StudyMeasurement& m : claim.measured) {
    parts.push_back(m.figure.text + (m.where.empty() ? "" : " (" + m.where + ")"));
  }
  return join(parts, "; ");
}

bool by_scene(const StudyReport& report) {
  return std::ranges::any_of(report.claims, [](const StudyClaim& c) { return !c.scene.empty(); });
}

Rows rows_by_scene(const std::vector<StudyClaim>& claims) {
  Rows rows = {{"claim", "scene", "claimed", "measured", "verdict"}};
  for (const StudyClaim& c : claims) {
    rows.push_back(
        {c.claim, c.scene, c.claimed.text, measured_text(c), std::string(verdict_name(c.verdict))});
  }
  return rows;
}

Rows rows_by_number(const std::vector<StudyClaim>& claims) {
  Rows rows = {{"", "claim", "source", "claimed", "modelled", "verdict"}};
  for (std::size_t i = 0; i < claims.size(); ++i) {
    const StudyClaim& c = claims[i];
    rows.push_back({std::to_string(i + 1), c.claim, c.source, c.claimed.text, c.modelled.text,
                    "**" + std::string(verdict_name(c.verdict)) + "**"});
  }
  return rows;
}

// "claimed 3.03x, modelled 3.00x, measured 0.90x (plain program)".
std::string figures_text(const StudyClaim& c) {
  std::string figures = "claimed " + c.claimed.text;
  if (!c.modelled.text.empty()) figures += ", modelled " + c.modelled.text;
  return figures + ", measured " + measured_text(c);
}

// Numbered as the table is, which would be too narrow for it.
std::string reasons_markdown(const std::vector<StudyClaim>& claims) {
  std::string text;
  for (std::size_t i = 0; i < claims.size(); ++i) {
    const StudyClaim& c = claims[i];
    text += std::to_string(i + 1) + ". " + printable(c.claim) + ": **" +
            std::string(verdict_name(c.verdict)) + "**; " + printable(figures_text(c)) + ". " +
            printable(c.why) + "\n";
  }
  return text + "\n";
}

constexpr Verdict kVerdicts[] = {Verdict::holds, Verdict::in_part, Verdict::fails};

// "31 claims: 9 hold, 8 hold in part, 14 do not hold".
std::string tally(const std::vector<StudyClaim>& claims) {
  constexpr std::string_view kPlural[] = {"hold", "hold in part", "do not hold"};
  std::vector<std::string> parts;
  for (const Verdict verdict : kVerdicts) {
    const auto n = std::ranges::count(claims, verdict, &StudyClaim::verdict);
    const std::string words(n == 1 ? verdict_name(verdict) : kPlural[static_cast<int>(verdict)]);
    parts.push_back(std::to_string(n) + " " + words);
  }
  return counted(claims.size(), "claim") + ": " + join(parts, ", ");
}

// One line for each claim: in how many scenes it holds.
Rows summary_of(const std::vector<StudyClaim>& claims) {
  Rows rows = {{"claim", "claimed"}};
  for (const Verdict verdict : kVerdicts) rows.front().emplace_back(verdict_name(verdict));
  for (std::size_t i = 0; i < claims.size(); ++i) {
    const auto alike = [&](const StudyClaim& c) {
      return c.claim == claims[i].claim && c.claimed.text == claims[i].claimed.text;
    };
    if (std::any_of(claims.begin(), claims.begin() + static_cast<std::ptrdiff_t>(i), alike)) continue;
    std::vector<std::string> row = {claims[i].claim, claims[i].claimed.text};
    for (const Verdict verdict : kVerdicts) {
      row.push_back(std::to_string(std::count_if(claims.begin(), claims.end(), [&](const StudyClaim& c) {
        return alike(c) && c.verdict == verdict;
      })));
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

std::string markdown_cell(std::string_view text) {
  std::string all;
  for (const char c : printable(text)) all += c == '|' ? std::string("\\|") : std::string(1, c);
  return all;
}

std::string markdown_table(const Rows& rows) {
  std::string text;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (const std::string& words : rows[i]) text.append("| ").append(markdown_cell(words)).append(" ");
    text += "|\n";
    if (i > 0) continue;
    for (std::size_t k = 0; k < rows[i].size(); ++k) text += "|---";
    text += "|\n";
  }
  return text + "\n";
}

// JSON has no infinity: "exact" stays a word.
Json cell_json(const StudyCell& cell) {
  return cell.value && std::isfinite(*cell.value) ? Json(*cell.value) : Json(cell.text);
}

Json table_json(const StudyTable& table) {
  Json rows = Json::array();
  for (const auto& row : table.rows) {
    Json cells = Json::array();
    for (const StudyCell& cell : row) cells.push_back(cell_json(cell));
    rows.push_back(std::move(cells));
  }
  return {{"id", table.id},
          {"title", table.title},
          {"columns", table.columns},
          {"rows", std::move(rows)},
          {"notes", table.notes}};
}

Json claim_json(const StudyClaim& c) {
  Json measured = Json::array();
  for (const StudyMeasurement& m : c.measured) {
    measured.push_back({{"where", m.where}, {"value", cell_json(m.figure)}, {"witness", m.witness}});
  }
  return {{"id", c.id},
          {"claim", c.claim},
          {"scene", c.scene},
          {"source", c.source},
          {"claimed", cell_json(c.claimed)},
          {"modelled", c.modelled.text.empty() ? Json() : cell_json(c.modelled)},
          {"measured", std::move(measured)},
          {"verdict", verdict_name(c.verdict)},
          {"why", c.why}};
}

Json report_json(const StudyReport& report) {
  Json sections = Json::array(), claims = Json::array();
  for (const StudySection& section : report.sections) {
    Json tables = Json::array();
    for (const StudyTable& t : section.tables) tables.push_back(table_json(t));
    sections.push_back({{"title", section.title}, {"tables", std::move(tables)}});
  }
  for (const StudyClaim& c : report.claims) claims.push_back(claim_json(c));
  return {{"study", report.name},
          {"title", report.title},
          {"source", report.source},
          {"sections", std::move(sections)},
          {"claims", std::move(claims)}};
}

std::string reasons_text(const std::vector<StudyClaim>& claims) {
  std::string text;
  for (const StudyClaim& c : claims) {
    text +=
        wrap(std::string(verdict_name(c.verdict)) + ": " + c.claim + " (" + c.source + ")", kTextWidth, 4) +
        "\n    " + wrap(figures_text(c), kTextWidth - 4, 6) + "\n    " + wrap(c.why, kTextWidth - 4, 4) +
        "\n";
  }
  return text;
}

std::string report_text(const StudyReport& report) {
  std::string text = report.title + "\n" + wrap(report.source, kTextWidth, 0) + "\n\n";
  if (by_scene(report)) text += "Claims\n\n" + table(summary_of(report.claims)) + "\n";
  for (const StudySection& section : report.sections) {
    text += section.title + "\n\n";
    for (const std::string& paragraph : section.paragraphs) text += wrap(paragraph, kTextWidth, 0) + "\n\n";
    for (const StudyTable& t : section.tables) {
      text += t.title + "\n" + table(rows_of(t));
      for (const std::string& note : t.notes) text += "  " + wrap(note, kTextWidth - 2, 2) + "\n";
      text += "\n";
    }
  }
  return text + (by_scene(report) ? "Claims, scene by scene\n\n" + table(rows_by_scene(report.claims))
                                  : tally(report.claims) + "\n\n" + reasons_text(report.claims));
}

// As a page under docs/ names it.
std::string plot_link(const std::string& folder, const StudyPlot& plot) {
  const std::string path = plot_path(folder, plot.name);
  return path.starts_with("docs/") ? path.substr(5) : path;
}

std::string report_markdown(const StudyReport& report, const std::string& folder) {
  std::string text =
      "\n## " + report.title + "\n\n" + report.source + ".\n\n" + tally(report.claims) + ".\n\n";
  text += markdown_table(by_scene(report) ? summary_of(report.claims) : rows_by_number(report.claims));
  if (!by_scene(report)) text += "### Why\n\n" + reasons_markdown(report.claims);
  for (const StudySection& section : report.sections) {
    text += "### " + section.title + "\n\n";
    for (const std::string& paragraph : section.paragraphs) text += paragraph + "\n\n";
    for (const StudyPlot& plot : section.plots) {
      if (!folder.empty()) text += "![" + plot.title + "](" + plot_link(folder, plot) + ")\n\n";
    }
    for (const StudyTable& t : section.tables) {
      text += "**" + t.title + "**\n\n" + markdown_table(rows_of(t));
      for (const std::string& note : t.notes) text += note + "\n\n";
    }
  }
  if (by_scene(report))
    text += "### Claims, scene by scene\n\n" + markdown_table(rows_by_scene(report.claims));
  text.pop_back();
  return text;
}

// As the system calls the processor.
std::string machine_name() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos)
      return printable(line.substr(colon + 2));
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

// Where the times are from; the only line of a page that dates it.
std::string head_line(const std::vector<StudyReport>& reports) {
  std::string line = "Version " + std::string(version());
  for (const StudyReport& report : reports) {
    if (!report.clock.empty()) line += "; times of " + today() + ", " + machine_name() + ", " + report.clock;
  }
  return line + ".";
}

}  // namespace

std::string plot_path(const std::string& folder, const std::string& name) {
  return (std::filesystem::path(folder) / name).string();
}

std::string reports_text(const std::vector<StudyReport>& reports) {
  std::string text = head_line(reports) + "\n";
  for (const StudyReport& report : reports) text += "\n" + report_text(report);
  return text;
}

std::string reports_markdown(const std::vector<StudyReport>& reports, const std::string& folder,
                             const std::vector<std::string>& models) {
  std::string which = reports.size() == 1 ? " --study " + reports.front().name : "";
  which += " --markdown -o docs/images";
  for (const std::string& model : models) which += " " + std::filesystem::path(model).filename().string();
  std::string text =
      "# Replication\n\nWhat the papers claim and what is found here. This page is what\n`blysk replicate" +
      which + "` prints.\n\n" + head_line(reports) + "\n";
  for (const StudyReport& report : reports) text += report_markdown(report, folder);
  return text;
}

Json reports_json(const std::vector<StudyReport>& reports) {
  Json json = {{"version", version()}, {"date", today()}, {"machine", machine_name()}};
  json["studies"] = Json::array();
  for (const StudyReport& report : reports) json["studies"].push_back(report_json(report));
  return json;
}

}  // namespace blysk::command
