// arguments.h - a command line, parsed and checked by the table of options.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "options.h"

namespace blysk::command {

/// A valid value of an option.
struct Value {
  std::string text;
  std::vector<double> numbers;  ///< of every type that has any; bytes and sizes too
};

struct Given {
  const Option* option;
  Value value;
};

/// What stands on the command line after the subcommand.
class Arguments {
 public:
  Arguments(std::vector<std::string> operands, std::vector<Given> given)
      : operands_(std::move(operands)), given_(std::move(given)) {}

  [[nodiscard]] const std::vector<std::string>& operands() const { return operands_; }
  /// Options in the order given, repeated ones each time.
  [[nodiscard]] const std::vector<Given>& given() const { return given_; }

  /// The last value given; nullptr if the option is not there.
  [[nodiscard]] const Value* find(std::string_view name) const;
  [[nodiscard]] bool has(std::string_view name) const { return find(name) != nullptr; }

  /// The value given, else the default of the table, which must have one.
  [[nodiscard]] Value value(std::string_view name) const;
  [[nodiscard]] std::string text(std::string_view name) const { return value(name).text; }
  [[nodiscard]] double number(std::string_view name) const { return value(name).numbers.at(0); }

 private:
  std::vector<std::string> operands_;
  std::vector<Given> given_;
};

/// A value's text by the option's type and domain; ErrorCode::usage with what would be right.
[[nodiscard]] Result<Value> parse_value(const Option& option, std::string_view text);

/// Parses what follows the subcommand: `--name value`, `--name=value`, `-n value`, `-nvalue`, operands, and
/// `--` after which everything is an operand. The last of several values holds.
[[nodiscard]] Result<Arguments> parse_arguments(const Subcommand& subcommand,
                                                const std::vector<std::string>& words);

/// ErrorCode::usage about an option or argument.
[[nodiscard]] Error usage_error(std::string source, std::string message);

}  // namespace blysk::command
