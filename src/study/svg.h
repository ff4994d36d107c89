// study/svg.h - pieces of SVG documents, tenths of a pixel: equal figures give equal files.
#pragma once

#include <string>
#include <string_view>

namespace blysk::study {

[[nodiscard]] std::string svg_number(double value);
[[nodiscard]] std::string svg_escaped(std::string_view text);
/// `attributes` as they stand in the element.
[[nodiscard]] std::string svg_text(double x, double y, std::string_view text, std::string_view attributes);
[[nodiscard]] std::string svg_line(double x1, double y1, double x2, double y2, std::string_view color);
/// The document's first lines: its size, and a white background.
[[nodiscard]] std::string svg_head(double width, double height, int font_size);

}  // namespace blysk::study
