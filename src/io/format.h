// io/format.h - which format a file is: its content decides, the extension only where content cannot.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "blysk/result.h"

namespace blysk::io {

enum class Format { obj, stl, ply, off, gltf };

/// The format, or a sentence that says what the file looks like instead and which formats there are.
/// `name` gives the extension.
[[nodiscard]] Result<Format> find_format(std::span<const std::byte> bytes, std::string_view name);

}  // namespace blysk::io
