// The texts of --help.
#include "blysk/version.h"
#include "manual.h"
#include "text.h"

namespace blysk::command {
namespace {

constexpr int kWidth = 100;
constexpr int kColumn = 32;  // where descriptions begin

std::string entry(const std::string& left, const std::string& right) {
  std::string line = "  " + left;
  if (static_cast<int>(line.size()) + 2 > kColumn) {
    line += "\n" + std::string(kColumn, ' ');
  } else {
    line.append(kColumn - line.size(), ' ');
  }
  return line + wrap(right, kWidth - kColumn, kColumn) + "\n";
}

std::string describe(const Option& option) {
  std::vector<std::string> notes;
  if (const std::string values = domain(option); !values.empty()) notes.push_back(values);
  if (const std::string standing = default_text(option); !standing.empty()) {
    notes.push_back("default: " + standing);
  }
  if (option.repeatable) notes.emplace_back("repeatable");
  return option.help + (notes.empty() ? "" : " (" + join(notes, "; ") + ")");
}

std::string example_lines(const std::vector<Example>& examples) {
  std::string all = "\nExamples\n";
  for (const Example& example : examples) {
    all += "  blysk " + std::string(example.line) + "\n      " + std::string(example.help) + "\n";
  }
  return all;
}

}  // namespace

std::string usage(const Subcommand& subcommand) {
  const std::string operand = subcommand.operand.empty() ? "" : " " + std::string(subcommand.operand);
  return std::string(subcommand.name) + operand + " [OPTIONS]";
}

std::string sentence(std::string_view help) {
  std::string text(help);
  if (text.front() >= 'a' && text.front() <= 'z') text.front() = static_cast<char>(text.front() - 'a' + 'A');
  return text + ".";
}

std::string shape_text(const ShapeInfo& shape) {
  std::string text(shape.help);
  std::string_view separator = "; ";
  for (const ShapeParameter& parameter : shape.parameters) {
    text += std::string(separator) + std::string(parameter.name) + " " + number_text(parameter.minimum) +
            " to " + number_text(parameter.maximum) + " (default: " + number_text(parameter.initial) +
            "): " + std::string(parameter.help);
  }
  return text;
}

std::string users_text(const Option& option) {
  std::vector<std::string> names;
  for (const Subcommand& subcommand : subcommands()) {
    if ((option.users & subcommand.user) != 0) names.emplace_back(subcommand.name);
  }
  return names.size() == subcommands().size() ? "all" : join(names, ", ");
}

std::string general_help() {
  std::string text = "blysk " + std::string(version()) + ": " + std::string(kSummary) +
                     "\n\nUsage: blysk SUBCOMMAND [OPTIONS]\n\nSubcommands\n";
  for (const Subcommand& subcommand : subcommands()) {
    text += entry(std::string(subcommand.name), std::string(subcommand.help));
  }
  text += "\nOptions\n" + entry("-h, --help", "print this, or what a subcommand does") +
          entry("--version", "print the version");
  std::vector<Example> examples;
  for (const Subcommand& subcommand : subcommands()) examples.push_back(subcommand.examples.front());
  text += example_lines(examples) + "\nExit status\n";
  for (const ExitStatus& row : exit_statuses())
    text += entry(std::to_string(row.status), std::string(row.help));
  return text + "\nblysk SUBCOMMAND --help explains each; blysk man prints the whole manual.\n";
}

std::string help(const Subcommand& subcommand) {
  std::string text = "Usage: blysk " + usage(subcommand) + "\n\n" + sentence(subcommand.help) + "\n";
  if (!subcommand.operand.empty()) {
    std::string words(subcommand.operand_help);
    if (!subcommand.operand_choices.empty())
      words += " (one of " + join(subcommand.operand_choices, ", ") + ")";
    text += "\n" + entry(std::string(subcommand.operand), words);
  }
  const Option* before = nullptr;
  for (const Option* option : options_of(subcommand)) {
    if (before == nullptr || before->group != option->group) {
      text += "\n" + std::string(group_title(option->group)) + "\n";
    }
    text += entry(signature(*option), describe(*option));
    before = option;
  }
  if ((subcommand.user & (kDraw | kInfo)) != 0) {
    text += "\nBuilt-in shapes, as shape:NAME or shape:NAME?key=value&key=value\n";
    for (const ShapeInfo& shape : shapes()) text += entry(std::string(shape.name), shape_text(shape));
  }
  return text + example_lines(subcommand.examples);
}

}  // namespace blysk::command
