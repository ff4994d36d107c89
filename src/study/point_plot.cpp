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

struct Box {
  double left, top, right, bottom;

  [[nodiscard]] bool meets(const Box& o) const {
    return left < o.right && o.left < right && top < o.bottom && o.top < bottom;
  }
};

struct Label {
  std::string text;
  double x, y;    ///< of its point
  double dx, dy;  ///< from there to the text's middle line, at its end next to the point
  [[nodiscard]] Box box() const {
    const double width = 7.2 * static_cast<double>(text.size()), from = x + dx - (dx < 0 ? width : 0);
    return {from, y + dy - kLabelHeight / 2, from + width, y + dy + kLabelHeight / 2};
  }
};

// Each label on the first place around its point where it meets no point, no other label and no axis.
void place(std::vector<Label>& labels) {
  constexpr double kRadius = 5, kBeside = 9;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    Label& l = labels[i];
    const auto is_free = [&] {
      const Box box = l.box();
      if (box.left < kLeft || box.right > kWidth || box.top < kTop - kLabelHeight ||
          box.bottom > kHeight - kBottom)
        return false;
      for (std::size_t k = 0; k < labels.size(); ++k) {
        const Label& o = labels[k];
        const Box point = {o.x - kRadius, o.y - kRadius, o.x + kRadius, o.y + kRadius};
        if (box.meets(point) || (k < i && box.meets(o.box()))) return false;
      }
      return true;
    };
    for (int row = 0; row < 40; ++row) {  // 0, one up, one down, two up, ...
      l.dy = (row % 2 == 1 ? -1 : 1) * ((row + 1) / 2) * (kLabelHeight - 1);
      l.dx = kBeside;
      if (is_free()) break;
      l.dx = -kBeside;
      if (is_free()) break;
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
  for (const PlotPoint& p : points) labels.push_back({p.label, x.at(p.x), y.at(shown_y(p)), 0, 0});
  place(labels);
  for (const Label& l : labels) {
    if (l.dy != 0) svg += svg_line(l.x, l.y, l.x + l.dx, l.y + l.dy, "#aaaaaa");
    svg +=
        "<circle cx=\"" + svg_number(l.x) + "\" cy=\"" + svg_number(l.y) + "\" r=\"4\" fill=\"#1f5fa8\"/>\n";
    svg += svg_text(l.x + l.dx, l.y + l.dy + 4, l.text,
                    l.dx < 0 ? "text-anchor=\"end\" fill=\"#1f2f4f\"" : "fill=\"#1f2f4f\"");
  }
  return svg + "</svg>\n";
}

}  // namespace blysk::study
