// text.h - numbers and words, locale-independent.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace blysk::command {

/// Shortest text that reads back as the same number.
[[nodiscard]] std::string number_text(double value);
[[nodiscard]] std::string number_text(float value);
/// With this many digits after the point.
[[nodiscard]] std::string fixed_text(double value, int digits);
/// Six significant digits, for reading only.
[[nodiscard]] std::string rounded_text(double value);
/// 1234567 as "1,234,567".
[[nodiscard]] std::string count_text(std::uint64_t value);
/// "1 triangle", "2,000 triangles".
[[nodiscard]] std::string counted(std::uint64_t value, std::string_view noun);

/// Of at least one value.
[[nodiscard]] double median(std::vector<double> values);

/// The number that the whole text is; none if it is anything else, or not finite.
[[nodiscard]] std::optional<double> parse_number(std::string_view text);
[[nodiscard]] std::vector<std::string> split(std::string_view text, char separator);
[[nodiscard]] std::string join(const std::vector<std::string>& words, std::string_view separator);

/// The choice that `word` probably meant; empty if none is near.
[[nodiscard]] std::string suggestion(std::string_view word, const std::vector<std::string>& choices);
/// ", did you mean X?" or nothing.
[[nodiscard]] std::string did_you_mean(std::string_view word, const std::vector<std::string>& choices);

/// The text as one line that cannot steer a terminal: control characters become '?'.
[[nodiscard]] std::string printable(std::string_view text);

/// Lines of at most `width` characters, every line but the first indented by `indent` spaces.
[[nodiscard]] std::string wrap(std::string_view text, int width, int indent);

/// Rows with their columns aligned, two spaces between them, a newline after each row.
[[nodiscard]] std::string table(const std::vector<std::vector<std::string>>& rows);

}  // namespace blysk::command
