#include "study/timing.h"

#include <gtest/gtest.h>

#include <vector>

namespace blysk::study {
namespace {

bool is_settled(std::vector<double> samples) { return settled(samples); }

TEST(settled, needs_three_samples_near_the_best) {
  EXPECT_FALSE(is_settled({}));
  EXPECT_FALSE(is_settled({5, 5}));
  EXPECT_TRUE(is_settled({5, 5, 5}));
  EXPECT_TRUE(is_settled({5.04, 9, 5, 7, 5.05}));
  EXPECT_FALSE(is_settled({5.06, 5, 5.05}));
}

TEST(settled, begins_anew_with_a_better_sample) {
  EXPECT_TRUE(is_settled({8, 8, 8}));
  EXPECT_FALSE(is_settled({8, 8, 8, 5}));
  EXPECT_TRUE(is_settled({8, 8, 8, 5, 5, 5}));
}

TEST(time_in_turn, runs_all_equally_often_and_not_more_than_allowed) {
  int first = 0, second = 0;
  const std::vector<std::function<void()>> runs = {[&] { ++first; }, [&] { ++second; }};
  const std::vector<Timing> timings = time_in_turn(runs, {.most = 1, .least_ms = 0});
  ASSERT_EQ(timings.size(), 2u);
  EXPECT_EQ(timings[0].gain, 1);
  EXPECT_EQ(first, 2);  // once to fill caches
  EXPECT_EQ(second, 2);
  EXPECT_GT(timings[1].ns, 0);
  static_cast<void>(time_in_turn(runs, {.most = 7, .least_ms = 0}));
  EXPECT_EQ(first, second);
  EXPECT_GE(first, 2 + 4);
  EXPECT_LE(first, 2 + 8);
}

TEST(time_in_turn, gains_are_over_the_first) {
  volatile int sink = 0;
  const auto work = [&](int n) {
    return [&sink, n] {
      for (int i = 0; i < n; ++i) sink = i;
    };
  };
  const std::vector<std::function<void()>> runs = {work(400000), work(100000)};
  const std::vector<Timing> timings = time_in_turn(runs, {});
  EXPECT_GT(timings[1].gain, 2);
  EXPECT_DOUBLE_EQ(timings[1].gain, timings[0].ns / timings[1].ns);
}

}  // namespace
}  // namespace blysk::study
