// blysk/version.h - which Blysk this is.
#pragma once

#include <string_view>

namespace blysk {

/// "MAJOR.MINOR.PATCH" of the library that is linked.
[[nodiscard]] std::string_view version();

}  // namespace blysk
