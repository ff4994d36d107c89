// image/atomic_file.h - files that appear whole or not at all.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "blysk/result.h"

namespace blysk {

using ByteSpan = std::span<const std::uint8_t>;

/// Writes the pieces to a temporary name in the same folder and renames it; a device or a pipe is written
/// directly, and
/// "-" is standard output. On failure (ErrorCode::output) an existing file is as it was and no other is left.
Status write_whole_file(const std::string& path, std::span<const ByteSpan> pieces);

/// Removes the temporary files of all unfinished calls. Async-signal-safe.
void remove_unfinished_files() noexcept;

}  // namespace blysk
