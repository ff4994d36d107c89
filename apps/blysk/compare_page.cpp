// The report of `blysk compare`: one HTML page, pictures inlined, nothing fetched, no script.
#include <algorithm>
#include <span>

#include "blysk/version.h"
#include "comparison.h"
#include "text.h"

namespace blysk::command {
namespace {

constexpr std::string_view kStyle = R"(
:root { color-scheme: light dark; --line: #8886; --panel: #8881; }
body { font: 15px/1.5 system-ui, sans-serif; margin: 0 auto; max-width: 110rem; padding: 1.5rem; }
h1 { font-size: 1.6rem; margin: 0; }
h2 { font-size: 1.15rem; margin: 0 0 .5rem; }
h2 small { font-weight: normal; opacity: .75; }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; margin: 1.5rem 0; font-variant-numeric: tabular-nums; }
th, td { border-bottom: 1px solid var(--line); padding: .35rem .8rem; text-align: left; white-space: nowrap; }
th { font-size: .8rem; color: GrayText; }
th:first-child, td:first-child { position: sticky; left: 0; background: Canvas; }
section { border-top: 1px solid var(--line); padding: 1.25rem 0; }
.row { display: grid; gap: 1rem; grid-template-columns: var(--widths); align-items: start; }
figure { margin: 0; background: var(--panel); padding: .5rem; }
figure img { display: block; max-width: 100%; height: auto; image-rendering: pixelated; }
figcaption { padding-top: .35rem; font-size: .85rem; overflow-wrap: anywhere; }
@media (max-width: 60rem) { .row { grid-template-columns: 1fr; } }
)";

// Text as HTML shows it. What is not printable could steer nothing here, but says nothing either.
std::string escaped(std::string_view text) {
  std::string all;
  for (const char c : printable(text)) {
    if (c == '<') {
      all += "&lt;";
    } else if (c == '>') {
      all += "&gt;";
    } else if (c == '&') {
      all += "&amp;";
    } else if (c == '"') {
      all += "&quot;";
    } else {
      all += c;
    }
  }
  return all;
}

// RFC 4648, section 4.
std::string base64(std::span<const std::uint8_t> bytes) {
  constexpr std::string_view kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t left = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) group = group << 8 | (k < left ? bytes[i + k] : 0u);
    for (std::size_t k = 0; k < 4; ++k) text += k <= left ? kLetters[group >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

std::string figure(const Image& image, std::string_view caption) {
  const Array<std::uint8_t> png = encode_png(image, {.compression = 6});
  return "<figure><img width=\"" + std::to_string(image.width) + "\" height=\"" +
         std::to_string(image.height) + "\" alt=\"" + escaped(caption) + "\" src=\"data:image/png;base64," +
         base64(png) + "\"><figcaption>" + escaped(caption) + "</figcaption></figure>\n";
}

std::string section_id(std::size_t candidate) { return "c" + std::to_string(candidate + 1); }

// The table's rows of candidates lead to their sections.
std::string html_table(const Comparison& comparison) {
  const auto rows = comparison_rows(comparison);
  std::vector<std::string> targets;  // of the last rows
  for (std::size_t i = 0; i < comparison.candidates.size(); ++i) {
    if (comparison.candidates[i].difference) targets.push_back(section_id(i));
  }
  std::string text = "<div class=\"scroll\"><table>\n";
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const std::string cell = r == 0 ? "th" : "td";
    const std::size_t others = rows.size() - targets.size();
    text += "<tr>";
    for (std::size_t i = 0; i < rows[r].size(); ++i) {
      const bool leads = i == 0 && r >= others;
      const std::string link = leads ? "<a href=\"#" + targets[r - others] + "\">" : "";
      text += "<" + cell + ">" + link + escaped(rows[r][i]) + (leads ? "</a>" : "") + "</" + cell + ">";
    }
    text += "</tr>\n";
  }
  return text + "</table></div>\n";
}

// Pictures side by side are shown at one scale: columns are as wide as they are.
std::string row_of_pictures(const std::vector<int>& widths) {
  std::string columns;
  for (const int width : widths) columns += " minmax(0, " + std::to_string(width) + "fr)";
  return "<div class=\"row\" style=\"--widths:" + columns + "\">\n";
}

Result<std::string> section(const Comparison& comparison, std::size_t index) {
  const Compared &reference = comparison.reference, &candidate = comparison.candidates[index];
  std::string text = "<section id=\"" + section_id(index) + "\"><h2>" + escaped(candidate.name) +
                     (candidate.title.empty() ? "" : " <small>" + escaped(candidate.title) + "</small>") +
                     "</h2>\n";
  const std::string pictures =
      figure(reference.image, "reference: " + reference.name) + figure(candidate.image, candidate.name);
  if (!candidate.difference) {
    return text + row_of_pictures({reference.width, candidate.width, reference.width}) + pictures +
           "<p>The sizes differ: there is nothing to measure.</p>\n</div></section>\n";
  }
  const Result<Image> map = difference_picture(reference.image, candidate.image);
  if (!map) return map.error();
  const int largest = candidate.difference->max_difference;
  const std::string caption = largest == 0 ? "no difference"
                                           : "difference, largest of the channels; the bar ends at " +
                                                 std::to_string(largest) + " of 255";
  return text + row_of_pictures({reference.width, candidate.width, map->width}) + pictures +
         figure(*map, caption) + "</div></section>\n";
}

}  // namespace

Result<std::string> comparison_page(const Comparison& comparison) {
  const std::string subject =
      escaped(comparison.of_methods() ? comparison.models : "against " + comparison.reference.name);
  std::string page =
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width\">\n<title>blysk compare: " +
      subject + "</title>\n<style>" + std::string(kStyle) + "</style>\n</head>\n<body>\n<h1>" + subject +
      "</h1>\n<p>" + escaped(comparison.setting) + (comparison.setting.empty() ? "" : "; ") + "blysk " +
      std::string(version()) + "</p>\n" + html_table(comparison);
  for (std::size_t i = 0; i < comparison.candidates.size(); ++i) {
    const Result<std::string> part = section(comparison, i);
    if (!part) return part.error();
    page += *part;
  }
  return page + "</body>\n</html>\n";
}

}  // namespace blysk::command
