// blysk/result.h - a value or the reason why there is none.
//
// Whatever touches files or user input returns Result<T>; the API throws nothing.
#pragma once

#include <optional>
#include <string>
#include <utility>

namespace blysk {

/// Kinds of failure, as numbers the command uses for its exit status.
enum class ErrorCode {
  usage = 2,     ///< an argument or option is wrong
  input = 3,     ///< an input cannot be read or is not valid
  output = 4,    ///< the output cannot be written
  limit = 5,     ///< a limit of the caller was reached
  internal = 70  ///< a bug of ours
};

/// One failure: what happened, where, and what to do about it.
struct Error {
  ErrorCode code = ErrorCode::internal;
  std::string message;  ///< what happened and what to do, one sentence, no newline
  std::string source;   ///< file or option it happened in; empty if none
  long long line = 0;   ///< line of a text file, counted from 1; 0 if not known

  /// "source:line: message", leaving out the parts that are not known.
  [[nodiscard]] std::string text() const;
};

/// A value, or an Error. Test it like a pointer, then read it like one.
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : value_(std::move(value)) {}      // NOLINT(google-explicit-constructor)
  Result(Error error) : error_(std::move(error)) {}  // NOLINT(google-explicit-constructor)

  explicit operator bool() const { return value_.has_value(); }
  T& operator*() { return *value_; }
  const T& operator*() const { return *value_; }
  T* operator->() { return &*value_; }
  const T* operator->() const { return &*value_; }

  /// The error; meaningful only when there is no value.
  [[nodiscard]] const Error& error() const { return error_; }

 private:
  std::optional<T> value_;
  Error error_;
};

/// Success without a value.
struct Done {};
using Status = Result<Done>;

}  // namespace blysk
