// blysk/methods.h - the registry: every selectable method, once.
#pragma once

#include <span>
#include <string_view>

namespace blysk {

enum class MethodKind { shading, lighting, lobe, antialias };
[[nodiscard]] std::string_view kind_name(MethodKind kind);

/// One row. Text fields are empty where they do not apply.
struct Method {
  MethodKind kind;
  std::string_view name;  ///< as given to the option of its kind
  std::string_view title;
  std::string_view source;     ///< paper and formula
  std::string_view reference;  ///< name of the method that it is measured against
  std::string_view claim;      ///< speed-up and error that the source claims
  std::string_view limits;     ///< where it is valid
};

/// All rows, grouped by kind, the default of each kind first.
[[nodiscard]] std::span<const Method> methods();
[[nodiscard]] const Method* find_method(MethodKind kind, std::string_view name);

}  // namespace blysk
