// image/deflate_runs.h - deflate for filtered picture rows, made for speed.
//
// Knows one kind of match: a pixel that repeats its left neighbour, which is what filtered flat areas and
// smooth ramps are made of. The rest are literals in a Huffman code of the data's own. Based on: RFC 1951;
// the idea of pixel runs alone is that of Geldreich's fpng, 2021.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "blysk/array.h"

namespace blysk {

/// Rows of a PNG picture: a filter byte, then width pixels of pixel_bytes (3 or 4) bytes.
struct RowLayout {
  int width = 0;
  int pixel_bytes = 4;

  [[nodiscard]] std::size_t row_bytes() const {
    return 1 + static_cast<std::size_t>(width) * static_cast<std::size_t>(pixel_bytes);
  }
};

class RunDeflate {
 public:
  /// Bytes after the data that are read; their values do not matter.
  static constexpr std::size_t kSlack = 8;

  /// Appends whole rows to `out` as deflate blocks of which none is final. They begin and end on a byte
  /// boundary, so that results can be strung together. `data` is readable for kSlack bytes more. Never longer
  /// than the data by more than 5 bytes for each 65535 of them.
  void append(std::span<const std::uint8_t> data, const RowLayout& layout, Array<std::uint8_t>& out);

 private:
  static constexpr std::size_t kLiteralSymbols = 286;

  // Pixels that go as literals, then pixels that repeat.
  struct Token {
    std::uint16_t literals;
    std::uint16_t repeats;
  };
  struct Code {
    std::uint32_t bits;
    std::uint32_t count;
  };

  template <int kPixelBytes>
  void scan(std::span<const std::uint8_t> data, const RowLayout& layout);
  void describe_codes(std::span<const std::uint8_t> lengths, std::size_t distance_codes);
  std::uint64_t choose_codes(std::size_t pixel_bytes);  // returns the size of the block in bits
  template <int kPixelBytes>
  std::uint8_t* write(std::span<const std::uint8_t> data, const RowLayout& layout, std::uint8_t* to) const;

  std::vector<Token> tokens_;
  std::vector<Code> header_;  // of the block, as it will be written
  std::array<std::array<std::uint32_t, 256>, 4>
      literal_counts_;                         // one for each channel: no waiting for a store
  std::array<std::uint32_t, 259> run_counts_;  // by length in bytes
  std::array<Code, 256> literal_codes_;
  std::array<Code, 259> run_codes_;  // with extra bits and distance
  Code end_of_block_;
};

}  // namespace blysk
