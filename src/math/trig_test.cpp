#include "math/trig.h"

#include <gtest/gtest.h>

#include <cmath>

TEST(trig, agrees_with_libm) {
  for (int i = -20000; i <= 20000; ++i) {
    const double x = i * 0.001237;
    EXPECT_NEAR(blysk::sine(x), std::sin(x), 1e-15);
    EXPECT_NEAR(blysk::cosine(x), std::cos(x), 1e-15);
    EXPECT_NEAR(blysk::arc_tangent(x), std::atan(x), 1e-15);
  }
}

TEST(trig, corners) {
  EXPECT_EQ(blysk::sine(0), 0);
  EXPECT_EQ(blysk::cosine(0), 1);
  EXPECT_NEAR(blysk::tangent(blysk::radians(45)), 1, 1e-15);
}
