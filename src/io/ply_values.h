// io/ply_values.h - one value of a PLY file after the other, whatever its format and type.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <type_traits>
#include <utility>

#include "io/ply_header.h"
#include "io/text.h"

namespace blysk::io {

static_assert(std::endian::native == std::endian::little, "the readers take the host's order for the file's");

/// The value at `at`, at any alignment.
template <class T, bool kSwap>
T load(const std::byte* at) {
  T value;
  std::memcpy(&value, at, sizeof value);
  if constexpr (!kSwap || sizeof(T) == 1) {
    return value;
  } else if constexpr (sizeof(T) == 2) {
    return std::bit_cast<T>(__builtin_bswap16(std::bit_cast<std::uint16_t>(value)));
  } else if constexpr (sizeof(T) == 4) {
    return std::bit_cast<T>(__builtin_bswap32(std::bit_cast<std::uint32_t>(value)));
  } else {
    return std::bit_cast<T>(__builtin_bswap64(std::bit_cast<std::uint64_t>(value)));
  }
}

/// Calls f(T{}) with the C++ type of `type`.
template <class F>
decltype(auto) with_type(PlyType type, F&& f) {
  switch (type) {
    case PlyType::int8:
      return f(std::int8_t{});
    case PlyType::uint8:
      return f(std::uint8_t{});
    case PlyType::int16:
      return f(std::int16_t{});
    case PlyType::uint16:
      return f(std::uint16_t{});
    case PlyType::int32:
      return f(std::int32_t{});
    case PlyType::uint32:
      return f(std::uint32_t{});
    case PlyType::float64:
      return f(double{});
    case PlyType::float32:
      break;
  }
  return f(float{});
}

template <bool kSwap>
class BinaryPlyValues {
 public:
  BinaryPlyValues(std::span<const std::byte> bytes, std::size_t offset) : bytes_(bytes), at_(offset) {}

  [[nodiscard]] std::size_t offset() const { return at_; }
  [[nodiscard]] std::size_t left() const { return bytes_.size() - at_; }

  /// False at the end of the file.
  [[nodiscard]] bool next(PlyType type, double& value) {
    if (left() < size_of(type)) return false;
    value = with_type(type, [&](auto t) -> double {
      return static_cast<double>(load<decltype(t), kSwap>(bytes_.data() + at_));
    });
    at_ += size_of(type);
    return true;
  }
  [[nodiscard]] bool skip(PlyType type, std::uint64_t count) {
    if (left() / size_of(type) < count) return false;
    at_ += size_of(type) * count;
    return true;
  }
  [[nodiscard]] Error failure(const Source& source, const std::string& where) const {
    return complaint(source, "is cut short: it ends in " + where + "; fetch or export it again");
  }
  [[nodiscard]] Error complaint(const Source& source, std::string what) const {
    return broken(source, std::move(what));
  }

 private:
  std::span<const std::byte> bytes_;
  std::size_t at_;
};

class AsciiPlyValues {
 public:
  AsciiPlyValues(std::span<const std::byte> bytes, std::size_t offset)
      : text_({reinterpret_cast<const char*>(bytes.data()) + offset, bytes.size() - offset}),
        first_(offset) {}

  [[nodiscard]] std::size_t offset() const { return first_ + text_.offset(); }
  [[nodiscard]] std::size_t left() const { return text_.left(); }

  /// False at the end of the file and at what is no number.
  [[nodiscard]] bool next(PlyType type, double& value) {
    if (type != PlyType::float32) return text_.number(value);
    float single = 0;
    if (!text_.number(single)) return false;
    value = static_cast<double>(single);
    return true;
  }
  [[nodiscard]] bool skip(PlyType, std::uint64_t count) {
    for (; count > 0; --count) {
      if (text_.word().empty()) return false;
    }
    return true;
  }
  [[nodiscard]] Error failure(const Source& source, const std::string& where) {
    text_.skip_space();
    const std::string what =
        text_.at_end() ? "is cut short: it ends in " : "has something other than a number in ";
    return complaint(source, what + where + "; fetch or export it again");
  }
  /// About what was read last.
  [[nodiscard]] Error complaint(const Source& source, std::string what) const {
    return broken_at(source, offset(), std::move(what));
  }

 private:
  TextCursor text_;
  std::size_t first_;
};

}  // namespace blysk::io
