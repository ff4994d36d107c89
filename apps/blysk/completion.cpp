// The script for bash, and the subcommand that prints it.
#include "manual.h"
#include "subcommands.h"
#include "terminal.h"
#include "text.h"

namespace blysk::command {
namespace {

std::string option_words(const Subcommand& subcommand) {
  std::vector<std::string> words;
  for (const Option* option : options_of(subcommand)) {
    if (option->letter != 0) words.push_back({'-', option->letter});
    words.push_back("--" + std::string(option->name));
  }
  return join(words, " ");
}

// One branch of a case for every option with words to choose from.
std::string value_branches() {
  std::string text;
  for (const Option& option : options()) {
    std::vector<std::string> words = option.choices;
    if (words.empty() && option.type == Type::background) words = {"transparent"};
    if (words.empty()) continue;
    text += "    --" + std::string(option.name) + ") _blysk_words '" + join(words, " ") + "'; return ;;\n";
  }
  return text;
}

}  // namespace

std::string bash_completion() {
  std::vector<std::string> names, shape_names;
  std::string options_of_each;
  for (const Subcommand& subcommand : subcommands()) {
    names.emplace_back(subcommand.name);
    options_of_each +=
        "    " + names.back() + ") options='" + option_words(subcommand) + "'" +
        (subcommand.operand_choices.empty() ? ""
                                            : "; operands='" + join(subcommand.operand_choices, " ") + "'") +
        " ;;\n";
  }
  for (const ShapeInfo& shape : shapes()) shape_names.emplace_back(shape.name);

  return R"(# Completion of blysk for bash, printed by: blysk completion bash
_blysk_words() { COMPREPLY=($(compgen -W "$1" -- "$current")); }

_blysk() {
  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD-1]} options='' operands=''
  COMPREPLY=()
  # Bash splits words at = and : too.
  if [[ $current == '=' || $current == ':' ]]; then
    [[ $current == ':' && $previous == shape ]] && previous=shape:
    current=''
  elif [[ $previous == '=' || $previous == ':' ]]; then
    [[ $previous == ':' ]] && previous=${COMP_WORDS[COMP_CWORD-2]}: || previous=${COMP_WORDS[COMP_CWORD-2]}
  fi
  if [[ $previous == shape: ]]; then
    _blysk_words ')" +
         join(shape_names, " ") + R"('
    return
  fi
  if ((COMP_CWORD == 1)); then
    _blysk_words ')" +
         join(names, " ") + R"( --help --version'
    return
  fi
  case $previous in
)" + value_branches() +
         R"(  esac
  case ${COMP_WORDS[1]} in
)" + options_of_each +
         R"(  esac
  if [[ $current == -* ]]; then
    _blysk_words "$options"
  elif [[ -n $operands ]]; then
    _blysk_words "$operands"
  fi
}

# Where nothing is offered, file names are.
complete -o bashdefault -o default -F _blysk blysk
)";
}

Result<int> run_completion(const Arguments&) {
  if (const Status status = print(bash_completion()); !status) return status.error();
  return 0;
}

}  // namespace blysk::command
