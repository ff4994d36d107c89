// io/obj_text.h - the text of an OBJ file, cut at line ends into pieces that are read side by side.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "blysk/array.h"

namespace blysk::io {

/// Whole lines: the last byte is a line feed, and kTextPadding readable bytes follow it.
struct ObjPiece {
  const char* begin = nullptr;
  const char* end = nullptr;
  std::size_t offset = 0;  ///< of `begin` in the file
};

/// Where pieces are cut depends on the text alone, never on the number of threads. `text` must stay.
class ObjText {
 public:
  // Large enough that a piece's own costs vanish, small enough that two threads end together.
  static constexpr std::size_t kPieceBytes = std::size_t{1} << 20;

  explicit ObjText(std::string_view text, std::size_t piece_bytes = kPieceBytes);
  ObjText(const ObjText&) = delete;
  ObjText& operator=(const ObjText&) = delete;

  [[nodiscard]] std::span<const ObjPiece> pieces() const { return pieces_; }
  /// Puts spaces where a backslash ends a line, except in comments: paths of Windows end like that.
  void join_continued_lines();
  /// Number of the line, from 1, that a byte of the file is in.
  [[nodiscard]] long long line_of(std::size_t offset) const;

 private:
  void split();

  std::size_t piece_bytes_;
  std::string_view file_;
  std::string_view text_;  // perhaps in mended_
  Array<char> mended_;
  Array<char> tail_;  // the last lines, which the file gives neither a line feed nor padding
  std::vector<ObjPiece> pieces_;
};

inline bool is_blank_or_end(char c) { return static_cast<unsigned char>(c) <= ' '; }

/// The next byte that is not blank, or the line's end. Control characters count as blanks.
inline const char* skip_blanks(const char* at) {
  while (is_blank_or_end(*at) && *at != '\n') ++at;
  return at;
}

/// Without blanks in front and behind.
[[nodiscard]] std::string_view trimmed(std::string_view text);
/// `text` without control characters, which could steer a terminal: question marks stand for them.
[[nodiscard]] std::string printable(std::string_view text);
/// The same for a message: in quotes, and no longer than a line can bear.
[[nodiscard]] std::string in_quotes(std::string_view text);

}  // namespace blysk::io
