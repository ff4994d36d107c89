// io/uri.h - the URIs by which a model names its data: data: URIs and files beside the model.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "blysk/array.h"
#include "blysk/result.h"

namespace blysk::io {

/// What a data: URI holds.
struct DataUri {
  std::string mime_type;  ///< empty: not given
  Array<std::uint8_t> bytes;
};

[[nodiscard]] bool is_data_uri(std::string_view uri);

/// Decodes a base64 data: URI. Errors carry the message alone.
[[nodiscard]] Result<DataUri> decode_data_uri(std::string_view uri);

/// Largest number of bytes that the URI can hold, without decoding it.
[[nodiscard]] inline std::size_t data_uri_bound(std::string_view uri) { return uri.size() / 4 * 3 + 3; }

/// The relative path that a URI names, percent-decoded, with '/' between its parts and neither "." nor ".."
/// among them. Absolute paths, other schemes and ways out of the folder are errors, which carry the message
/// alone.
[[nodiscard]] Result<std::string> relative_path(std::string_view uri);

}  // namespace blysk::io
