#include "io/uri.h"

#include <algorithm>
#include <array>
#include <optional>

namespace blysk::io {
namespace {

constexpr std::string_view kDataScheme = "data:";
constexpr std::uint8_t kInvalid = 0xff;

constexpr std::array<std::uint8_t, 256> make_base64_values() {
  std::array<std::uint8_t, 256> values{};
  for (auto& v : values) v = kInvalid;
  constexpr std::string_view kAlphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  for (std::size_t i = 0; i < kAlphabet.size(); ++i) {
    values[static_cast<unsigned char>(kAlphabet[i])] = static_cast<std::uint8_t>(i);
  }
  return values;
}
constexpr std::array<std::uint8_t, 256> kBase64Values = make_base64_values();

Error bad_uri(std::string message) { return Error{ErrorCode::input, std::move(message), "", 0}; }

// Six bits of a character; any invalid one sets the high bits of the sum that the caller keeps.
std::uint32_t sextet(char c) { return kBase64Values[static_cast<unsigned char>(c)]; }

Error bad_base64(std::string_view text) {
  const auto bad = std::find_if(text.begin(), text.end(), [](char c) { return sextet(c) == kInvalid; });
  return bad_uri("base64 data has a character that does not belong there, number " +
                 std::to_string(bad - text.begin() + 1));
}

Result<Array<std::uint8_t>> decode_base64(std::string_view text) {
  for (int i = 0; i < 2 && text.ends_with('='); ++i) text.remove_suffix(1);
  const std::size_t rest = text.size() % 4;
  if (rest == 1) return bad_uri("base64 data ends in the middle of a byte; the file is cut short or damaged");
  const std::size_t whole = text.size() / 4;
  Array<std::uint8_t> bytes(whole * 3 + (rest == 0 ? 0 : rest - 1));
  std::uint8_t* out = bytes.data();
  std::uint32_t bad = 0;
  for (std::size_t i = 0; i < whole; ++i, out += 3) {
    const char* c = text.data() + i * 4;
    const std::uint32_t a = sextet(c[0]), b = sextet(c[1]), d = sextet(c[2]), e = sextet(c[3]);
    bad |= a | b | d | e;
    out[0] = static_cast<std::uint8_t>(a << 2 | b >> 4);
    out[1] = static_cast<std::uint8_t>(b << 4 | d >> 2);
    out[2] = static_cast<std::uint8_t>(d << 6 | e);
  }
  if (rest > 0) {
    const char* c = text.data() + whole * 4;
    const std::uint32_t a = sextet(c[0]), b = sextet(c[1]), d = rest == 3 ? sextet(c[2]) : 0;
    bad |= a | b | d;
    out[0] = static_cast<std::uint8_t>(a << 2 | b >> 4);
    if (rest == 3) out[1] = static_cast<std::uint8_t>(b << 4 | d >> 2);
  }
  if (bad > 63) return bad_base64(text);
  return bytes;
}

std::optional<int> hex(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return std::nullopt;
}

// A percent sign without two hexadecimal digits stands for itself, as exporters write file names unescaped.
std::string percent_decode(std::string_view text) {
  std::string decoded;
  decoded.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '%' && i + 2 < text.size()) {
      const auto high = hex(text[i + 1]), low = hex(text[i + 2]);
      if (high && low) {
        decoded += static_cast<char>(*high * 16 + *low);
        i += 2;
        continue;
      }
    }
    decoded += text[i];
  }
  return decoded;
}

}  // namespace

bool is_data_uri(std::string_view uri) {
  return uri.size() >= kDataScheme.size() &&
         std::equal(kDataScheme.begin(), kDataScheme.end(), uri.begin(),
                    [](char scheme, char c) { return scheme == (c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c); });
}

Result<DataUri> decode_data_uri(std::string_view uri) {
  constexpr std::string_view kBase64 = ";base64";
  const std::size_t comma = uri.find(',');
  if (comma == std::string_view::npos) return bad_uri("the data: URI has no comma before its data");
  std::string_view head = uri.substr(kDataScheme.size(), comma - kDataScheme.size());
  if (!head.ends_with(kBase64)) return bad_uri("the data: URI is not base64");
  head.remove_suffix(kBase64.size());
  Result<Array<std::uint8_t>> bytes = decode_base64(uri.substr(comma + 1));
  if (!bytes) return bytes.error();
  return DataUri{std::string(head.substr(0, head.find(';'))), std::move(*bytes)};
}

Result<std::string> relative_path(std::string_view uri) {
  std::string text = percent_decode(uri);
  if (text.find('\0') != std::string::npos) return bad_uri("the URI holds a zero byte");
  std::replace(text.begin(), text.end(), '\\', '/');
  if (text.starts_with('/'))
    return bad_uri("the URI is an absolute path; only files beside the model are read");
  const std::size_t colon = text.find(':');
  if (colon < text.find('/'))
    return bad_uri("the URI has a scheme or drive; only data: and files beside the model are read");
  std::string path;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t to = std::min(text.find('/', from), text.size());
    const std::string_view part = std::string_view(text).substr(from, to - from);
    if (part == "..")
      return bad_uri("the URI leaves the model's folder; only files beside the model are read");
    if (!part.empty() && part != ".") {
      if (!path.empty()) path += '/';
      path += part;
    }
    from = to + 1;
  }
  if (path.empty()) return bad_uri("the URI names no file");
  return path;
}

}  // namespace blysk::io
