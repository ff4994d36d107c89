#include "core/nearest.h"

#include <gtest/gtest.h>

#include <string>

namespace {

constexpr std::string_view kNames[] = {"teapot", "sphere", "spheres", "icosphere", "cube", "terrain", "none"};

TEST(nearest, finds_one_edit_of_each_kind) {
  EXPECT_EQ(blysk::nearest("teapto", kNames), "teapot");   // swap
  EXPECT_EQ(blysk::nearest("tepot", kNames), "teapot");    // delete
  EXPECT_EQ(blysk::nearest("teappot", kNames), "teapot");  // insert
  EXPECT_EQ(blysk::nearest("teabot", kNames), "teapot");   // replace
  EXPECT_EQ(blysk::nearest("CUBE", kNames), "cube");
}

TEST(nearest, counts_a_swap_as_one_edit) { EXPECT_EQ(blysk::nearest("cbue", kNames), "cube"); }

TEST(nearest, counts_a_sound_as_one_edit) {
  constexpr std::string_view methods[] = {"phong", "gouraud", "flat", "cubic", "auto", "blinn", "lambert"};
  EXPECT_EQ(blysk::nearest("fong", methods), "phong");
  EXPECT_EQ(blysk::nearest("kubick", methods), "cubic");
  EXPECT_EQ(blysk::nearest("phlat", methods), "flat");
  EXPECT_EQ(blysk::nearest("king", methods), "");
  EXPECT_EQ(blysk::nearest("fl", methods), "flat");  // its beginning
  EXPECT_EQ(blysk::nearest("coat", methods), "");
  constexpr std::string_view short_names[] = {"red", "blue", "grey"};
  EXPECT_EQ(blysk::nearest("by", short_names), "");  // too short to have a sound in it
}

TEST(nearest, prefers_fewer_edits_then_the_first) {
  EXPECT_EQ(blysk::nearest("sphere", kNames), "sphere");
  EXPECT_EQ(blysk::nearest("spheers", kNames), "spheres");
  constexpr std::string_view equals[] = {"bat", "cat"};
  EXPECT_EQ(blysk::nearest("rat", equals), "bat");
}

TEST(nearest, completes_a_beginning) { EXPECT_EQ(blysk::nearest("icos", kNames), "icosphere"); }

TEST(nearest, is_empty_when_nothing_is_near) {
  EXPECT_EQ(blysk::nearest("bunny", kNames), "");
  EXPECT_EQ(blysk::nearest("", kNames), "");
  EXPECT_EQ(blysk::nearest("x", kNames), "");
  EXPECT_EQ(blysk::nearest("teapot", {}), "");
  constexpr std::string_view short_names[] = {"a", "b"};
  EXPECT_EQ(blysk::nearest("c", short_names), "");
}

TEST(nearest, stands_long_words) {
  EXPECT_EQ(blysk::nearest(std::string(100000, 'a'), kNames), "");
  const std::string longest(64, 'a'), nearly(63, 'a'), too_long(65, 'a');
  const std::string_view choices[] = {too_long, longest};
  EXPECT_EQ(blysk::nearest(nearly, choices), longest);
}

}  // namespace
