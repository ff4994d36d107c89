#include "io/obj_text.h"

#include <algorithm>
#include <cstring>
#include <string>

#include "io/decimal.h"

namespace blysk::io {
ObjText::ObjText(std::string_view text, std::size_t piece_bytes)
    : piece_bytes_(piece_bytes), file_(text), text_(text) {
  // Lines of the old Mac end in a carriage return alone.
  if (text_.find('\n') == std::string_view::npos && text_.find('\r') != std::string_view::npos) {
    mended_.assign(text_.begin(), text_.end());
    std::replace(mended_.begin(), mended_.end(), '\r', '\n');
    text_ = {mended_.data(), mended_.size()};
  }
  split();
}

void ObjText::split() {
  pieces_.clear();
  const char* const begin = text_.data();
  const auto offset = [&](const char* at) { return static_cast<std::size_t>(at - begin); };
  // Pieces of the text itself end where padding is left behind them.
  std::size_t tail = 0;
  if (text_.size() > piece_bytes_ + kTextPadding) {
    tail = text_.rfind('\n', text_.size() - 1 - kTextPadding);
    tail = tail == std::string_view::npos ? 0 : tail + 1;
  }
  for (const char* at = begin; at != begin + tail;) {
    const std::size_t left = tail - static_cast<std::size_t>(at - begin);
    const char* end = at + left;
    if (left > piece_bytes_) {
      end = static_cast<const char*>(std::memchr(at + piece_bytes_, '\n', left - piece_bytes_)) + 1;
    }
    pieces_.push_back({at, end, offset(at)});
    at = end;
  }
  const std::string_view rest = text_.substr(tail);
  tail_.assign(rest.begin(), rest.end());
  tail_.resize(rest.size() + 1 + kTextPadding, '\n');
  pieces_.push_back({tail_.data(), tail_.data() + rest.size() + 1, offset(begin + tail)});
}

void ObjText::join_continued_lines() {
  if (mended_.empty()) mended_.assign(text_.begin(), text_.end());
  const std::size_t size = mended_.size();
  bool comment = false, line_starts = true;
  for (std::size_t i = 0; i < size; ++i) {
    const char c = mended_[i];
    if (line_starts && (!is_blank_or_end(c) || c == '\n')) {
      comment = c == '#';
      line_starts = c == '\n';
    } else if (c == '\n') {
      line_starts = true;
    }
    if (c != '\\' || comment) continue;
    const std::size_t feed = i + 1 < size && mended_[i + 1] == '\r' ? i + 2 : i + 1;
    if (feed < size && mended_[feed] != '\n') continue;
    for (; i < std::min(feed + 1, size); ++i) mended_[i] = ' ';
    --i;
  }
  text_ = {mended_.data(), size};
  split();
}

long long ObjText::line_of(std::size_t offset) const {
  const std::string_view before = file_.substr(0, offset);
  const char mark = file_.find('\n') == std::string_view::npos ? '\r' : '\n';
  return std::count(before.begin(), before.end(), mark) + 1;
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank_or_end(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank_or_end(text.back())) text.remove_suffix(1);
  return text;
}

std::string printable(std::string_view text) {
  std::string shown(text);
  for (char& c : shown) c = static_cast<unsigned char>(c) < ' ' || c == 0x7f ? '?' : c;
  return shown;
}

std::string in_quotes(std::string_view text) {
  constexpr std::size_t kLongest = 60;
  std::size_t length = std::min(text.size(), kLongest);
  // A character of several bytes is not cut in two.
  while (length < text.size() && length > 0 && (text[length] & 0xc0) == 0x80) --length;
  std::string shown(1, '\'');
  shown += printable(text.substr(0, length));
  return shown += length < text.size() ? "...'" : "'";
}

}  // namespace blysk::io
