// NAME[:SETTING=VALUE,...] to a row of the registry and its settings.
#include <algorithm>
#include <charconv>
#include <optional>

#include "blysk/methods.h"
#include "core/nearest.h"

namespace blysk {
namespace {

using Names = std::vector<std::string_view>;

Error failure(std::string message) { return {ErrorCode::usage, std::move(message), {}, 0}; }

std::string joined(std::span<const std::string_view> words) {
  std::string text;
  for (const std::string_view word : words) (text += text.empty() ? "" : ", ") += word;
  return text;
}

std::string did_you_mean(std::string_view word, std::span<const std::string_view> choices) {
  const std::string_view meant = nearest(word, choices);
  return meant.empty() ? "" : ", did you mean '" + std::string(meant) + "'?";
}

Error unknown_method(MethodKind kind, std::string_view name) {
  Names names;
  for (const Method& method : methods()) {
    if (method.kind == kind) names.push_back(method.name);
  }
  return failure("there is no " + std::string(kind_name(kind)) + " method called " + std::string(name) +
                 did_you_mean(name, names) + " (one of " + joined(names) + ")");
}

Error unknown_setting(const Method& method, std::string_view name) {
  const std::string of = std::string(method.name) + " has no ";
  if (method.settings.empty()) return failure(of + "settings, only the name is wanted");
  Names names;
  for (const MethodSetting& setting : method.settings) names.push_back(setting.name);
  return failure(of + "setting called " + std::string(name) + did_you_mean(name, names) + " (one of " +
                 joined(names) + ")");
}

std::string domain(const MethodSetting& setting) {
  return setting.choices.empty() ? "a whole number from " + std::to_string(setting.lowest) + " to " +
                                       std::to_string(setting.highest)
                                 : "one of " + joined(setting.choices);
}

std::optional<int> value_of(const MethodSetting& setting, std::string_view text) {
  if (!setting.choices.empty()) {
    const auto found = std::ranges::find(setting.choices, text);
    if (found == setting.choices.end()) return std::nullopt;
    return static_cast<int>(found - setting.choices.begin());
  }
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || value < setting.lowest ||
      value > setting.highest) {
    return std::nullopt;
  }
  return value;
}

Status set(MethodChoice& choice, std::string_view part) {
  const std::size_t equals = part.find('=');
  const std::string_view name = part.substr(0, equals);
  const auto& settings = choice.method->settings;
  const auto setting = std::ranges::find(settings, name, &MethodSetting::name);
  if (setting == settings.end()) return unknown_setting(*choice.method, name);
  const std::string_view text = equals == std::string_view::npos ? "" : part.substr(equals + 1);
  const std::optional<int> value = value_of(*setting, text);
  if (!value) {
    return failure(std::string(name) + " of " + std::string(choice.method->name) + " must be " +
                   domain(*setting) + ", not '" + std::string(text) + "'");
  }
  choice.values[static_cast<std::size_t>(setting - settings.begin())] = *value;
  return Done{};
}

std::string value_text(const MethodSetting& setting, int value) {
  return setting.choices.empty() ? std::to_string(value)
                                 : std::string(setting.choices[static_cast<std::size_t>(value)]);
}

}  // namespace

Result<MethodChoice> choose_method(MethodKind kind, std::string_view text) {
  const std::size_t colon = text.find(':');
  MethodChoice choice;
  choice.method = find_method(kind, text.substr(0, colon));
  if (choice.method == nullptr) return unknown_method(kind, text.substr(0, colon));
  for (std::size_t i = 0; i < choice.method->settings.size(); ++i) {
    choice.values[i] = choice.method->settings[i].initial;
  }
  while (!text.empty() && colon != std::string_view::npos) {
    text.remove_prefix(std::min(text.size(), text.find_first_of(":,") + 1));
    const std::size_t comma = text.find(',');
    if (const Status status = set(choice, text.substr(0, comma)); !status) return status.error();
    if (comma == std::string_view::npos) break;
  }
  return choice;
}

std::vector<std::string> method_variants(const Method& method) {
  std::vector<std::string> variants = {std::string(method.name)};
  for (const MethodSetting& setting : method.settings) {
    const auto add = [&](int value) {
      if (value == setting.initial) return;
      variants.push_back(std::string(method.name) + ":" + std::string(setting.name) + "=" +
                         value_text(setting, value));
    };
    if (setting.choices.empty()) {
      add(setting.lowest);
      add(setting.highest);
    }
    for (int i = 0; i < static_cast<int>(setting.choices.size()); ++i) add(i);
  }
  return variants;
}

std::vector<std::string> split_methods(std::string_view list) {
  std::vector<std::string> names;
  for (;;) {
    const std::size_t comma = list.find(',');
    const std::string_view part = list.substr(0, comma);
    // A setting that is not the first of its method.
    const bool goes_on = !names.empty() && names.back().find(':') != std::string::npos &&
                         part.find(':') == std::string_view::npos && part.find('=') != std::string_view::npos;
    if (goes_on) {
      (names.back() += ",") += part;
    } else {
      names.emplace_back(part);
    }
    if (comma == std::string_view::npos) return names;
    list.remove_prefix(comma + 1);
  }
}

}  // namespace blysk
