#include "io/ply_header.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <utility>

#include "io/text.h"

namespace blysk::io {
namespace {

constexpr std::uint64_t kMostVertices = 0xfffffffe;  // indices have 32 bits, one is kept for none

struct TypeName {
  std::string_view name;
  PlyType type;
};
constexpr TypeName kTypeNames[] = {
    {"char", PlyType::int8},      {"int8", PlyType::int8},       {"uchar", PlyType::uint8},
    {"uint8", PlyType::uint8},    {"short", PlyType::int16},     {"int16", PlyType::int16},
    {"ushort", PlyType::uint16},  {"uint16", PlyType::uint16},   {"int", PlyType::int32},
    {"int32", PlyType::int32},    {"uint", PlyType::uint32},     {"uint32", PlyType::uint32},
    {"float", PlyType::float32},  {"float32", PlyType::float32}, {"double", PlyType::float64},
    {"float64", PlyType::float64}};

std::optional<PlyType> find_type(std::string_view word) {
  for (const TypeName& t : kTypeNames) {
    if (t.name == word) return t.type;
  }
  return std::nullopt;
}

std::string in_quotes(std::string_view word) {
  constexpr std::size_t kShown = 40;
  std::string shown = "'";
  for (const char c : word.substr(0, kShown)) shown += c >= ' ' && c <= '~' ? c : '?';
  return shown + "'";
}

class HeaderParser {
 public:
  explicit HeaderParser(const Source& source) : source_(source), text_(source.text()) {
    const std::size_t first = text_.find_first_of("\r\n");
    const bool only_cr = first != std::string_view::npos && text_[first] == '\r' &&
                         (first + 1 == text_.size() || text_[first + 1] != '\n');
    line_end_ = only_cr ? '\r' : '\n';
  }

  Result<PlyHeader> parse() {
    if (TextCursor(next_line()).word() != "ply") return fail("does not begin with 'ply'");
    for (;;) {
      if (at_ == text_.size()) return fail("is cut short: the header has no end_header");
      line_start_ = at_;
      TextCursor line(next_line());
      const std::string_view word = line.word();
      if (word == "end_header") break;
      if (Status s = parse_line(word, line); !s) return s.error();
    }
    if (!has_format_) return fail("has no format line in its header");
    header_.data_offset = at_;
    return std::move(header_);
  }

 private:
  // The line without its end. Binary data may follow the last one, so that CR and LF are not mixed.
  std::string_view next_line() {
    const std::size_t end = std::min(text_.find(line_end_, at_), text_.size());
    std::string_view line = text_.substr(at_, end - at_);
    at_ = std::min(end + 1, text_.size());
    if (line.ends_with('\r')) line.remove_suffix(1);
    return line;
  }

  Error fail(const std::string& message) const {
    return broken_at(source_, line_start_, message + "; mend the header or export the model again");
  }

  Status parse_line(std::string_view word, TextCursor& line) {
    if (word.empty() || word == "obj_info") return Done{};
    if (word == "comment") {
      if (line.word() == "TextureFile") {
        line.skip_blanks();
        header_.texture = std::string(line.line());
      }
      return Done{};
    }
    Status status = word == "format"     ? parse_format(line)
                    : word == "element"  ? parse_element(line)
                    : word == "property" ? parse_property(line)
                                         : fail("unknown word " + in_quotes(word) + " in the PLY header");
    if (!status) return status;
    if (const std::string_view extra = line.word(); !extra.empty()) {
      return fail("unexpected " + in_quotes(extra) + " at the end of a PLY header line");
    }
    return Done{};
  }

  Status parse_format(TextCursor& line) {
    const std::string_view name = line.word(), version = line.word();
    if (name == "ascii") {
      header_.format = PlyFormat::ascii;
    } else if (name == "binary_little_endian") {
      header_.format = PlyFormat::little_endian;
    } else if (name == "binary_big_endian") {
      header_.format = PlyFormat::big_endian;
    } else {
      return fail("unknown PLY format " + in_quotes(name));
    }
    if (version != "1.0") return fail("unknown PLY version " + in_quotes(version));
    if (has_format_) return fail("a second format line in the PLY header");
    has_format_ = true;
    return Done{};
  }

  Status parse_element(TextCursor& line) {
    if (!has_format_) return fail("the PLY header's format line must come before its elements");
    PlyElement element;
    element.name = std::string(line.word());
    const std::string_view number = line.word();
    long long count = 0;
    if (!parse_number(number, count) || count < 0 || number.starts_with('+')) {
      return fail("element " + in_quotes(element.name) + " has " + in_quotes(number) + " for its count");
    }
    element.count = static_cast<std::uint64_t>(count);
    if (element.name == "vertex" && element.count > kMostVertices) {
      return fail("has more vertices than 32-bit indices can name");
    }
    header_.elements.push_back(std::move(element));
    return Done{};
  }

  Status parse_property(TextCursor& line) {
    if (header_.elements.empty()) return fail("a property comes before the first element");
    PlyProperty property;
    std::string_view word = line.word();
    if (word == "list") {
      property.is_list = true;
      const std::string_view count_word = line.word();
      const auto count_type = find_type(count_word);
      if (!count_type) return fail("unknown PLY type " + in_quotes(count_word));
      if (!is_integer(*count_type))
        return fail("a list's length cannot have the type " + in_quotes(count_word));
      property.count_type = *count_type;
      word = line.word();
    }
    const auto type = find_type(word);
    if (!type) return fail("unknown PLY type " + in_quotes(word));
    property.type = *type;
    property.name = std::string(line.word());
    if (property.name.empty()) return fail("a property without a name");
    header_.elements.back().properties.push_back(std::move(property));
    return Done{};
  }

  const Source& source_;
  std::string_view text_;
  std::size_t at_ = 0, line_start_ = 0;
  char line_end_;
  bool has_format_ = false;
  PlyHeader header_;
};

}  // namespace

std::size_t size_of(PlyType type) {
  constexpr std::array<std::size_t, 8> kSizes = {1, 1, 2, 2, 4, 4, 4, 8};
  return kSizes[static_cast<std::size_t>(type)];
}

bool is_integer(PlyType type) { return type < PlyType::float32; }

bool PlyElement::has_lists() const {
  return std::any_of(properties.begin(), properties.end(), [](const PlyProperty& p) { return p.is_list; });
}

std::size_t PlyElement::least_row_bytes(PlyFormat format) const {
  std::size_t bytes = 0;
  for (const PlyProperty& p : properties) {
    // A digit and what separates it from the next.
    bytes += format == PlyFormat::ascii ? 2 : size_of(p.is_list ? p.count_type : p.type);
  }
  return bytes;
}

Result<PlyHeader> read_ply_header(const Source& source) { return HeaderParser(source).parse(); }

}  // namespace blysk::io
