#include "study_report.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "blysk/version.h"
#include "text.h"

namespace blysk::command {
namespace {

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

Rows rows_of(const std::vector<StudyClaim>& claims) {
  Rows rows = {{"claim", "scene", "claimed", "measured", "verdict"}};
  for (const StudyClaim& c : claims) {
    rows.push_back({c.claim, c.scene, c.claimed, c.measured, std::string(verdict_name(c.verdict))});
  }
  return rows;
}

// One line for each claim: in how many scenes it holds.
Rows summary_of(const std::vector<StudyClaim>& claims) {
  Rows rows = {{"claim", "claimed", "confirmed", "partly", "refuted"}};
  for (std::size_t i = 0; i < claims.size(); ++i) {
    const auto alike = [&](const StudyClaim& c) {
      return c.claim == claims[i].claim && c.claimed == claims[i].claimed;
    };
    if (std::any_of(claims.begin(), claims.begin() + static_cast<std::ptrdiff_t>(i), alike)) continue;
    std::vector<std::string> row = {claims[i].claim, claims[i].claimed};
    for (const Verdict verdict : {Verdict::confirmed, Verdict::partly, Verdict::refuted}) {
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

Json table_json(const StudyTable& table) {
  Json rows = Json::array();
  for (const auto& row : table.rows) {
    Json cells = Json::array();
    for (const StudyCell& cell : row) {
      // JSON has no infinity: "exact" stays a word.
      const bool number = cell.value && std::isfinite(*cell.value);
      cells.push_back(number ? Json(*cell.value) : Json(cell.text));
    }
    rows.push_back(std::move(cells));
  }
  return {{"title", table.title}, {"columns", table.columns}, {"rows", std::move(rows)}};
}

}  // namespace

std::string plot_path(const std::string& folder, const std::string& name) {
  return (std::filesystem::path(folder) / name).string();
}

std::string report_text(const StudyReport& report) {
  std::string text = report.title + "\n" + wrap(report.source, 100, 0) + "\n\nClaims\n\n" +
                     table(summary_of(report.claims)) + "\n";
  for (const StudySection& section : report.sections) {
    text += section.title + "\n\n";
    for (const std::string& paragraph : section.paragraphs) text += wrap(paragraph, 100, 0) + "\n\n";
    for (const StudyTable& t : section.tables) text += t.title + "\n" + table(rows_of(t)) + "\n";
  }
  return text + "Claims, scene by scene\n\n" + table(rows_of(report.claims));
}

std::string report_markdown(const StudyReport& report, const std::string& plots) {
  std::string text = "# " + report.title + "\n\nPaper: " + report.source +
                     ".\n\nMade by `blysk replicate --study " + report.name + " --markdown`, version " +
                     std::string(version()) +
                     "; the numbers are the same on every machine.\n\n## Claims\n\n" +
                     markdown_table(summary_of(report.claims));
  for (const StudySection& section : report.sections) {
    text += "## " + section.title + "\n\n";
    for (const std::string& paragraph : section.paragraphs) text += paragraph + "\n\n";
    for (const StudyPlot& plot : section.plots) {
      if (!plots.empty()) text += "![" + plot.title + "](" + plot_path(plots, plot.name) + ")\n\n";
    }
    for (const StudyTable& t : section.tables) text += "**" + t.title + "**\n\n" + markdown_table(rows_of(t));
  }
  text += "## Claims, scene by scene\n\n" + markdown_table(rows_of(report.claims));
  text.pop_back();
  return text;
}

Json report_json(const StudyReport& report) {
  Json sections = Json::array();
  for (const StudySection& section : report.sections) {
    Json tables = Json::array();
    for (const StudyTable& t : section.tables) tables.push_back(table_json(t));
    sections.push_back({{"title", section.title}, {"tables", std::move(tables)}});
  }
  Json claims = Json::array();
  for (const StudyClaim& c : report.claims) {
    claims.push_back({{"claim", c.claim},
                      {"scene", c.scene},
                      {"claimed", c.claimed},
                      {"measured", c.measured},
                      {"verdict", verdict_name(c.verdict)}});
  }
  return {{"version", version()},
          {"study", report.name},
          {"title", report.title},
          {"source", report.source},
          {"sections", std::move(sections)},
          {"claims", std::move(claims)}};
}

}  // namespace blysk::command
