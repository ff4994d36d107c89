#include "core/random.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace {

// The published test vector of SplitMix64 for seed 1234567.
TEST(random, gives_the_published_sequence) {
  blysk::Random random(1234567);
  EXPECT_EQ(random.next(), 6457827717110365317u);
  EXPECT_EQ(random.next(), 3203168211198807973u);
  EXPECT_EQ(random.next(), 9817491932198370423u);
}

TEST(random, unit_fills_its_range) {
  blysk::Random random(7);
  float low = 1, high = 0;
  double sum = 0;
  for (int i = 0; i < 100000; ++i) {
    const float x = random.unit();
    low = std::min(low, x);
    high = std::max(high, x);
    sum += static_cast<double>(x);
  }
  EXPECT_GE(low, 0);
  EXPECT_LT(low, 0.001f);
  EXPECT_LT(high, 1);
  EXPECT_GT(high, 0.999f);
  EXPECT_NEAR(sum / 100000, 0.5, 0.005);
}

}  // namespace
