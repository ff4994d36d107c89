#include "io/text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace blysk::io {

TEST(parse_number, floats) {
  float v = 0;
  EXPECT_TRUE(parse_number("+1.5e-3", v));
  EXPECT_EQ(v, 1.5e-3f);
  EXPECT_TRUE(parse_number("-.5", v));
  EXPECT_EQ(v, -0.5f);
  EXPECT_TRUE(parse_number("1.", v));
  EXPECT_EQ(v, 1.0f);
  EXPECT_TRUE(parse_number("1e-60", v));
  EXPECT_EQ(v, 0.0f);
  EXPECT_TRUE(parse_number("-1e60", v));
  EXPECT_EQ(v, -std::numeric_limits<float>::infinity());
  EXPECT_TRUE(parse_number("NaN", v));
  EXPECT_TRUE(std::isnan(v));
  for (const char* word : {"", "+", "+-1", "1,5", "1.5x", "e5", "--1", "0x10"})
    EXPECT_FALSE(parse_number(word, v)) << word;
}

TEST(parse_number, whole_numbers) {
  long long v = 0;
  EXPECT_TRUE(parse_number("-12", v));
  EXPECT_EQ(v, -12);
  EXPECT_FALSE(parse_number("99999999999999999999", v));
  EXPECT_FALSE(parse_number("1.5", v));
}

TEST(text_cursor, words_and_lines) {
  TextCursor cursor("  a b\r\n\r\nrest of it\rlast");
  EXPECT_EQ(cursor.word(), "a");
  EXPECT_EQ(cursor.word(), "b");
  EXPECT_EQ(cursor.line(), "");
  EXPECT_EQ(cursor.line(), "");
  EXPECT_EQ(cursor.line(), "rest of it");
  EXPECT_EQ(cursor.line(), "last");
  EXPECT_TRUE(cursor.at_end());
  EXPECT_EQ(cursor.word(), "");
}

TEST(text_cursor, no_step_at_what_is_no_number) {
  TextCursor cursor("1 x");
  float v = 0;
  EXPECT_TRUE(cursor.number(v));
  EXPECT_FALSE(cursor.number(v));
  EXPECT_EQ(cursor.word(), "x");
}

}  // namespace blysk::io
