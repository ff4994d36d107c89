// Why not CLI11: the table already holds all that such a library would have to be told, and it knows neither
// values that are optional only before something else, nor suggestions, nor these one-line messages.
#include "arguments.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "text.h"

namespace blysk::command {
namespace {

using Numbers = std::vector<double>;

bool in_range(double value, double low, double high) { return value >= low && value <= high; }

bool all_in_range(const Numbers& numbers, double low, double high) {
  return std::ranges::all_of(numbers, [&](double n) { return in_range(n, low, high); });
}

std::optional<Numbers> parse_list(std::string_view text, char separator) {
  Numbers numbers;
  for (const std::string& part : split(text, separator)) {
    const auto number = parse_number(part);
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers;
}

std::optional<Numbers> parse_whole(const Option& option, std::string_view text) {
  const auto number = parse_number(text);
  if (!number || *number != std::floor(*number) || !in_range(*number, option.low, option.high)) {
    return std::nullopt;
  }
  return Numbers{*number};
}

std::optional<Numbers> parse_bytes(const Option& option, std::string_view text) {
  constexpr std::string_view kUnits = "KMGT";
  double unit = 1;
  if (!text.empty() && kUnits.find(text.back()) != std::string_view::npos) {
    for (std::size_t i = 0; i <= kUnits.find(text.back()); ++i) unit *= 1024;
    text.remove_suffix(1);
  }
  const auto number = parse_number(text);
  if (!number || *number != std::floor(*number) || !in_range(*number * unit, option.low, option.high)) {
    return std::nullopt;
  }
  return Numbers{*number * unit};
}

std::optional<Numbers> parse_size(const Option& option, std::string_view text) {
  const auto sides = parse_list(text, 'x');
  if (!sides || sides->size() != 2 || !all_in_range(*sides, option.low, option.high)) return std::nullopt;
  if (std::ranges::any_of(*sides, [](double side) { return side != std::floor(side); })) return std::nullopt;
  return sides;
}

bool all_zero(const Numbers& numbers) { return numbers[0] == 0 && numbers[1] == 0 && numbers[2] == 0; }

std::optional<Numbers> parse_vector(const Option& option, std::string_view text) {
  const auto numbers = parse_list(text, ',');
  if (!numbers || numbers->size() != 3 || !all_in_range(*numbers, option.low, option.high))
    return std::nullopt;
  if (option.type == Type::direction && all_zero(*numbers)) return std::nullopt;
  return numbers;
}

std::optional<Numbers> parse_light(const Option& option, std::string_view text) {
  auto numbers = parse_list(text, ',');
  if (!numbers || (numbers->size() != 3 && numbers->size() != 6)) return std::nullopt;
  numbers->resize(6, 1.0);
  if (!all_in_range({numbers->begin(), numbers->begin() + 3}, option.low, option.high)) return std::nullopt;
  if (!all_in_range({numbers->begin() + 3, numbers->end()}, 0, kMaxLight)) return std::nullopt;
  if (option.type == Type::light && all_zero(*numbers)) return std::nullopt;
  return numbers;
}

std::optional<Numbers> parse_hex_color(std::string_view digits) {
  if (digits.size() != 6 && digits.size() != 8) return std::nullopt;
  const auto digit = [](char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
  };
  Numbers numbers;
  for (std::size_t i = 0; i < digits.size(); i += 2) {
    const int high = digit(digits[i]), low = digit(digits[i + 1]);
    if (high < 0 || low < 0) return std::nullopt;
    numbers.push_back((high * 16 + low) / 255.0);
  }
  numbers.resize(4, 1.0);
  return numbers;
}

std::optional<Numbers> parse_background(std::string_view text) {
  if (text == "transparent") return Numbers{0, 0, 0, 0};
  if (text.starts_with('#')) return parse_hex_color(text.substr(1));
  auto numbers = parse_list(text, ',');
  if (!numbers || (numbers->size() != 3 && numbers->size() != 4)) return std::nullopt;
  numbers->resize(4, 1.0);
  if (!all_in_range(*numbers, 0, 1)) return std::nullopt;
  return numbers;
}

std::optional<Numbers> parse_numbers(const Option& option, std::string_view text) {
  switch (option.type) {
    case Type::flag:
    case Type::text:
    case Type::path:
    case Type::choice:
    case Type::choices:
    case Type::method:
    case Type::methods:
      return Numbers{};
    case Type::optional_number:
      if (text.empty()) return Numbers{};
      [[fallthrough]];
    case Type::number: {
      const auto number = parse_number(text);
      if (!number || !in_range(*number, option.low, option.high)) return std::nullopt;
      return Numbers{*number};
    }
    case Type::integer:
      return parse_whole(option, text);
    case Type::bytes:
      return parse_bytes(option, text);
    case Type::size:
      return parse_size(option, text);
    case Type::point:
    case Type::direction:
    case Type::color:
      return parse_vector(option, text);
    case Type::light:
    case Type::point_light:
      return parse_light(option, text);
    case Type::background:
      return parse_background(text);
  }
  return std::nullopt;
}

// Words of a command line, taken one after another.
class Parser {
 public:
  Parser(const Subcommand& subcommand, const std::vector<std::string>& words)
      : subcommand_(subcommand), words_(words), known_(options_of(subcommand)) {}

  Result<Arguments> parse() {
    bool only_operands = false;
    while (at_ < words_.size()) {
      const std::string& word = words_[at_++];
      if (only_operands || word.size() < 2 || word[0] != '-') {
        operands_.push_back(word);
      } else if (word == "--") {
        only_operands = true;
      } else if (const Status status = word[1] == '-' ? long_option(word) : short_option(word); !status) {
        return status.error();
      }
    }
    // Help is wanted whatever else is missing.
    const bool help = std::ranges::any_of(given_, [](const Given& g) { return g.option->name == "help"; });
    if (!help) {
      if (const Status status = check_operands(); !status) return status.error();
    }
    return Arguments(std::move(operands_), std::move(given_));
  }

 private:
  Status long_option(std::string_view word) {
    const std::size_t equals = word.find('=');
    const std::string_view name = word.substr(2, equals - 2);
    for (const Option* option : known_) {
      if (option->name != name) continue;
      if (equals == std::string_view::npos) return take(*option, std::nullopt);
      return take(*option, word.substr(equals + 1));
    }
    return unknown(word.substr(0, equals), name);
  }

  Status short_option(std::string_view word) {
    for (const Option* option : known_) {
      if (option->letter != word[1]) continue;
      if (word.size() == 2) return take(*option, std::nullopt);
      if (option->type != Type::flag) return take(*option, word.substr(word[2] == '=' ? 3 : 2));
    }
    return unknown(word, word.substr(1));
  }

  Error unknown(std::string_view word, std::string_view name) const {
    std::vector<std::string> names;
    for (const Option* option : known_) names.emplace_back(option->name);
    const std::string meant = suggestion(name, names);
    const std::string of = " of blysk " + std::string(subcommand_.name);
    if (!meant.empty())
      return usage_error(std::string(word), "no such option" + of + ", did you mean --" + meant + "?");
    for (const Subcommand& other : subcommands()) {
      for (const Option* option : options_of(other)) {
        if (option->name != name) continue;
        return usage_error(std::string(word),
                           "no such option" + of + ", it belongs to blysk " + std::string(other.name));
      }
    }
    return usage_error(std::string(word),
                       "no such option; blysk " + std::string(subcommand_.name) + " --help lists them");
  }

  Status take(const Option& option, std::optional<std::string_view> attached) {
    const std::string name = "--" + std::string(option.name);
    if (option.type == Type::flag) {
      if (attached) return usage_error(name, "takes no value");
      given_.push_back({&option, {}});
      return Done{};
    }
    std::string text;
    if (attached) {
      text = *attached;
      if (text.empty()) return usage_error(name, "the value after = is missing");
    } else if (option.type == Type::optional_number) {
      if (at_ < words_.size() && parse_number(words_[at_])) text = words_[at_++];
    } else {
      if (at_ == words_.size())
        return usage_error(name, "the value " + std::string(option.value) + " is missing");
      text = words_[at_++];
    }
    Result<Value> value = parse_value(option, text);
    if (!value) return value.error();
    given_.push_back({&option, std::move(*value)});
    return Done{};
  }

  Status check_operands() const {
    const std::string name = "blysk " + std::string(subcommand_.name);
    const int count = static_cast<int>(operands_.size());
    if (count < subcommand_.least) {
      return usage_error(name, "the argument " + std::string(subcommand_.operand) +
                                   " is missing, for example: blysk " +
                                   std::string(subcommand_.examples.front().line));
    }
    if (count > subcommand_.most) {
      const std::string takes = subcommand_.most == 0
                                    ? "takes no argument"
                                    : "takes no more than " + counted(subcommand_.most, "argument");
      return usage_error(
          name, takes + ", '" + operands_[static_cast<std::size_t>(subcommand_.most)] + "' is one too many");
    }
    const auto& choices = subcommand_.operand_choices;
    for (const std::string& operand : operands_) {
      if (choices.empty() || std::ranges::find(choices, operand) != choices.end()) continue;
      return usage_error(name + " " + operand, "unknown" + did_you_mean(operand, choices) + " (one of " +
                                                   join(choices, ", ") + ")");
    }
    return Done{};
  }

  const Subcommand& subcommand_;
  const std::vector<std::string>& words_;
  const std::vector<const Option*> known_;
  std::size_t at_ = 0;
  std::vector<std::string> operands_;
  std::vector<Given> given_;
};

}  // namespace

Error usage_error(std::string source, std::string message) {
  return {.code = ErrorCode::usage, .message = std::move(message), .source = std::move(source)};
}

Result<Value> parse_value(const Option& option, std::string_view text) {
  const std::string source = "--" + std::string(option.name) + " " + std::string(text);
  if (option.type == Type::choice || option.type == Type::choices) {
    const auto parts = option.type == Type::choice ? std::vector{std::string(text)} : split(text, ',');
    for (const std::string& part : parts) {
      if (std::ranges::find(option.choices, part) != option.choices.end()) continue;
      return usage_error(source,
                         "unknown" + did_you_mean(part, option.choices) + " (" + domain(option) + ")");
    }
  }
  if (option.type == Type::method || option.type == Type::methods) {
    const auto parts = option.type == Type::method ? std::vector{std::string(text)} : split_methods(text);
    for (const std::string& part : parts) {
      if (option.type == Type::methods && part == "all") continue;
      const Result<MethodChoice> choice = choose_method(option.kind, part);
      if (!choice) return usage_error(source, choice.error().message);
    }
  }
  if (option.type == Type::path && text.empty()) return usage_error(source, "the file name is empty");
  auto numbers = parse_numbers(option, text);
  if (!numbers) {
    return usage_error(source, "expected " + domain(option) + ", for example --" + std::string(option.name) +
                                   " " + std::string(option.example));
  }
  return Value{.text = std::string(text), .numbers = std::move(*numbers)};
}

Result<Arguments> parse_arguments(const Subcommand& subcommand, const std::vector<std::string>& words) {
  return Parser(subcommand, words).parse();
}

const Value* Arguments::find(std::string_view name) const {
  for (auto given = given_.rbegin(); given != given_.rend(); ++given) {
    if (given->option->name == name) return &given->value;
  }
  return nullptr;
}

Value Arguments::value(std::string_view name) const {
  if (const Value* given = find(name)) return *given;
  const Option& row = option(name);
  return *parse_value(row, row.initial);
}

}  // namespace blysk::command
