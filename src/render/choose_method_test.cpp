#include <gtest/gtest.h>

#include "blysk/methods.h"

namespace blysk {
namespace {

std::string refusal(std::string_view text) {
  const Result<MethodChoice> choice = choose_method(MethodKind::shading, text);
  return choice ? "" : choice.error().message;
}

TEST(choose_method, a_name_alone_has_the_initial_settings) {
  const Result<MethodChoice> choice = choose_method(MethodKind::shading, "fast-normalize");
  ASSERT_TRUE(choice);
  EXPECT_EQ(choice->method->name, "fast-normalize");
  EXPECT_EQ(choice->values[0], 0);
}

TEST(choose_method, settings_follow_the_name) {
  const Result<MethodChoice> choice = choose_method(MethodKind::shading, "fast-normalize:fit=cubic");
  ASSERT_TRUE(choice);
  EXPECT_EQ(choice->values[0], 2);
  const Result<MethodChoice> last =
      choose_method(MethodKind::shading, "fast-normalize:fit=cubic,fit=minimax");
  ASSERT_TRUE(last);
  EXPECT_EQ(last->values[0], 1);
}

TEST(choose_method, says_what_would_be_right) {
  EXPECT_NE(refusal("fast-normalise").find("did you mean 'fast-normalize'?"), std::string::npos);
  EXPECT_NE(refusal("fast-normalize:fir=cubic").find("did you mean 'fit'?"), std::string::npos);
  EXPECT_NE(refusal("fast-normalize:fit=best").find("one of paper, minimax, cubic, not 'best'"),
            std::string::npos);
  EXPECT_NE(refusal("flat:fit=paper").find("flat has no settings"), std::string::npos);
  for (const char* text :
       {"", ":", "fast-normalize:", "fast-normalize:,", "fast-normalize:fit",
        "fast-normalize:fit=", "fast-normalize:fit=paper,", "fast-normalize:fit=paper:", "flat:"}) {
    EXPECT_NE(refusal(text), "") << text;
  }
}

TEST(choose_method, every_variant_can_be_chosen_and_differs) {
  for (const Method& method : methods()) {
    ASSERT_LE(method.settings.size(), kMostSettings);
    std::vector<MethodChoice> seen;
    for (const std::string& text : method_variants(method)) {
      const Result<MethodChoice> choice = choose_method(method.kind, text);
      ASSERT_TRUE(choice) << text;
      EXPECT_EQ(choice->method, &method);
      for (const MethodChoice& other : seen) EXPECT_NE(other.values, choice->values) << text;
      seen.push_back(*choice);
    }
  }
}

TEST(choose_method, lists_keep_settings_with_their_method) {
  EXPECT_EQ(split_methods("flat"), (std::vector<std::string>{"flat"}));
  EXPECT_EQ(split_methods("flat,a:b=1,c=2,phong,d=3"),
            (std::vector<std::string>{"flat", "a:b=1,c=2", "phong", "d=3"}));
  EXPECT_EQ(split_methods(""), (std::vector<std::string>{""}));
}

}  // namespace
}  // namespace blysk
