// json.h - what --json prints.
#pragma once

#include <cmath>
#include <nlohmann/json.hpp>

#include "blysk/vector.h"
#include "terminal.h"

namespace blysk::command {

using Json = nlohmann::ordered_json;  // fields in the order written

/// Prints one document on one line. Names out of files may be no UTF-8; what is not becomes U+FFFD.
[[nodiscard]] inline Status print_json(const Json& json) {
  return print(json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n");
}

/// Milliseconds to a microsecond, which is all that a clock is good for.
[[nodiscard]] inline double json_ms(double ms) { return std::round(ms * 1000) / 1000; }

template <class T>
[[nodiscard]] Json json_vector(Vec3<T> v) {
  return Json::array({v.x, v.y, v.z});
}

}  // namespace blysk::command
