// study/log_plot.h - small plots side by side, one logarithmic scale for all.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace blysk::study {

struct Curve {
  std::string name;
  std::vector<std::pair<double, double>> points;  ///< x ascending; y <= 0 is below the plot
};

struct Panel {
  std::string title;
  std::vector<Curve> curves;  ///< the same names in every panel: the legend is that of the first
};

struct LogPlotOptions {
  std::string x_label, y_label;
  double x_low = 1, x_high = 8;  ///< whole numbers, a tick each
  int y_low = -7, y_high = 0;    ///< powers of ten
  int columns = 3;
};

/// An SVG document.
[[nodiscard]] std::string log_plot(const std::vector<Panel>& panels, const LogPlotOptions& options);

}  // namespace blysk::study
