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
th { font-size: .8rem; opacity: .75; }
section { border-top: 1px solid var(--line); padding: 1.25rem 0; }
.row { display: grid; gap: 1rem; grid-template-columns: 1fr 1fr 1fr; align-items: start; }
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

std::string html_table(const std::vector<std::vector<std::string>>& rows) {
  std::string text = "<div class=\"scroll\"><table>\n";
  std::string_view cell = "th";
  for (const auto& row : rows) {
    text += "<tr>";
    for (const std::string& words : row) {
      text += "<" + std::string(cell) + ">" + escaped(words) + "</" + std::string(cell) + ">";
    }
    text += "</tr>\n";
    cell = "td";
  }
  return text + "</table></div>\n";
}

Result<std::string> section(const Comparison& comparison, const Compared& candidate) {
  const Compared& reference = comparison.reference;
  std::string text = "<section><h2>" + escaped(candidate.name) +
                     (candidate.title.empty() ? "" : " <small>" + escaped(candidate.title) + "</small>") +
                     "</h2>\n<div class=\"row\">\n" +
                     figure(reference.image, "reference: " + reference.name) +
                     figure(candidate.image, candidate.name);
  if (candidate.difference) {
    const Result<Image> map = difference_picture(reference.image, candidate.image);
    if (!map) return map.error();
    text += figure(*map, "largest difference of any channel, 0 to 255");
  } else {
    text += "<p>The sizes differ: there is nothing to measure.</p>\n";
  }
  return text + "</div></section>\n";
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
      std::string(version()) + "</p>\n" + html_table(comparison_rows(comparison));
  for (const Compared& candidate : comparison.candidates) {
    const Result<std::string> part = section(comparison, candidate);
    if (!part) return part.error();
    page += *part;
  }
  return page + "</body>\n</html>\n";
}

}  // namespace blysk::command
