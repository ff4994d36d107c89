#include "scene/first_equals.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <tuple>

namespace blysk {
namespace {

Array<std::uint32_t> firsts(const Array<Vec3f>& points, int threads = 1) {
  ThreadPool pool(threads);
  return first_equals(points, pool);
}

TEST(first_equals, nothing_where_all_differ) {
  EXPECT_TRUE(firsts({}).empty());
  EXPECT_TRUE(firsts({{1, 0, 0}}).empty());
  Array<Vec3f> points;
  for (int i = 0; i < 5000; ++i)
    points.push_back({static_cast<float>(i % 70), static_cast<float>(i / 70), 3});
  EXPECT_TRUE(firsts(points).empty());
}

TEST(first_equals, zero_has_no_sign_and_nan_equals_itself) {
  const float nan = std::nanf("");
  EXPECT_EQ(firsts({{0, 1, -0.0f}, {nan, 0, 0}, {-0.0f, 1, 0}, {nan, -0.0f, 0}, {0, 1, 0}}),
            (Array<std::uint32_t>{0, 1, 0, 1, 0}));
}

// Few equal points among many, and almost nothing but equal ones, held to a map.
TEST(first_equals, any_share_of_equals_and_any_number_of_threads) {
  std::mt19937 random(3);
  for (const unsigned side : {12u, 700u}) {
    Array<Vec3f> points(250'000);
    for (Vec3f& p : points) {
      p = {static_cast<float>(random() % side), static_cast<float>(random() % side),
           static_cast<float>(random() % side)};
    }
    std::map<std::tuple<float, float, float>, std::uint32_t> seen;
    Array<std::uint32_t> expected;
    for (const Vec3f& p : points) {
      expected.push_back(
          seen.try_emplace({p.x, p.y, p.z}, static_cast<std::uint32_t>(expected.size())).first->second);
    }
    ASSERT_LT(seen.size(), points.size());
    for (const int threads : {1, 2, 7}) EXPECT_EQ(firsts(points, threads), expected) << side;
  }
}

}  // namespace
}  // namespace blysk
