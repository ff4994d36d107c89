#include "image/deflate_runs.h"

#include <gtest/gtest.h>

#include <vector>

namespace blysk {
namespace {

Array<std::uint8_t> deflate(std::vector<std::uint8_t> rows, const RowLayout& layout, std::uint8_t beyond) {
  const std::size_t size = rows.size();
  rows.resize(size + RunDeflate::kSlack, beyond);
  Array<std::uint8_t> out;
  RunDeflate().append(std::span(rows).first(size), layout, out);
  return out;
}

// What lies behind the data differs from thread to thread.
TEST(run_deflate, bytes_beyond_the_data_do_not_show) {
  for (const int pixel_bytes : {3, 4}) {
    for (int width = 1; width < 12; ++width) {
      const RowLayout layout{width, pixel_bytes};
      for (std::size_t equal = 0; equal < layout.row_bytes(); ++equal) {
        std::vector<std::uint8_t> rows(4 * layout.row_bytes(), 1);
        for (std::size_t i = 0; i + equal < rows.size(); ++i) rows[i] = static_cast<std::uint8_t>(i % 5);
        const Array<std::uint8_t> out = deflate(rows, layout, 1);
        for (const int beyond : {0, 2, 255}) {
          ASSERT_EQ(deflate(rows, layout, static_cast<std::uint8_t>(beyond)), out) << width;
        }
      }
    }
  }
}

TEST(run_deflate, a_deflater_remembers_nothing) {
  const RowLayout layout{100, 4};
  std::vector<std::uint8_t> rows(layout.row_bytes() + RunDeflate::kSlack);
  RunDeflate used;
  Array<std::uint8_t> first, second;
  used.append(std::span(rows).first(layout.row_bytes()), layout, first);
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = static_cast<std::uint8_t>(i % 7);
  used.append(std::span(rows).first(layout.row_bytes()), layout, second);
  Array<std::uint8_t> fresh;
  RunDeflate().append(std::span(rows).first(layout.row_bytes()), layout, fresh);
  EXPECT_EQ(second, fresh);
  EXPECT_NE(first, second);
}

}  // namespace
}  // namespace blysk
