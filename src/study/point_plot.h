// study/point_plot.h - labelled points in a plane of logarithmic axes.
#pragma once

#include <string>
#include <vector>

namespace blysk::study {

struct PlotPoint {
  std::string label;
  double x = 0, y = 0;
};

struct PointPlotOptions {
  std::string title, x_label, y_label;
  double y_floor = 0;  ///< points that lie under it are drawn on it
};

/// An SVG document.
[[nodiscard]] std::string point_plot(const std::vector<PlotPoint>& points, const PointPlotOptions& options);

}  // namespace blysk::study
