#include "math/noise.h"

#include <gtest/gtest.h>

namespace {

using blysk::gradient_noise;

TEST(noise, has_the_value_of_the_specification) {
  EXPECT_NEAR(gradient_noise({3.14, 42, 7}).value, 0.136919959, 1e-9);
}

TEST(noise, is_zero_at_whole_coordinates) {
  EXPECT_EQ(gradient_noise({3, -4, 5}).value, 0);
  EXPECT_EQ(gradient_noise({-256, 0, 255}).value, 0);
}

TEST(noise, repeats_every_256) {
  EXPECT_EQ(gradient_noise({1.25, 2.5, 3.75}).value,
            gradient_noise({1.25 - 256, 2.5 + 256, 3.75 - 512}).value);
}

TEST(noise, gradient_is_the_slope_of_the_value) {
  constexpr double step = 1e-5;
  for (int i = 0; i < 500; ++i) {
    const blysk::Vec3d p{i * 0.37 - 90, i * 0.113 - 20, 50 - i * 0.291};
    const blysk::Vec3d g = gradient_noise(p).gradient;
    const auto slope = [&](blysk::Vec3d d) {
      return (gradient_noise(p + d).value - gradient_noise(p - d).value) / (2 * step);
    };
    EXPECT_NEAR(g.x, slope({step, 0, 0}), 1e-6);
    EXPECT_NEAR(g.y, slope({0, step, 0}), 1e-6);
    EXPECT_NEAR(g.z, slope({0, 0, step}), 1e-6);
  }
}

}  // namespace
