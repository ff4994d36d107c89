// io/text.h - words and numbers of a text file, without locale and without copies.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace blysk::io {

/// A number in full: decimal, with sign and exponent, "nan" and "inf" in any case. What is beyond float
/// becomes zero or infinite. False where `word` is not a number.
[[nodiscard]] bool parse_number(std::string_view word, float& value);
[[nodiscard]] bool parse_number(std::string_view word, double& value);
/// A whole number from -2^63 to 2^63 - 1; a sign in front is allowed.
[[nodiscard]] bool parse_number(std::string_view word, long long& value);

/// Whether a word is `lower`, in letters of any size.
inline bool same_word(std::string_view word, std::string_view lower) {
  return std::equal(word.begin(), word.end(), lower.begin(), lower.end(),
                    [](char a, char b) { return a == b || (a >= 'A' && a <= 'Z' && a - 'A' + 'a' == b); });
}

/// Walks through a text from word to word.
class TextCursor {
 public:
  explicit TextCursor(std::string_view text) : begin_(text.data()), at_(begin_), end_(begin_ + text.size()) {}

  [[nodiscard]] bool at_end() const { return at_ == end_; }
  [[nodiscard]] std::size_t offset() const { return static_cast<std::size_t>(at_ - begin_); }
  [[nodiscard]] std::size_t left() const { return static_cast<std::size_t>(end_ - at_); }

  void skip_space() {
    while (at_ != end_ && is_space(*at_)) ++at_;
  }
  /// Spaces and tabs, but not the end of the line.
  void skip_blanks() {
    while (at_ != end_ && is_space(*at_) && !ends_line(*at_)) ++at_;
  }
  /// Whether only blanks are left on the line; steps over them.
  [[nodiscard]] bool at_line_end() {
    skip_blanks();
    return at_ == end_ || ends_line(*at_);
  }
  /// Space, line ends and comments from `mark` to the end of their line.
  void skip_comments(char mark) {
    for (skip_space(); at_ != end_ && *at_ == mark; skip_space()) line();
  }
  /// The next word after any space; empty at the end.
  std::string_view word() {
    skip_space();
    const char* start = at_;
    while (at_ != end_ && !is_space(*at_)) ++at_;
    return {start, static_cast<std::size_t>(at_ - start)};
  }
  /// The rest of the line; steps over its end (LF, CR or CR LF).
  std::string_view line() {
    const char* start = at_;
    while (at_ != end_ && !ends_line(*at_)) ++at_;
    const std::string_view rest(start, static_cast<std::size_t>(at_ - start));
    if (at_ != end_ && *at_ == '\r') ++at_;
    if (at_ != end_ && *at_ == '\n' && (at_ == start + rest.size() || at_[-1] == '\r')) ++at_;
    return rest;
  }
  /// The next word as a number; false, and no step, where it is none.
  template <class T>
  [[nodiscard]] bool number(T& value) {
    skip_space();
    const char* start = at_;
    if (parse_number(word(), value)) return true;
    at_ = start;
    return false;
  }

 private:
  static bool ends_line(char c) { return c == '\n' || c == '\r'; }
  static bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

  const char* begin_;
  const char* at_;
  const char* end_;
};

}  // namespace blysk::io
