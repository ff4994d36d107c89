#include "image/deflate_runs.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "image/huffman.h"

namespace blysk {
namespace {

static_assert(std::endian::native == std::endian::little);

constexpr int kLiteralLimit = 12;  // bits; four literals and what is left of a byte fit 64
constexpr std::size_t kEndOfBlock = 256;
constexpr std::size_t kMaxRun = 258;
constexpr std::size_t kMinRun = 3;
constexpr std::size_t kMaxStored = 65535;

std::uint64_t load64(const std::uint8_t* from) {
  std::uint64_t v;
  std::memcpy(&v, from, sizeof v);
  return v;
}

struct LengthCode {
  std::uint16_t symbol;
  std::uint8_t extra_bits;
  std::uint8_t extra;
};

// RFC 1951, 3.2.5: symbols 257..284 in groups of four to each number of extra bits but the first eight; 285
// is 258.
constexpr std::array<LengthCode, kMaxRun + 1> kLengthCodes = [] {
  std::array<LengthCode, kMaxRun + 1> codes{};
  std::size_t length = kMinRun;
  for (std::uint16_t symbol = 257; symbol < 285; ++symbol) {
    const int extra_bits = symbol < 261 ? 0 : (symbol - 261) / 4;
    for (int extra = 0; extra < 1 << extra_bits && length < kMaxRun; ++extra) {
      codes[length++] = {symbol, static_cast<std::uint8_t>(extra_bits), static_cast<std::uint8_t>(extra)};
    }
  }
  codes[kMaxRun] = {285, 0, 0};
  return codes;
}();

// Cuts a run into lengths that deflate knows.
template <class Visit>
void split_run(std::size_t bytes, Visit visit) {
  while (bytes > kMaxRun) {
    const std::size_t piece = bytes - kMaxRun >= kMinRun ? kMaxRun : kMaxRun - kMinRun;
    visit(piece);
    bytes -= piece;
  }
  visit(bytes);
}

struct BitWriter {
  std::uint8_t* to;
  std::uint64_t bits = 0;
  unsigned count = 0;

