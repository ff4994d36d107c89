#include <algorithm>

#include "io/reader.h"

namespace blysk::io {

Error broken(const Source& source, std::string message) {
  return {ErrorCode::input, std::move(message), source.name, 0};
}

Error broken_at(const Source& source, std::size_t offset, std::string message) {
  const std::string_view before = source.text().substr(0, offset);
  const auto line = std::count(before.begin(), before.end(), '\n') + 1;
  return {ErrorCode::input, std::move(message), source.name, static_cast<long long>(line)};
}

Status check_limits(const Source& source, std::uint64_t triangles, std::uint64_t bytes) {
  const Limits& limits = source.options.limits;
  if (triangles > limits.max_triangles) {
    return Error{ErrorCode::limit,
                 "has " + std::to_string(triangles) + " triangles, more than the limit of " +
                     std::to_string(limits.max_triangles) + "; raise --max-triangles",
                 source.name};
  }
  if (bytes > limits.max_memory) {
    return Error{ErrorCode::limit,
                 "needs " + std::to_string(bytes) + " bytes of memory, more than the limit of " +
                     std::to_string(limits.max_memory) + "; raise --max-memory",
                 source.name};
  }
  return Done{};
}

Status check_index_width(const Source& source, std::uint64_t triangles) {
  constexpr std::uint64_t kMost = 0xfffffffe / 3;
  if (triangles <= kMost) return Done{};
  return Error{ErrorCode::limit,
               "has " + std::to_string(triangles) + " triangles, more than the " + std::to_string(kMost) +
                   " that one mesh can have; cut the model up",
               source.name};
}

}  // namespace blysk::io
