#include "study/point_plot.h"

#include <gtest/gtest.h>

#include <cctype>
#include <cmath>
#include <regex>

namespace blysk::study {
namespace {

std::size_t count_of(const std::string& text, std::string_view part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

TEST(point_plot, a_labelled_circle_for_every_point) {
  const std::string svg = point_plot({{"a<b", 2, 1e-3}, {"c", 30, 0}}, {"title", "cost", "error", 1e-8});
  EXPECT_TRUE(svg.starts_with("<svg "));
  EXPECT_TRUE(svg.ends_with("</svg>\n"));
  EXPECT_EQ(count_of(svg, "<circle"), 2u);
  EXPECT_NE(svg.find("a&lt;b"), std::string::npos);
  // A point under the floor lies on it, and its tick says that there may be less.
  EXPECT_EQ(count_of(svg, "&lt;= 1e-08"), 1u);
  EXPECT_EQ(svg.find("1e-09"), std::string::npos);
}

TEST(point_plot, nothing_to_show) {
  EXPECT_EQ(count_of(point_plot({}, {"title", "cost", "error", 0}), "<circle"), 0u);
  // What has no logarithm has no place.
  EXPECT_EQ(count_of(point_plot({{"a", 0, 1}}, {"title", "cost", "error", 0}), "<circle"), 0u);
}

// Places of the texts and circles, out of the SVG.
struct Mark {
  double x, y;
  std::string text;
  bool at_end;  // the text ends at x
};

std::vector<Mark> marks_of(const std::string& svg) {
  std::vector<Mark> marks;
  const std::regex mark(R"re(<(?:circle cx|text x)="([^"]+)" (?:c?y)="([^"]+)"([^>]*)>([^<]*))re");
  for (std::sregex_iterator i(svg.begin(), svg.end(), mark), end; i != end; ++i) {
    marks.push_back({std::stod((*i)[1]), std::stod((*i)[2]),
                     (*i)[4].str().substr(0, (*i)[4].str().find('\n')),
                     (*i)[3].str().find("\"end\"") != std::string::npos});
  }
  return marks;
}

TEST(point_plot, labels_meet_no_point_and_no_label) {
  const std::string svg = point_plot({{"one", 2, 1e-3},
                                      {"two", 2, 1e-3},
                                      {"a-long-label", 2.1, 1e-3},
                                      {"on-the-floor", 5, 0},
                                      {"beside", 5.2, 0},
                                      {"far-right", 20, 1e-6}},
                                     {"title", "cost", "error", 1e-8});
  const std::vector<Mark> marks = marks_of(svg);
  const auto is_label = [](const Mark& m) { return m.text.size() > 2 && std::isalpha(m.text[0]) != 0; };
  int labels = 0;
  for (const Mark& l : marks) {
    if (!is_label(l) || l.text == "title" || l.text == "cost" || l.text == "error") continue;
    ++labels;
    const double width = 7 * static_cast<double>(l.text.size()), left = l.at_end ? l.x - width : l.x;
    for (const Mark& o : marks) {
      if (&o == &l) continue;
      if (o.text.empty()) {  // a circle
        EXPECT_FALSE(o.x > left && o.x < left + width && std::abs(o.y - (l.y - 4)) < 7) << l.text;
      } else if (is_label(o)) {
        const double other = 7 * static_cast<double>(o.text.size()), from = o.at_end ? o.x - other : o.x;
        EXPECT_FALSE(from < left + width && left < from + other && std::abs(o.y - l.y) < 10)
            << l.text << " and " << o.text;
      }
    }
  }
  EXPECT_EQ(labels, 6);
}

}  // namespace
}  // namespace blysk::study
