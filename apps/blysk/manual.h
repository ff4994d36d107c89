// manual.h - what the table of options says to people and shells.
#pragma once

#include <string>
#include <string_view>

#include "blysk/shapes.h"
#include "options.h"

namespace blysk::command {

inline constexpr std::string_view kSummary =
    "turns 3D models into pictures on the CPU, the same bytes on every machine";
inline constexpr std::string_view kColourNote =
    "NO_COLOR: set to anything, messages have no colour; they have none "
    "either where standard error is not a terminal.";
inline constexpr std::string_view kWritingNote =
    "Options may be written --name value or --name=value, before or after the models; the last value holds. "
    "-- ends "
    "the options. Words go to standard error, data to standard output. Pictures appear whole or not at all.";

[[nodiscard]] std::string general_help();                      ///< of `blysk --help`
[[nodiscard]] std::string help(const Subcommand& subcommand);  ///< of `blysk SUBCOMMAND --help`
[[nodiscard]] std::string man_page();                          ///< roff
[[nodiscard]] std::string markdown_page();                     ///< docs/command.md
[[nodiscard]] std::string bash_completion();

/// "render MODEL... [OPTIONS]"
[[nodiscard]] std::string usage(const Subcommand& subcommand);
/// "Turn one or several models into a picture."
[[nodiscard]] std::string sentence(std::string_view help);
/// "shape:sphere?detail=50: a ball; detail 1 to 400 (32): ..."
[[nodiscard]] std::string shape_text(const ShapeInfo& shape);
/// "render, info"
[[nodiscard]] std::string users_text(const Option& option);

}  // namespace blysk::command
