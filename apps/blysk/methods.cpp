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

Json settings_json(const Method& method) {
  Json rows = Json::array();
  for (const MethodSetting& setting : method.settings) {
    Json row = {{"name", setting.name}, {"help", setting.help}};
    if (setting.choices.empty()) {
      row.update({{"lowest", setting.lowest}, {"highest", setting.highest}, {"default", setting.initial}});
    } else {
      row["choices"] = Json(std::vector<std::string>(setting.choices.begin(), setting.choices.end()));
      row["default"] = setting.choices[static_cast<std::size_t>(setting.initial)];
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

// "fit=paper|minimax|cubic", the default first.
std::string values_of(const MethodSetting& setting) {
  const std::string name(setting.name);
  if (setting.choices.empty()) {
    return name + "=" + std::to_string(setting.lowest) + ".." + std::to_string(setting.highest) +
           ", default " + std::to_string(setting.initial);
  }
  std::string text = name + "=" + std::string(setting.choices[static_cast<std::size_t>(setting.initial)]);
  for (const std::string_view choice : setting.choices) {
    if (choice != setting.choices[static_cast<std::size_t>(setting.initial)])
      text += "|" + std::string(choice);
  }
  return text;
}

std::string settings_markdown(MethodKind kind) {
  std::string text;
  for (const Method& method : methods()) {
    for (const MethodSetting& setting : method.settings) {
      if (method.kind != kind) continue;
      text += "- `" + std::string(method.name) + ":" + values_of(setting) +
              "`: " + std::string(setting.help) + "\n";
    }
  }
  return text.empty() ? "" : "\nSettings, the default first:\n\n" + text;
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
                    {"limits", method.limits},
                    {"settings", settings_json(method)}});
  }
  return print_json({{"version", version()}, {"methods", std::move(rows)}});
}

// docs/methods.md.
Status print_markdown() {
  std::string text =
      "# Methods\n\nEvery method that can be selected, the default of each kind first. This page is what\n"
      "`blysk methods --markdown` prints.\n";
  for (const MethodKind kind : kMethodKinds) {
    text += "\n## --" + std::string(kind_name(kind)) +
            "\n\n| name | what it does | source | measured against | claim of the source | valid |\n"
            "|---|---|---|---|---|---|\n";
    for (const Method& method : methods()) {
      if (method.kind != kind) continue;
      const std::string name(method.name), code = "`" + name + "`";
      const bool has_page = kind == MethodKind::shading;  // tools/method-pages
      text += "| " + (has_page ? "[" + code + "](methods/" + name + ".md)" : code) + " | " +
              std::string(method.title) + " | " + std::string(method.source) + " | " +
              std::string(method.reference) + " | " + std::string(method.claim) + " | " +
              std::string(method.limits) + " |\n";
    }
    text += settings_markdown(kind);
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
