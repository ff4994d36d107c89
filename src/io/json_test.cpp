#include "io/json.h"

#include <gtest/gtest.h>

namespace blysk::io {
namespace {

using Kind = Json::Kind;

std::string error_of(std::string_view text) {
  const auto document = JsonDocument::parse(text);
  return document ? "parsed" : document.error().text();
}

}  // namespace

TEST(json, values_of_every_kind) {
  const auto document = JsonDocument::parse(
      R"({"n":null,"t":true,"f":false,"i":-12,"u":9007199254740993,"d":2.5e-3,"s":"a\u00e9\n",)"
      R"("a":[1,[],{}],"o":{"x":7}})");
  ASSERT_TRUE(document);
  const Json root = document->root();
  EXPECT_EQ(root.items().size(), 9u);
  EXPECT_EQ(root["n"].kind(), Kind::null);
  EXPECT_TRUE(root["t"].boolean());
  EXPECT_FALSE(root["f"].boolean());
  EXPECT_EQ(root["f"].kind(), Kind::boolean);
  EXPECT_EQ(root["i"].number(), -12);
  EXPECT_EQ(root["d"].number(), 0.0025);
  EXPECT_EQ(root["s"].text(), "a\xc3\xa9\n");
  EXPECT_EQ(root["a"].items().size(), 3u);
  EXPECT_EQ(root["a"].items()[1].kind(), Kind::array);
  EXPECT_EQ(root["o"]["x"].number(), 7);
  EXPECT_EQ(root["o"].name(), "o");
}

TEST(json, values_of_another_kind_are_empty) {
  const auto document = JsonDocument::parse(R"({"s":"text","a":[1]})");
  ASSERT_TRUE(document);
  const Json root = document->root();
  EXPECT_FALSE(root["absent"]);
  EXPECT_FALSE(root["absent"]["deeper"]);
  EXPECT_FALSE(root["a"]["x"]);
  EXPECT_EQ(root["s"].number(), 0);
  EXPECT_TRUE(root["s"].items().empty());
  EXPECT_EQ(root["a"].text(), "");
  EXPECT_EQ(Json().kind(), Kind::none);
  EXPECT_EQ(Json().path(), "");
}

TEST(json, first_of_equal_names_counts) {
  const auto document = JsonDocument::parse(R"({"x":1,"x":2})");
  ASSERT_TRUE(document);
  EXPECT_EQ(document->root()["x"].number(), 1);
}

TEST(json, paths) {
  const auto document = JsonDocument::parse(R"({"a":[0,{"b":{},"c":[[],[5,6]]}],"d":1})");
  ASSERT_TRUE(document);
  const Json c = document->root()["a"].items()[1]["c"];
  EXPECT_EQ(c.items()[1].items()[1].path(), "a[1].c[1][1]");
  EXPECT_EQ(c.items()[0].path(), "a[1].c[0]");
  EXPECT_EQ(document->root()["d"].path(), "d");
  EXPECT_EQ(document->root().path(), "");
}

TEST(json, nesting_is_bounded) {
  const auto nested = [](std::size_t depth) { return std::string(depth, '[') + std::string(depth, ']'); };
  EXPECT_EQ(error_of(nested(64)), "parsed");
  EXPECT_NE(error_of(nested(65)).find("nested deeper than 64"), std::string::npos);
  EXPECT_NE(error_of(std::string(1'000'000, '[')).find("nested deeper"), std::string::npos);
}

TEST(json, errors_say_where) {
  EXPECT_EQ(error_of("{\n  \"a\": 1,\n  \"b\": oops\n}").find("line 3: the JSON text is broken: "), 0u);
  EXPECT_NE(error_of("[1,2").find("at byte"), std::string::npos);
  for (const char* text :
       {"", "   ", "{", "[1,]", "{\"a\"}", "nul", "1 2", "\"\xff\"", "[1e999]", "{\"a\":1}x", "'"}) {
    const std::string error = error_of(text);
    EXPECT_NE(error.find("the JSON text is broken"), std::string::npos) << text;
    EXPECT_EQ(error.find('\n'), std::string::npos) << text;
  }
}

}  // namespace blysk::io
