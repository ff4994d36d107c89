// io/gltf_context.h - what the parts of the glTF reader share: checked access to the document, the first
// error, the problems, and the allowance of memory.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/json.h"
#include "io/reader.h"

namespace blysk::io::gltf {

/// Whole numbers up to here are exact in JSON.
inline constexpr std::uint64_t kMaxWhole = std::uint64_t{1} << 53;
inline constexpr int kNone = -1;

/// "text", with control characters replaced and cut to a length that suits a message.
std::string in_quotes(std::string_view text);

/// The first failure stays; after it every getter goes on returning values that are in their ranges, so that
/// callers need only look at failed() before they allocate or follow a reference.
class Context {
 public:
  explicit Context(const Source& source) : source_(source), file_bytes_(source.bytes.size()) {}

  [[nodiscard]] const Source& source() const { return source_; }
  [[nodiscard]] bool failed() const { return error_.has_value(); }
  [[nodiscard]] const Error& error() const { return *error_; }

  /// "PATH: what".
  void fail(Json where, const std::string& what, ErrorCode code = ErrorCode::input);
  void fail(Error error);
  /// Notes what was left out or mended. Only the first few are kept one by one.
  void problem(Json where, const std::string& what);
  void problem(const std::string& what);
  [[nodiscard]] std::vector<std::string> take_problems();

  // Members of an object. Absent ones give the fallback, those of another type fail.
  [[nodiscard]] std::uint64_t whole(Json object, std::string_view name, std::uint64_t lowest,
                                    std::uint64_t highest, std::uint64_t fallback);
  [[nodiscard]] double number(Json object, std::string_view name, double fallback);
  [[nodiscard]] bool flag(Json object, std::string_view name, bool fallback);
  [[nodiscard]] std::string_view text(Json object, std::string_view name);
  [[nodiscard]] Json object(Json object, std::string_view name);
  [[nodiscard]] std::vector<Json> list(Json object, std::string_view name);
  /// Exactly as many numbers as `values`, which keep their content where the member is absent.
  bool numbers(Json object, std::string_view name, std::span<double> values);
  /// An index below `count` of things called `noun`; kNone where absent.
  [[nodiscard]] int index(Json object, std::string_view name, std::size_t count, std::string_view noun);
  [[nodiscard]] int index(Json value, std::size_t count, std::string_view noun);
  /// A member that must be there: fails if not.
  void require(Json object, std::string_view name);

  /// Asks for memory that the file's content unpacks to, before it is allocated.
  [[nodiscard]] bool allow(std::uint64_t bytes, Json where);
  /// A further file belongs to the model.
  void add_file_bytes(std::uint64_t bytes) { file_bytes_ += bytes; }

 private:
  [[nodiscard]] Json member(Json object, std::string_view name, Json::Kind kind);

  const Source& source_;
  std::optional<Error> error_;
  std::vector<std::string> problems_;
  std::uint64_t more_problems_ = 0;
  std::uint64_t file_bytes_;
  std::uint64_t unpacked_bytes_ = 0;
};

/// The object in its "extensions" member.
[[nodiscard]] Json extension(Context& context, Json object, std::string_view name);

}  // namespace blysk::io::gltf
