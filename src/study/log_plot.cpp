#include "study/log_plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "study/svg.h"

namespace blysk::study {
namespace {

constexpr double kFrameWidth = 250, kFrameHeight = 170, kFrameLeft = 46, kFrameTop = 46, kFrameGap = 50;

// Told apart by those who do not see all colours: M. Okabe, K. Ito. Color Universal Design. 2008.
constexpr std::array<std::string_view, 8> kColors = {"#000000", "#e69f00", "#56b4e9", "#d55e00",
                                                     "#0072b2", "#009e73", "#cc79a7", "#999999"};

std::string anchored(double x, double y, std::string_view anchor, std::string_view text) {
  return svg_text(x, y, text, std::string("text-anchor=\"") + std::string(anchor) + "\"");
}

class PlotFrame {
 public:
  PlotFrame(const LogPlotOptions& options, std::size_t index) : options_(options) {
    const auto columns = static_cast<std::size_t>(options.columns);
    left_ = kFrameLeft + static_cast<double>(index % columns) * (kFrameWidth + kFrameGap);
    top_ = kFrameTop + static_cast<double>(index / columns) * (kFrameHeight + kFrameGap);
  }

  [[nodiscard]] std::string draw(const Panel& panel) const {
    std::string svg = anchored(left_ + kFrameWidth / 2, top_ - 6, "middle", panel.title);
    for (int power = options_.y_low; power <= options_.y_high; ++power) {
      svg += svg_line(left_, row(power), left_ + kFrameWidth, row(power), "#dddddd");
      svg += anchored(left_ - 4, row(power) + 3, "end", std::to_string(power).insert(0, "1e"));
    }
    for (int x = static_cast<int>(options_.x_low); x <= static_cast<int>(options_.x_high); ++x) {
      svg += anchored(column(x), top_ + kFrameHeight + 14, "middle", std::to_string(x));
    }
    for (std::size_t i = 0; i < panel.curves.size(); ++i) svg += curve(panel.curves[i], i);
    return svg;
  }

 private:
  [[nodiscard]] double column(double x) const {
    return left_ + (x - options_.x_low) / (options_.x_high - options_.x_low) * kFrameWidth;
  }
  [[nodiscard]] double row(double power) const {
    const double inside = std::clamp<double>(power, options_.y_low, options_.y_high);
    return top_ + (options_.y_high - inside) / (options_.y_high - options_.y_low) * kFrameHeight;
  }
  [[nodiscard]] std::string curve(const Curve& c, std::size_t index) const {
    std::string points;
    for (const auto& [x, y] : c.points) {
      const double power = y > 0 ? std::log10(y) : options_.y_low;  // deterministic: drawn to a tenth
      points += svg_number(column(x)) + "," + svg_number(row(power)) + " ";
      if (!(y > 0)) break;  // nothing is left to improve
    }
    return "<polyline fill=\"none\" stroke=\"" + std::string(kColors[index % kColors.size()]) +
           "\" stroke-width=\"1.5\" points=\"" + points + "\"/>\n";
  }

  const LogPlotOptions& options_;
  double left_, top_;
};

}  // namespace

std::string log_plot(const std::vector<Panel>& panels, const LogPlotOptions& options) {
  const auto columns = static_cast<std::size_t>(options.columns);
  const std::size_t rows = (panels.size() + columns - 1) / columns;
  const double width = kFrameLeft + static_cast<double>(columns) * (kFrameWidth + kFrameGap) - kFrameGap + 12,
               height = kFrameTop + static_cast<double>(rows) * (kFrameHeight + kFrameGap);
  std::string svg = svg_head(width, height, 10);
  double at = kFrameLeft;
  for (std::size_t i = 0; !panels.empty() && i < panels.front().curves.size(); ++i, at += 70) {
    svg += svg_line(at, 14, at + 18, 14, kColors[i % kColors.size()]);
    svg += anchored(at + 22, 17, "start", panels.front().curves[i].name);
  }
  svg += anchored(width - 12, 17, "end", options.y_label + " against " + options.x_label);
  for (std::size_t i = 0; i < panels.size(); ++i) svg += PlotFrame(options, i).draw(panels[i]);
  return svg + "</svg>\n";
}

}  // namespace blysk::study
