#include "scene/weld.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <random>
#include <vector>

namespace blysk {
namespace {

WeldedIds weld_all(const Array<Vec3f>& points, int threads) {
  ThreadPool pool(threads);
  return weld_ids(points, pool);
}

TEST(weld, first_appearance_numbers) {
  const WeldedIds w = weld_all({{1, 0, 0}, {0, 0, 0}, {1, -0.0f, 0}, {2, 0, 0}, {-0.0f, 0, 0}}, 1);
  EXPECT_EQ(w.ids, (Array<std::uint32_t>{0, 1, 0, 2, 1}));
  EXPECT_EQ(w.count, 3u);
}

TEST(weld, nothing) {
  const WeldedIds w = weld_all({}, 2);
  EXPECT_TRUE(w.ids.empty() && w.count == 0);
}

TEST(weld, nan_equals_itself) {
  const float nan = std::nanf("");
  EXPECT_EQ(weld_all({{nan, 0, 0}, {nan, 0, 0}, {0, nan, 0}}, 1).ids, (Array<std::uint32_t>{0, 0, 1}));
}

TEST(weld, threads_leave_no_trace) {
  std::mt19937 random(5);
  Array<Vec3f> points(400'000);
  for (Vec3f& p : points) {
    p = {static_cast<float>(random() % 50), static_cast<float>(random() % 50),
         static_cast<float>(random() % 50)};
  }
  const WeldedIds one = weld_all(points, 1);
  for (const int threads : {2, 3, 7}) EXPECT_EQ(one.ids, weld_all(points, threads).ids);
  std::vector<Vec3f> first(one.count);
  std::size_t known = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    ASSERT_LE(one.ids[i], known);
    if (one.ids[i] == known) first[known++] = points[i];
    ASSERT_EQ(first[one.ids[i]], points[i]);
  }
}

// Undoes the hash of weld.cpp for points with y = 0, to make points that all collide.
TEST(weld, points_built_to_collide) {
  const auto hash = [](float x, float z) {
    const std::uint64_t xy = std::bit_cast<std::uint32_t>(x);
    std::uint64_t h = (xy ^ (xy >> 29)) * 0x9e3779b97f4a7c15u;
    h = (h ^ (h >> 32) ^ std::bit_cast<std::uint32_t>(z)) * 0xd6e8feb86659fd93u;
    return static_cast<std::uint32_t>(h >> 32);
  };
  Array<Vec3f> points;
  for (std::uint32_t x = 0; points.size() < 1200; ++x) {
    for (std::uint32_t z = 0; z < 4096 && points.size() < 1200; ++z) {
      const Vec3f p{std::bit_cast<float>(0x3f800000u + x), 0, std::bit_cast<float>(0x3f800000u + z)};
      if ((hash(p.x, p.z) & 0x1fff) == 0) points.push_back(p);
    }
  }
  const std::size_t distinct = points.size();
  for (std::size_t i = 0; i < distinct; ++i) points.push_back(points[i]);
  const WeldedIds w = weld_all(points, 1);
  ASSERT_EQ(w.count, distinct);
  for (std::size_t i = 0; i < points.size(); ++i) ASSERT_EQ(w.ids[i], i % distinct);
}

}  // namespace
}  // namespace blysk
