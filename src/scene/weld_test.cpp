#include "scene/weld.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <random>
#include <vector>

namespace blysk {
namespace {

Welded weld_all(const std::vector<Vec3f>& points, int threads) {
  ThreadPool pool(threads);
  return weld({reinterpret_cast<const std::byte*>(points.data()), points.size()}, pool);
}

TEST(weld, first_appearance_numbers) {
  const Welded w = weld_all({{1, 0, 0}, {0, 0, 0}, {1, -0.0f, 0}, {2, 0, 0}, {-0.0f, 0, 0}}, 1);
  EXPECT_EQ(w.ids, (Array<std::uint32_t>{0, 1, 0, 2, 1}));
  EXPECT_EQ(w.positions, (Array<Vec3f>{{1, 0, 0}, {0, 0, 0}, {2, 0, 0}}));
  EXPECT_FALSE(std::signbit(w.positions[1].x));
}

TEST(weld, nothing) {
  const Welded w = weld_all({}, 2);
  EXPECT_TRUE(w.ids.empty() && w.positions.empty());
}

TEST(weld, nan_equals_itself) {
  const float nan = std::nanf("");
  EXPECT_EQ(weld_all({{nan, 0, 0}, {nan, 0, 0}, {0, nan, 0}}, 1).ids, (Array<std::uint32_t>{0, 0, 1}));
}

TEST(weld, groups_with_strides) {
  std::vector<std::byte> bytes(2 * 30 + 1);
  const auto put = [&](std::size_t at, Vec3f p) { std::memcpy(&bytes[at], &p, sizeof p); };
  put(1, {1, 2, 3});
  put(13, {4, 5, 6});
  put(31, {4, 5, 6});
  put(43, {7, 8, 9});
  ThreadPool pool(1);
  EXPECT_EQ(weld({&bytes[1], 2, 2, 30}, pool).ids, (Array<std::uint32_t>{0, 1, 1, 2}));
}

TEST(weld, threads_leave_no_trace) {
  std::mt19937 random(5);
  std::vector<Vec3f> points(400'000);
  for (Vec3f& p : points) {
    p = {static_cast<float>(random() % 50), static_cast<float>(random() % 50),
         static_cast<float>(random() % 50)};
  }
  const Welded one = weld_all(points, 1);
  for (const int threads : {2, 3, 7}) {
    const Welded many = weld_all(points, threads);
    EXPECT_EQ(one.ids, many.ids);
    EXPECT_EQ(one.positions, many.positions);
  }
  for (std::size_t i = 0; i < points.size(); ++i) ASSERT_EQ(one.positions[one.ids[i]], points[i]);
}

// Undoes the hash of weld.cpp for points with y = 0, to make points that all collide.
TEST(weld, points_built_to_collide) {
  const auto hash = [](float x, float z) {
    const std::uint64_t xy = std::bit_cast<std::uint32_t>(x);
    std::uint64_t h = (xy ^ (xy >> 29)) * 0x9e3779b97f4a7c15u;
    h = (h ^ (h >> 32) ^ std::bit_cast<std::uint32_t>(z)) * 0xd6e8feb86659fd93u;
    return static_cast<std::uint32_t>(h >> 32);
  };
  std::vector<Vec3f> points;
  for (std::uint32_t x = 0; points.size() < 1200; ++x) {
    for (std::uint32_t z = 0; z < 4096 && points.size() < 1200; ++z) {
      const Vec3f p{std::bit_cast<float>(0x3f800000u + x), 0, std::bit_cast<float>(0x3f800000u + z)};
      if ((hash(p.x, p.z) & 0x1fff) == 0) points.push_back(p);
    }
  }
  const std::size_t distinct = points.size();
  for (std::size_t i = 0; i < distinct; ++i) points.push_back(points[i]);
  const Welded w = weld_all(points, 1);
  ASSERT_EQ(w.positions.size(), distinct);
  for (std::size_t i = 0; i < points.size(); ++i) ASSERT_EQ(w.ids[i], i % distinct);
}

}  // namespace
}  // namespace blysk
