// The manual as a man page and as Markdown, and the subcommand that prints them.
#include "blysk/version.h"
#include "manual.h"
#include "subcommands.h"
#include "terminal.h"
#include "text.h"

namespace blysk::command {
namespace {

// Text that roff shows as it is.
std::string roff(std::string_view text) {
  std::string all;
  for (const char c : text) {
    if (c == '\\') {
      all += "\\e";
    } else if (c == '-') {
      all += "\\-";
    } else if ((c == '.' || c == '\'') && all.empty()) {
      all += std::string("\\&") + c;
    } else {
      all += c;
    }
  }
  return all;
}

std::string roff_heading(std::string_view text) { return ".SH " + roff(text) + "\n"; }
std::string roff_entry(std::string_view term, std::string_view text) {
  return ".TP\n\\fB" + roff(term) + "\\fR\n" + roff(text) + "\n";
}

std::string roff_option(const Option& option) {
  std::string text = sentence(option.help);
  if (const std::string values = domain(option); !values.empty()) text += " Value: " + values + ".";
  if (const std::string standing = default_text(option); !standing.empty())
    text += " Default: " + standing + ".";
  if (option.repeatable) text += " May be repeated.";
  if (!option.example.empty()) {
    text += " Example: --" + std::string(option.name) + " " + std::string(option.example) + ".";
  }
  return roff_entry(signature(option), text + " Of: " + users_text(option) + ".");
}

std::string cell(std::string_view text) {
  std::string all;
  for (const char c : text) all += c == '|' ? std::string("\\|") : std::string(1, c);
  return all;
}

std::string code(std::string_view text) { return text.empty() ? "" : "`" + cell(text) + "`"; }

std::string markdown_options() {
  std::string text;
  for (int group = 0; group < kGroups; ++group) {
    text += "\n### " + std::string(group_title(static_cast<Group>(group))) +
            "\n\n| option | meaning | values | default | example | of |\n|---|---|---|---|---|---|\n";
    for (const Option& option : options()) {
      if (option.group != static_cast<Group>(group)) continue;
      const std::string standing =
          option.initial.empty() ? std::string(option.without) : "`" + option.initial + "`";
      const std::string example =
          option.example.empty() ? "" : "--" + std::string(option.name) + " " + std::string(option.example);
      text += "| " + code(signature(option)) + " | " + cell(option.help) +
              (option.repeatable ? "; repeatable" : "") + " | " + cell(domain(option)) + " | " +
              cell(standing) + " | " + code(example) + " | " + users_text(option) + " |\n";
    }
  }
  return text;
}

}  // namespace

std::string man_page() {
  std::string text = ".TH BLYSK 1 \"\" \"blysk " + std::string(version()) + "\" \"User Commands\"\n";
  text += roff_heading("NAME") + "blysk \\- " + roff(kSummary) + "\n" + roff_heading("SYNOPSIS");
  for (const Subcommand& subcommand : subcommands()) {
    text += "\\fBblysk\\fR " + roff(usage(subcommand)) + "\n.br\n";
  }
  text +=
      "\\fBblysk\\fR \\-\\-version | \\-\\-help\n" + roff_heading("DESCRIPTION") + roff(kWritingNote) + "\n";
  text += roff_heading("SUBCOMMANDS");
  for (const Subcommand& subcommand : subcommands()) {
    std::string words = sentence(subcommand.help);
    if (!subcommand.operand.empty()) {
      words += " " + std::string(subcommand.operand) + ": " + std::string(subcommand.operand_help) + ".";
    }
    text += roff_entry(subcommand.name, words);
  }
  text += roff_heading("OPTIONS");
  for (int group = 0; group < kGroups; ++group) {
    text += ".SS " + roff(group_title(static_cast<Group>(group))) + "\n";
    for (const Option& option : options()) {
      if (option.group == static_cast<Group>(group)) text += roff_option(option);
    }
  }
  text +=
      roff_heading("BUILT-IN SHAPES") + roff("Written shape:NAME or shape:NAME?key=value&key=value.") + "\n";
  for (const ShapeInfo& shape : shapes()) text += roff_entry(shape.name, sentence(shape_text(shape)));
  text += roff_heading("EXIT STATUS");
  for (const ExitStatus& row : exit_statuses())
    text += roff_entry(std::to_string(row.status), sentence(row.help));
  text += roff_heading("ENVIRONMENT") + roff(kColourNote) + "\n" + roff_heading("EXAMPLES");
  for (const Subcommand& subcommand : subcommands()) {
    for (const Example& example : subcommand.examples) {
      text += roff_entry("blysk " + std::string(example.line), sentence(example.help));
    }
  }
  return text;
}

std::string markdown_page() {
  std::string text = "# The command blysk\n\nblysk " + std::string(kSummary) +
                     ".\nThis page is what `blysk man --markdown` prints.\n\n" + std::string(kWritingNote) +
                     "\n\n## Subcommands\n";
  for (const Subcommand& subcommand : subcommands()) {
    text += "\n### blysk " + usage(subcommand) + "\n\n" + sentence(subcommand.help) + "\n";
    if (!subcommand.operand.empty()) {
      text += "\n" + code(subcommand.operand) + ": " + std::string(subcommand.operand_help) + ".\n";
    }
    text += "\n```sh\n";
    for (const Example& example : subcommand.examples) {
      text += "blysk " + std::string(example.line) + "  # " + std::string(example.help) + "\n";
    }
    text += "```\n";
  }
  text += "\n## Options\n" + markdown_options() +
          "\n## Built-in shapes\n\nWritten `shape:NAME` or `shape:NAME?key=value&key=value`.\n\n"
          "| shape | what it is |\n|---|---|\n";
  for (const ShapeInfo& shape : shapes()) {
    text += "| " + code(shape.name) + " | " + cell(shape_text(shape)) + " |\n";
  }
  text += "\n## Exit status\n\n| status | meaning |\n|---|---|\n";
  for (const ExitStatus& row : exit_statuses()) {
    text += "| " + std::to_string(row.status) + " | " + cell(row.help) + " |\n";
  }
  return text + "\nEnvironment: " + std::string(kColourNote) + "\n";
}

Result<int> run_man(const Arguments& arguments) {
  if (const Status status = print(arguments.has("markdown") ? markdown_page() : man_page()); !status) {
    return status.error();
  }
  return 0;
}

}  // namespace blysk::command
