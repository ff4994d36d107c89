// blysk/methods.h - the registry: every selectable method, once.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "blysk/result.h"

namespace blysk {

enum class MethodKind { shading, lighting, lobe, antialias };
inline constexpr MethodKind kMethodKinds[] = {MethodKind::shading, MethodKind::lighting, MethodKind::lobe,
                                              MethodKind::antialias};
[[nodiscard]] std::string_view kind_name(MethodKind kind);

/// What can be set of a method, after its name: "quadratic:form=pair,segments=4".
struct MethodSetting {
  std::string_view name;
  std::string_view help;
  std::span<const std::string_view> choices;  ///< empty: a whole number from lowest to highest
  int initial = 0;                            ///< index of the choice, or the number
  int lowest = 0, highest = 0;
};

/// One row. Text fields are empty where they do not apply.
struct Method {
  MethodKind kind;
  std::string_view name;  ///< as given to the option of its kind
  std::string_view title;
  std::string_view source;     ///< paper and formula
  std::string_view reference;  ///< name of the method that it is measured against
  std::string_view claim;      ///< speed-up and error that the source claims
  std::string_view limits;     ///< where it is valid
  std::span<const MethodSetting> settings = {};
};

/// All rows, grouped by kind, the default of each kind first.
[[nodiscard]] std::span<const Method> methods();
[[nodiscard]] const Method* find_method(MethodKind kind, std::string_view name);

inline constexpr std::size_t kMostSettings = 5;  ///< of a method

/// A method and its settings.
struct MethodChoice {
  const Method* method = nullptr;
  std::array<int, kMostSettings>
      values{};  ///< of method->settings in their order: index of the choice, or the number
};

/// Reads NAME[:SETTING=VALUE,...].
[[nodiscard]] Result<MethodChoice> choose_method(MethodKind kind, std::string_view text);

/// The method as it is by default, then with each setting changed to each of its other choices (numbers: to
/// both ends of the range), as choose_method() reads them.
[[nodiscard]] std::vector<std::string> method_variants(const Method& method);

/// Methods in a list that commas separate, as choose_method() reads them:
/// "flat,quadratic:form=pair,segments=4" holds two.
[[nodiscard]] std::vector<std::string> split_methods(std::string_view list);

}  // namespace blysk