  // At most 56 bits between flushes.
  void put(std::uint64_t value, unsigned n) {
    bits |= value << count;
    count += n;
  }
  // Writes eight bytes, of which the last may yet change.
  void flush() {
    std::memcpy(to, &bits, sizeof bits);
    to += count >> 3;
    bits >>= count & ~7u;
    count &= 7;
  }
  // Pads with zero bits to a whole byte.
  void finish() {
    count = (count + 7) & ~7u;
    flush();
  }
};

void append_stored(std::span<const std::uint8_t> data, Array<std::uint8_t>& out) {
  out.reserve(out.size() + data.size() + (data.size() / kMaxStored + 1) * 5 + RunDeflate::kSlack);
  while (!data.empty()) {
    const std::size_t size = std::min(data.size(), kMaxStored);
    const auto low = static_cast<std::uint8_t>(size), high = static_cast<std::uint8_t>(size >> 8);
    const std::uint8_t header[] = {0, low, high, static_cast<std::uint8_t>(~low),
                                   static_cast<std::uint8_t>(~high)};
    out.insert(out.end(), std::begin(header), std::end(header));
    out.insert(out.end(), data.begin(), data.begin() + static_cast<std::ptrdiff_t>(size));
    data = data.subspan(size);
  }
}

// Whether the bytes at p repeat those a pixel before. Fewer than eight are hardly smaller as a run than as
// literals and cost a mispredicted branch; at a row's end they would also let bytes beyond the data decide.
template <int kPixelBytes>
bool begins_run(const std::uint8_t* p, const std::uint8_t* row_end) {
  return row_end - p >= 8 && load64(p) == load64(p - kPixelBytes);
}

// The whole pixels from p on, which begins a run or ends the row, that repeat the one before them.
template <int kPixelBytes>
std::ptrdiff_t run_length(const std::uint8_t* p, const std::uint8_t* row_end) {
  const std::uint8_t* end = p;
  while (end < row_end) {
    const std::uint64_t difference = load64(end) ^ load64(end - kPixelBytes);
    if (difference != 0) {
      end += std::countr_zero(difference) / 8;
      break;
    }
    end += sizeof difference;
  }
  return (std::min(end, row_end) - p) / kPixelBytes;
}

}  // namespace

template <int kPixelBytes>
void RunDeflate::scan(std::span<const std::uint8_t> data, const RowLayout& layout) {
  for (auto& counts : literal_counts_) counts.fill(0);
  run_counts_.fill(0);
  tokens_.clear();
  const std::uint8_t* p = data.data();
  const std::uint8_t* end = p + data.size();
  while (p != end) {
    ++literal_counts_[0][*p];
    const std::uint8_t* row_end = p + layout.row_bytes();
    ++p;
    while (p != row_end) {
      const std::uint8_t* start = p;
      do {
        for (int i = 0; i < kPixelBytes; ++i) ++literal_counts_[static_cast<std::size_t>(i)][p[i]];
        p += kPixelBytes;
      } while (p != row_end && !begins_run<kPixelBytes>(p, row_end));
      const std::ptrdiff_t repeats = run_length<kPixelBytes>(p, row_end);
      tokens_.push_back(
          {static_cast<std::uint16_t>((p - start) / kPixelBytes), static_cast<std::uint16_t>(repeats)});
      if (repeats != 0)
        split_run(static_cast<std::size_t>(repeats * kPixelBytes), [&](std::size_t n) { ++run_counts_[n]; });
      p += repeats * kPixelBytes;
    }
  }
}

void RunDeflate::describe_codes(std::span<const std::uint8_t> lengths, std::size_t distance_codes) {
  // RFC 1951, 3.2.7: lengths as a sequence of 0..15, 16 (repeat the last 3..6 times), 17 and 18
  // (3..10, 11..138 zeros).
  struct Item {
    std::uint8_t symbol, extra;
  };
  std::array<Item, kLiteralSymbols + 4> items;
  std::array<std::uint32_t, 19> counts{};
  std::size_t used = 0;
  const auto add = [&](std::size_t symbol, std::size_t extra) {
    items[used++] = {static_cast<std::uint8_t>(symbol), static_cast<std::uint8_t>(extra)};
    ++counts[symbol];
  };
  for (std::size_t i = 0; i < lengths.size();) {
    std::size_t same = 1;
    while (i + same < lengths.size() && lengths[i + same] == lengths[i]) ++same;
    i += same;
    const std::size_t length = lengths[i - 1];
    if (length != 0) {
      add(length, 0);
      --same;
    }
    while (same >= 3) {
      const std::size_t most = length != 0 ? 6 : 138;
      const std::size_t piece = std::min(same, most);
      if (length != 0)
        add(16, piece - 3);
      else if (piece <= 10)
        add(17, piece - 3);
      else
        add(18, piece - 11);
      same -= piece;
    }
    for (; same > 0; --same) add(length, 0);
  }

  std::array<std::uint8_t, 19> item_lengths;
  std::array<std::uint16_t, 19> item_codes;
  huffman_lengths(counts, 7, item_lengths);
  huffman_codes(item_lengths, item_codes);
  constexpr std::array<std::uint8_t, 19> kOrder = {16, 17, 18, 0, 8,  7, 9,  6, 10, 5,
                                                   11, 4,  12, 3, 13, 2, 14, 1, 15};
  header_.clear();
  header_.push_back({2u << 1, 3});  // not final, dynamic codes
  header_.push_back({static_cast<std::uint32_t>(kLiteralSymbols - 257), 5});
  header_.push_back({static_cast<std::uint32_t>(distance_codes - 1), 5});
  header_.push_back({static_cast<std::uint32_t>(kOrder.size() - 4), 4});
  for (const std::uint8_t symbol : kOrder) header_.push_back({item_lengths[symbol], 3});
  for (std::size_t i = 0; i < used; ++i) {
    const Item item = items[i];
    header_.push_back({item_codes[item.symbol], item_lengths[item.symbol]});
    if (item.symbol >= 16)
      header_.push_back({item.extra, item.symbol == 16 ? 2u : item.symbol == 17 ? 3u : 7u});
  }
}

std::uint64_t RunDeflate::choose_codes(std::size_t pixel_bytes) {
  std::array<std::uint32_t, kLiteralSymbols> counts{};
  counts[kEndOfBlock] = 1;
  for (const auto& channel : literal_counts_) {
    for (std::size_t i = 0; i < channel.size(); ++i) counts[i] += channel[i];
  }
  for (std::size_t n = kMinRun; n < run_counts_.size(); ++n) counts[kLengthCodes[n].symbol] += run_counts_[n];

  // The distances: of the codes 0..pixel_bytes - 1 only the last occurs; its code is one zero bit.
  std::array<std::uint8_t, kLiteralSymbols + 4> lengths{};
  const std::span literal_lengths = std::span(lengths).first(kLiteralSymbols);
  std::array<std::uint16_t, kLiteralSymbols> codes;
  huffman_lengths(counts, kLiteralLimit, literal_lengths);
  huffman_codes(literal_lengths, codes);
  lengths[kLiteralSymbols + pixel_bytes - 1] = 1;
  describe_codes(std::span(lengths).first(kLiteralSymbols + pixel_bytes), pixel_bytes);

  std::uint64_t bits = 0;
  for (const Code& c : header_) bits += c.count;
  for (std::size_t s = 0; s < counts.size(); ++s) bits += std::uint64_t{counts[s]} * lengths[s];
  for (std::size_t i = 0; i < literal_codes_.size(); ++i) literal_codes_[i] = {codes[i], lengths[i]};
  end_of_block_ = {codes[kEndOfBlock], lengths[kEndOfBlock]};
  for (std::size_t n = kMinRun; n < run_codes_.size(); ++n) {
    const LengthCode& length = kLengthCodes[n];
    const unsigned code_bits = lengths[length.symbol];
    run_codes_[n] = {codes[length.symbol] | static_cast<std::uint32_t>(length.extra) << code_bits,
                     code_bits + length.extra_bits + 1};
    bits += std::uint64_t{run_counts_[n]} * (length.extra_bits + 1u);
  }
  return bits;
}

template <int kPixelBytes>
std::uint8_t* RunDeflate::write(std::span<const std::uint8_t> data, const RowLayout& layout,
                                std::uint8_t* to) const {
  BitWriter writer{to};
  const auto put = [&writer](const Code& c) { writer.put(c.bits, c.count); };
  for (const Code& c : header_) {
    put(c);
    writer.flush();
  }
  const std::uint8_t* p = data.data();
  const std::uint8_t* end = p + data.size();
  const Token* token = tokens_.data();
  while (p != end) {
    const std::uint8_t* row_end = p + layout.row_bytes();
    put(literal_codes_[*p++]);
    writer.flush();
    for (; p != row_end; ++token) {
      for (int i = 0; i < token->literals; ++i, p += kPixelBytes) {
        // Paired first, so that only one addition a pixel waits for the one before.
        const Code a = literal_codes_[p[0]], b = literal_codes_[p[1]], c = literal_codes_[p[2]];
        const std::uint64_t ab = a.bits | std::uint64_t{b.bits} << a.count;
        std::uint64_t cd = c.bits;
        unsigned cd_count = c.count;
        if constexpr (kPixelBytes == 4) {
          cd |= std::uint64_t{literal_codes_[p[3]].bits} << cd_count;
          cd_count += literal_codes_[p[3]].count;
        }
        writer.put(ab | cd << (a.count + b.count), a.count + b.count + cd_count);
        writer.flush();
      }
      if (token->repeats == 0) continue;
      split_run(token->repeats * std::size_t{kPixelBytes}, [&](std::size_t n) {
        put(run_codes_[n]);
        writer.flush();
      });
      p += token->repeats * kPixelBytes;
    }
  }
  put(end_of_block_);
  writer.put(0, 3);  // an empty stored block ends on a byte boundary
  writer.finish();
  writer.put(0xffff0000, 32);
  writer.flush();
  return writer.to;
}

void RunDeflate::append(std::span<const std::uint8_t> data, const RowLayout& layout,
                        Array<std::uint8_t>& out) {
  const bool alpha = layout.pixel_bytes == 4;
  alpha ? scan<4>(data, layout) : scan<3>(data, layout);
  const std::uint64_t bits = choose_codes(static_cast<std::size_t>(layout.pixel_bytes));
  if (bits / 8 >= data.size()) {
    append_stored(data, out);
    return;
  }
  const std::size_t at = out.size();
  // One byte each for the partial one and the stored block's header, four for the rest of it, eight written
  // beyond.
  out.resize(at + static_cast<std::size_t>(bits / 8) + 14);
  std::uint8_t* to = out.data() + at;
  to = alpha ? write<4>(data, layout, to) : write<3>(data, layout, to);
  out.resize(static_cast<std::size_t>(to - out.data()));
}

}  // namespace blysk
