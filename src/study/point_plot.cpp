// A plot as SVG: logarithmic axes, a labelled point for each entry. Numbers are written with fixed digits, so
// that equal figures give equal files.
#include "study/point_plot.h"

#include <algorithm>
#include <cmath>

#include "study/cells.h"
#include "study/svg.h"

namespace blysk::study {
namespace {

constexpr double kWidth = 900, kHeight = 560, kLeft = 90, kRight = 190, kTop = 50, kBottom = 60;
constexpr double kLabelHeight = 14;

// A logarithmic axis between whole powers of ten, or of two where it is short.
class Axis {
 public:
  Axis(double low, double high, double from, double to) : from_(from), to_(to) {
    base_ = high / low < 50 ? 2 : 10;
    low_ = std::floor(order(low) + 1e-9);
    high_ = std::max(low_ + 1, std::ceil(order(high) - 1e-9));
  }
  [[nodiscard]] double at(double value) const {
    return from_ + (order(value) - low_) / (high_ - low_) * (to_ - from_);
  }
  [[nodiscard]] std::vector<double> ticks() const {
    std::vector<double> values;
    double value = 1;
    for (double p = 0; p > low_; --p) value /= base_;
    for (double p = 0; p < low_; ++p) value *= base_;
    for (double p = low_; p <= high_; ++p, value *= base_) values.push_back(value);
    return values;
  }

 private:
  [[nodiscard]] double order(double value) const {
    return std::log2(value) / std::log2(base_);  // deterministic: places of points in a plot
  }

  double from_, to_, base_ = 10, low_ = 0, high_ = 1;
};

struct Label {
  std::string text;
  double x, y, shown_y;
};

// Labels one under the other where they would overlap.
void spread(std::vector<Label>& labels) {
  std::ranges::sort(labels,
                    [](const Label& a, const Label& b) { return a.y < b.y || (a.y == b.y && a.x < b.x); });
  for (std::size_t i = 0; i < labels.size(); ++i) {
    Label& l = labels[i];
    l.shown_y = l.y;
    for (std::size_t k = 0; k < i; ++k) {
      const Label& other = labels[k];
      const double apart = 6.6 * static_cast<double>(std::max(l.text.size(), other.text.size())) + 10;
      if (std::abs(other.x - l.x) < apart) l.shown_y = std::max(l.shown_y, other.shown_y + kLabelHeight);
    }
  }
}

}  // namespace

std::string point_plot(const std::vector<PlotPoint>& points, const PointPlotOptions& options) {
  double low_x = 1e300, high_x = 0, low_y = 1e300, high_y = 0;
  const auto shown_y = [&](const PlotPoint& p) { return std::max(p.y, options.y_floor); };
  for (const PlotPoint& p : points) {
    low_x = std::min(low_x, p.x), high_x = std::max(high_x, p.x);
    low_y = std::min(low_y, shown_y(p)), high_y = std::max(high_y, shown_y(p));
  }
  std::string svg = svg_head(kWidth, kHeight, 12);
  svg += svg_text(kLeft, 28, options.title, "font-size=\"15\" fill=\"#222222\"");
  if (points.empty() || !(low_x > 0) || !(low_y > 0)) return svg + "</svg>\n";
  const Axis x(low_x, high_x, kLeft, kWidth - kRight), y(low_y, high_y, kHeight - kBottom, kTop);
  for (const double tick : x.ticks()) {
    svg += svg_line(x.at(tick), kTop, x.at(tick), kHeight - kBottom, "#dddddd");
    svg += svg_text(x.at(tick), kHeight - kBottom + 18, significant_text(tick, 3),
                    "text-anchor=\"middle\" fill=\"#555555\"");
  }
  for (const double tick : y.ticks()) {
    svg += svg_line(kLeft, y.at(tick), kWidth - kRight, y.at(tick), "#dddddd");
    const bool floor = tick <= options.y_floor * 1.0001;
    svg += svg_text(kLeft - 8, y.at(tick) + 4, (floor ? "<= " : "") + significant_text(tick, 3),
                    "text-anchor=\"end\" fill=\"#555555\"");
  }
  svg += svg_text((kLeft + kWidth - kRight) / 2, kHeight - 16, options.x_label,
                  "text-anchor=\"middle\" fill=\"#222222\"");
  svg += svg_text(0, 0, options.y_label,
                  "text-anchor=\"middle\" fill=\"#222222\" transform=\"translate(18 " +
                      svg_number(kHeight / 2) + ") rotate(-90)\"");
  std::vector<Label> labels;
  for (const PlotPoint& p : points) labels.push_back({p.label, x.at(p.x), y.at(shown_y(p)), 0});
  spread(labels);
  for (const Label& l : labels) {
    if (l.shown_y != l.y) svg += svg_line(l.x, l.y, l.x + 8, l.shown_y, "#aaaaaa");
    svg +=
        "<circle cx=\"" + svg_number(l.x) + "\" cy=\"" + svg_number(l.y) + "\" r=\"4\" fill=\"#1f5fa8\"/>\n";
    svg += svg_text(l.x + 9, l.shown_y + 4, l.text, "fill=\"#1f2f4f\"");
  }
  return svg + "</svg>\n";
}

}  // namespace blysk::study
