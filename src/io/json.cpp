#include "io/json.h"

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

namespace blysk::io {
namespace {

constexpr std::size_t kMaxText = std::numeric_limits<std::uint32_t>::max();
constexpr std::size_t kMaxName = (std::size_t{1} << 29) - 1;

// What the parser says, without its prefix "[json.exception...] parse error at line 1, column 2: ".
std::string complaint(const std::string& what) {
  constexpr std::size_t kLongest = 160;
  const std::size_t column = what.find("column ");
  const std::size_t colon = column == std::string::npos ? column : what.find(": ", column);
  std::string text = colon == std::string::npos ? what : what.substr(colon + 2);
  if (text.size() > kLongest) text = text.substr(0, kLongest) + "...";
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return text;
}

}  // namespace

// Receives the parser's events. Returning false ends the parsing.
class JsonBuilder : public nlohmann::json::json_sax_t {
 public:
  explicit JsonBuilder(JsonDocument& document) : document_(document) {}

  bool null() override { return add(Json::Kind::null, 0.0); }
  bool boolean(bool value) override { return add(Json::Kind::boolean, value ? 1.0 : 0.0); }
  bool number_integer(number_integer_t value) override {
    return add(Json::Kind::number, static_cast<double>(value));
  }
  bool number_unsigned(number_unsigned_t value) override {
    return add(Json::Kind::number, static_cast<double>(value));
  }
  bool number_float(number_float_t value, const string_t&) override { return add(Json::Kind::number, value); }
  bool string(string_t& value) override {
    const JsonDocument::Span span = keep(value);
    return add(Json::Kind::string, span);
  }
  bool binary(binary_t&) override { return false; }
  bool start_object(std::size_t) override { return open(Json::Kind::object); }
  bool end_object() override { return close(); }
  bool start_array(std::size_t) override { return open(Json::Kind::array); }
  bool end_array() override { return close(); }

  bool key(string_t& value) override {
    if (value.size() > kMaxName) {
      message = "a member's name is longer than " + std::to_string(kMaxName) + " bytes";
      return false;
    }
    name_ = keep(value);
    return true;
  }

  bool parse_error(std::size_t at, const std::string&, const nlohmann::detail::exception& error) override {
    position = at;
    message = complaint(error.what());
    return false;
  }

  std::string message;
  std::size_t position = 0;  // of the error, bytes read; 0: not known

 private:
  JsonDocument::Span keep(const std::string& value) {
    const JsonDocument::Span span{static_cast<std::uint32_t>(document_.text_.size()),
                                  static_cast<std::uint32_t>(value.size())};
    document_.text_ += value;
    return span;
  }

  JsonDocument::Node& append(Json::Kind kind) {
    if (!open_.empty()) ++document_.nodes_[open_.back()].span.count;
    JsonDocument::Node& node = document_.nodes_.emplace_back();
    node.kind = static_cast<std::uint32_t>(kind) & 7;
    node.name_offset = name_.first;
    node.name_length = name_.count & kMaxName;
    name_ = {0, 0};
    return node;
  }
  bool add(Json::Kind kind, double number) {
    append(kind).number = number;
    return true;
  }
  bool add(Json::Kind kind, JsonDocument::Span span) {
    append(kind).span = span;
    return true;
  }

  bool open(Json::Kind kind) {
    if (open_.size() == kMaxJsonDepth) {
      message = "values are nested deeper than " + std::to_string(kMaxJsonDepth) + " levels";
      return false;
    }
    add(kind, JsonDocument::Span{0, 0});
    open_.push_back(static_cast<std::uint32_t>(document_.nodes_.size() - 1));
    return true;
  }
  bool close() {
    document_.nodes_[open_.back()].span.first = static_cast<std::uint32_t>(document_.nodes_.size());
    open_.pop_back();
    return true;
  }

  JsonDocument& document_;
  std::vector<std::uint32_t> open_;  // containers that are not closed yet
  JsonDocument::Span name_{0, 0};    // of the next value
};

Result<JsonDocument> JsonDocument::parse(std::string_view text) {
  if (text.size() > kMaxText) {
    return Error{ErrorCode::input, "the JSON text is larger than 4 GiB; keep its data in a .bin or .glb file",
                 "", 0};
  }
  JsonDocument document;
  JsonBuilder builder(document);
  if (nlohmann::json::sax_parse(text.data(), text.data() + text.size(), &builder)) return document;
  Error error{ErrorCode::input, "the JSON text is broken: " + builder.message, "", 0};
  if (builder.position > 0) {
    const std::size_t read = std::min(builder.position, text.size());
    error.message += " (at byte " + std::to_string(read) + ")";
    error.line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(read), '\n');
  }
  error.message += "; fetch or export the file again";
  return error;
}

std::uint32_t JsonDocument::behind(std::uint32_t index) const {
  const auto kind = static_cast<Json::Kind>(nodes_[index].kind);
  const bool container = kind == Json::Kind::array || kind == Json::Kind::object;
  return container ? nodes_[index].span.first : index + 1;
}

Json::Kind Json::kind() const {
  return document_ == nullptr ? Kind::none : static_cast<Kind>(document_->nodes_[index_].kind);
}

Json Json::operator[](std::string_view wanted) const {
  if (kind() != Kind::object) return {};
  for (std::uint32_t i = index_ + 1; i < document_->behind(index_); i = document_->behind(i)) {
    const Json item(document_, i);
    if (item.name() == wanted) return item;
  }
  return {};
}

std::vector<Json> Json::items() const {
  std::vector<Json> all;
  if (kind() != Kind::array && kind() != Kind::object) return all;
  all.reserve(document_->nodes_[index_].span.count);
  for (std::uint32_t i = index_ + 1; i < document_->behind(index_); i = document_->behind(i)) {
    all.push_back(Json(document_, i));
  }
  return all;
}

double Json::number() const { return kind() == Kind::number ? document_->nodes_[index_].number : 0; }

bool Json::boolean() const { return kind() == Kind::boolean && document_->nodes_[index_].number != 0; }

std::string_view Json::text() const {
  if (kind() != Kind::string) return {};
  const auto [offset, length] = document_->nodes_[index_].span;
  return std::string_view(document_->text_).substr(offset, length);
}

std::string_view Json::name() const {
  if (document_ == nullptr) return {};
  const JsonDocument::Node& node = document_->nodes_[index_];
  return std::string_view(document_->text_).substr(node.name_offset, node.name_length);
}

std::string Json::path() const {
  std::string path;
  if (document_ == nullptr) return path;
  std::uint32_t at = 0;
  while (at != index_) {
    const bool array = Json(document_, at).kind() == Kind::array;
    std::size_t position = 0;
    std::uint32_t item = at + 1;
    for (; document_->behind(item) <= index_; item = document_->behind(item)) ++position;
    if (array) {
      path += "[" + std::to_string(position) + "]";
    } else {
      if (!path.empty()) path += '.';
      path += Json(document_, item).name();
    }
    at = item;
  }
  return path;
}

}  // namespace blysk::io
