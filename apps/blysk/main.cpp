// The command blysk: finds the subcommand, runs it, and turns what happened into an exit status.
#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "arguments.h"
#include "blysk/version.h"
#include "manual.h"
#include "options.h"
#include "terminal.h"
#include "text.h"

namespace blysk::command {
namespace {

Error unknown_subcommand(const std::string& word) {
  std::vector<std::string> names;
  for (const Subcommand& subcommand : subcommands()) names.emplace_back(subcommand.name);
  const std::string source = "'" + word + "'";
  std::error_code ignored;
  if (word.starts_with("shape:") || std::filesystem::exists(word, ignored)) {
    return usage_error(source,
                       "no such subcommand; to see a model: blysk render " + word + " -o picture.png");
  }
  if (word.starts_with('-')) {
    return usage_error(source, "options stand after the subcommand (one of " + join(names, ", ") +
                                   "), or are --help or --version");
  }
  const bool dashes_forgotten = word == "help" || word == "version";
  const std::string meant = dashes_forgotten ? ", did you mean '--" + word + "'?" : did_you_mean(word, names);
  return usage_error(source, "no such subcommand" + meant + " (one of " + join(names, ", ") + ")");
}

Result<int> run(const std::vector<std::string>& words) {
  if (words.empty()) return usage_error("", "what shall be done? try: blysk --help");
  const std::string& first = words.front();
  if (first == "--version") {
    if (const Status status = print("blysk " + std::string(version()) + "\n"); !status) return status.error();
    return 0;
  }
  if (first == "--help" || first == "-h") {
    if (const Status status = print(general_help()); !status) return status.error();
    return 0;
  }
  const auto found = std::ranges::find(subcommands(), first, &Subcommand::name);
  if (found == subcommands().end()) return unknown_subcommand(first);

  const Result<Arguments> arguments = parse_arguments(*found, {words.begin() + 1, words.end()});
  if (!arguments) return arguments.error();
  if (arguments->has("help")) {
    if (const Status status = print(help(*found)); !status) return status.error();
    return 0;
  }
  return found->run(*arguments);
}

}  // namespace
}  // namespace blysk::command

int main(int argc, char** argv) {
  using namespace blysk::command;
  prepare_process();
  try {
    const blysk::Result<int> status = run({argv + std::min(argc, 1), argv + argc});
    return status ? *status : report(status.error());
  } catch (...) {
    return report_exception();
  }
}
