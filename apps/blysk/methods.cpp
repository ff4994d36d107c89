// blysk methods: the registry.
#include "blysk/methods.h"

#include "blysk/version.h"
#include "json.h"
#include "subcommands.h"
#include "terminal.h"
#include "text.h"

namespace blysk::command {
namespace {

// The default of each kind stands first among its kind.
bool is_default(const Method& method) {
  for (const Method& row : methods()) {
    if (row.kind == method.kind) return row.name == method.name;
  }
  return false;
}

Status print_table() {
  std::vector<std::vector<std::string>> rows = {{"KIND", "NAME", "TITLE", "SOURCE"}};
  for (const Method& method : methods()) {
    rows.push_back({std::string(kind_name(method.kind)),
                    std::string(method.name) + (is_default(method) ? " (default)" : ""),
                    std::string(method.title), std::string(method.source)});
  }
  return print(table(rows));
}

Status print_document() {
  Json rows = Json::array();
  for (const Method& method : methods()) {
    rows.push_back({{"kind", kind_name(method.kind)},
                    {"name", method.name},
                    {"default", is_default(method)},
                    {"title", method.title},
                    {"source", method.source},
                    {"reference", method.reference},
                    {"claim", method.claim},
                    {"limits", method.limits}});
  }
  return print_json({{"version", version()}, {"methods", std::move(rows)}});
}

// docs/methods.md.
Status print_markdown() {
  std::string text =
      "# Methods\n\nEvery method that can be selected, the default of each kind first. This page is what\n"
      "`blysk methods --markdown` prints.\n";
  std::string_view kind;
  for (const Method& method : methods()) {
    if (kind_name(method.kind) != kind) {
      kind = kind_name(method.kind);
      text += "\n## --" + std::string(kind) +
              "\n\n| name | what it does | source | measured against | claim of the source | valid |\n"
              "|---|---|---|---|---|---|\n";
    }
    text += "| `" + std::string(method.name) + "` | " + std::string(method.title) + " | " +
            std::string(method.source) + " | " + std::string(method.reference) + " | " +
            std::string(method.claim) + " | " + std::string(method.limits) + " |\n";
  }
  return print(text);
}

}  // namespace

Result<int> run_methods(const Arguments& arguments) {
  const Status status = arguments.has("json")       ? print_document()
                        : arguments.has("markdown") ? print_markdown()
                                                    : print_table();
  if (!status) return status.error();
  return 0;
}

}  // namespace blysk::command
