#include "io/uri.h"

#include <gtest/gtest.h>

namespace blysk::io {
namespace {

std::string decoded(std::string_view data) {
  const auto uri = decode_data_uri("data:a/b;base64," + std::string(data));
  return uri ? std::string(uri->bytes.begin(), uri->bytes.end()) : "error: " + uri.error().message;
}

std::string path_of(std::string_view uri) {
  const auto path = relative_path(uri);
  return path ? *path : "error";
}

}  // namespace

TEST(uri, base64) {
  EXPECT_EQ(decoded(""), "");
  EXPECT_EQ(decoded("TQ=="), "M");
  EXPECT_EQ(decoded("TWE="), "Ma");
  EXPECT_EQ(decoded("TWFu"), "Man");
  EXPECT_EQ(decoded("TWFuTQ"), "ManM");  // padding may be missing
  EXPECT_EQ(decoded("+/+/"), "\xfb\xff\xbf");
}

TEST(uri, broken_base64) {
  EXPECT_EQ(decoded("TWF*").find("error: base64 data has a character that does not belong there, number 4"),
            0u);
  EXPECT_EQ(decoded("TW\nFuTWFu").find("error"), 0u);
  EXPECT_EQ(decoded("T=Fu").find("error"), 0u);
  EXPECT_EQ(decoded("TWFuT").find("error: base64 data ends in the middle"), 0u);
  EXPECT_EQ(decoded("===").find("error"), 0u);
}

TEST(uri, data_uris) {
  EXPECT_TRUE(is_data_uri("data:,"));
  EXPECT_TRUE(is_data_uri("DATA:,"));
  EXPECT_FALSE(is_data_uri("data"));
  EXPECT_FALSE(is_data_uri("data.bin"));
  EXPECT_EQ(decode_data_uri("data:image/png;charset=x;base64,TQ==")->mime_type, "image/png");
  EXPECT_EQ(decode_data_uri("data:;base64,TQ==")->mime_type, "");
  EXPECT_FALSE(decode_data_uri("data:text/plain,hello"));
  EXPECT_FALSE(decode_data_uri("data:;base64"));
}

TEST(uri, relative_paths) {
  EXPECT_EQ(path_of("a.bin"), "a.bin");
  EXPECT_EQ(path_of("./b/./a%20c.bin"), "b/a c.bin");
  EXPECT_EQ(path_of("b\\a.bin"), "b/a.bin");
  EXPECT_EQ(path_of("100%.bin"), "100%.bin");
  EXPECT_EQ(path_of("a..b/..c"), "a..b/..c");
  EXPECT_EQ(path_of("x/a:b"), "x/a:b");
}

TEST(uri, paths_that_lead_elsewhere) {
  for (const char* uri :
       {"", ".", "/etc/passwd", "%2Fetc/passwd", "..", "../a", "a/../../b", "a/..", "a%2F..%2Fb", "..\\a",
        "\\\\host\\a", "C:\\a", "http://host/a", "file:///a", "a%00b"}) {
    EXPECT_EQ(path_of(uri), "error") << uri;
  }
}

}  // namespace blysk::io
