// io/json.h - a JSON text as a flat table of values that know where they stand.
//
// nlohmann-json reads the tokens; the table is ours because it takes 16 bytes a value, bounds the nesting,
// never throws where a value has another type than hoped for, and can name the path of any value.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "blysk/result.h"

namespace blysk::io {

class JsonDocument;

/// One value of a document that outlives it, or none (what was looked for is not there).
class Json {
 public:
  enum class Kind : std::uint8_t { none, null, boolean, number, string, array, object };

  Json() = default;
  [[nodiscard]] Kind kind() const;
  explicit operator bool() const { return document_ != nullptr; }

  /// The first member of that name; none where there is none or this is no object. Takes time in the number
  /// of members.
  [[nodiscard]] Json operator[](std::string_view name) const;
  /// Elements of an array, members of an object; nothing of anything else.
  [[nodiscard]] std::vector<Json> items() const;

  [[nodiscard]] double number() const;          ///< 0 unless a number
  [[nodiscard]] bool boolean() const;           ///< false unless true
  [[nodiscard]] std::string_view text() const;  ///< empty unless a string
  [[nodiscard]] std::string_view name() const;  ///< as a member of an object
  [[nodiscard]] std::string path() const;       ///< "meshes[2].primitives[0].mode"; empty for the root

 private:
  friend class JsonDocument;
  Json(const JsonDocument* document, std::uint32_t index) : document_(document), index_(index) {}

  const JsonDocument* document_ = nullptr;
  std::uint32_t index_ = 0;
};

/// Deeper nesting is refused; no model needs more.
inline constexpr std::size_t kMaxJsonDepth = 64;

class JsonDocument {
 public:
  /// Texts up to 4 GiB. The error carries the line; the source is the caller's to fill in.
  [[nodiscard]] static Result<JsonDocument> parse(std::string_view text);
  [[nodiscard]] Json root() const { return nodes_.empty() ? Json() : Json(this, 0); }

 private:
  friend class Json;
  friend class JsonBuilder;

  // A container is followed by its items, each with its own items behind it.
  struct Span {
    std::uint32_t first,
        count;  // string: offset and length in text_; container: index behind its last item, items
  };
  struct Node {
    union {
      double number = 0;
      Span span;
    };
    std::uint32_t name_offset = 0;
    std::uint32_t name_length : 29 = 0;
    std::uint32_t kind : 3 = 0;
  };
  static_assert(sizeof(Node) == 16);

  [[nodiscard]] std::uint32_t behind(std::uint32_t index) const;

  std::vector<Node> nodes_;
  std::string text_;  // names and strings, one behind the other
};

}  // namespace blysk::io
