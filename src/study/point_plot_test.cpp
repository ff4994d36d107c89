#include "study/point_plot.h"

#include <gtest/gtest.h>

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

TEST(point_plot, labels_do_not_overlap) {
  const std::string svg =
      point_plot({{"one", 2, 1e-3}, {"two", 2, 1e-3}, {"far", 20, 1e-6}}, {"title", "cost", "error", 1e-8});
  const auto y_of = [&](std::string_view label) {
    const std::size_t end = svg.rfind("y=\"", svg.find(std::string(label) + "</text>"));
    return std::stod(svg.substr(end + 3));
  };
  EXPECT_GE(std::abs(y_of(">one") - y_of(">two")), 10);
}

}  // namespace
}  // namespace blysk::study
