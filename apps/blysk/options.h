// options.h - the one table of subcommands and options.
//
// Parser, help, man page, completion and docs/command.md are all made from it; nothing about an option is
// written down twice. A new option is one row here and one use in its subcommand.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "blysk/methods.h"
#include "blysk/result.h"

namespace blysk::command {

class Arguments;

/// What an option's value looks like.
enum class Type {
  flag,             ///< no value
  text,             ///< anything
  path,             ///< a file name, or "-"
  choice,           ///< one of `choices`
  choices,          ///< several of them, comma-separated
  method,           ///< NAME[:SETTING=VALUE,...] of `kind`
  methods,          ///< several of them, comma-separated, or "all"
  integer,          ///< a whole number from `low` to `high`
  number,           ///< a number from `low` to `high`
  optional_number,  ///< a number, or nothing
  bytes,            ///< a whole number with an optional K, M, G or T (powers of 1024)
  size,             ///< WxH, whole numbers from `low` to `high`
  point,            ///< x,y,z
  direction,        ///< x,y,z, not all zero
  light,            ///< x,y,z[,r,g,b] with a direction
  point_light,      ///< likewise with a position
  color,            ///< r,g,b, each 0..1
  background        ///< r,g,b[,a] each 0..1, #rrggbb[aa] or "transparent"
};

inline constexpr double kMaxLight = 1e6;  ///< largest component of a light's colour

/// Headings that options stand under, in the order of the help.
enum class Group { output, camera, light, material, method, picture, work, report };
inline constexpr int kGroups = 8;
[[nodiscard]] std::string_view group_title(Group group);

/// Subcommands that know an option: a sum of these.
enum Users : unsigned {
  kRender = 1,
  kInfo = 2,
  kMethods = 4,
  kVerify = 8,
  kMan = 16,
  kCompletion = 32,
  kCompare = 64,
  kReplicate = 128,
  kDraw = kRender | kCompare,
};

struct Option {
  std::string_view name;  ///< without its dashes
  char letter = 0;        ///< short form; 0: none
  Type type = Type::flag;
  std::string_view value = {};  ///< how the help calls the value
  Group group = Group::output;
  unsigned users = kRender;
  bool repeatable = false;
  double low = 0, high = 0;  ///< domain of numbers, both included
  std::vector<std::string> choices = {};
  MethodKind kind = MethodKind::shading;  ///< of methods
  std::string initial = {};               ///< value that holds without the option; empty: see `without`
  std::string_view without = {};          ///< what happens without the option, in words
  std::string example = {};               ///< a valid value
  std::string help = {};                  ///< what it does, lower case, no full stop at the end
};

/// A command line worth showing, without the leading "blysk ".
struct Example {
  std::string_view line, help;
};

struct Subcommand {
  std::string_view name;
  Users user;
  Result<int> (*run)(const Arguments&);  ///< gives the exit status
  std::string_view help = {};            ///< what it does, lower case, no full stop at the end
  std::string_view operand = {};         ///< how the help calls what is not an option; empty: it takes none
  std::string_view operand_help = {};
  int least = 0, most = 0;  ///< how many operands
  std::vector<std::string> operand_choices = {};
  std::vector<Example> examples = {};
};

struct ExitStatus {
  int status;
  std::string_view help = {};
};

[[nodiscard]] const std::vector<Subcommand>& subcommands();
[[nodiscard]] const std::vector<Option>& options();
[[nodiscard]] const std::vector<ExitStatus>& exit_statuses();

[[nodiscard]] const Option& option(std::string_view name);  ///< must exist
[[nodiscard]] std::vector<const Option*> options_of(const Subcommand& subcommand);

/// "WxH, each 1 to 16384", "one of flat, gouraud": what a value may be; empty where anything goes.
[[nodiscard]] std::string domain(const Option& option);
/// What holds without the option, in words; empty where nothing does.
[[nodiscard]] std::string default_text(const Option& option);
/// "-o, --output OUT"
[[nodiscard]] std::string signature(const Option& option);

}  // namespace blysk::command
