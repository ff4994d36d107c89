#include "io/polygon.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "math/trig.h"

namespace blysk::io {
namespace {

double area_of(std::span<const Vec3f> p, const Array<std::uint32_t>& indices) {
  double sum = 0;
  for (std::size_t i = 0; i < indices.size(); i += 3) {
    const Vec3d a = to_double(p[indices[i]]), b = to_double(p[indices[i + 1]]),
                c = to_double(p[indices[i + 2]]);
    sum += length(cross(b - a, c - a)) / 2;
  }
  return sum;
}

// Area of the polygon itself; the triangles cover it and nothing else if theirs, all taken positive, is the
// same.
double shoelace(std::span<const Vec3f> p) {
  Vec3d sum;
  for (std::size_t i = 0; i < p.size(); ++i)
    sum = sum + cross(to_double(p[i]), to_double(p[(i + 1) % p.size()]));
  return length(sum) / 2;
}

void expect_covered(const std::vector<Vec3f>& p) {
  Array<std::uint32_t> indices;
  triangulate(p, indices);
  ASSERT_EQ(indices.size(), 3 * (p.size() - 2));
  EXPECT_NEAR(area_of(p, indices), shoelace(p), 1e-4 * shoelace(p));
}

TEST(triangulate, convex_polygons_are_fans) {
  const std::vector<Vec3f> p = {{0, 0, 0}, {1, 0, 0}, {1.5f, 1, 0}, {0.5f, 2, 0}, {-0.5f, 1, 0}};
  Array<std::uint32_t> indices;
  triangulate(p, indices);
  EXPECT_EQ(indices, (Array<std::uint32_t>{0, 1, 2, 0, 2, 3, 0, 3, 4}));
}

TEST(triangulate, too_few_corners) {
  Array<std::uint32_t> indices;
  triangulate(std::vector<Vec3f>{{0, 0, 0}, {1, 0, 0}}, indices);
  EXPECT_TRUE(indices.empty());
}

TEST(triangulate, an_arrow_from_every_corner_in_every_plane) {
  const std::vector<Vec2f> arrow = {{0, 0}, {4, 0}, {4, 4}, {3, 1}};
  for (int plane = 0; plane < 6; ++plane) {
    for (std::size_t first = 0; first < 4; ++first) {
      std::vector<Vec3f> p;
      for (std::size_t i = 0; i < 4; ++i) {
        const Vec2f c = arrow[(first + i) % 4];
        const float u = plane < 3 ? c.x : c.y, v = plane < 3 ? c.y : c.x;
        p.push_back(plane % 3 == 0 ? Vec3f{u, v, 7} : plane % 3 == 1 ? Vec3f{7, u, v} : Vec3f{u, 7, v});
      }
      expect_covered(p);
    }
  }
}

TEST(triangulate, winding_is_kept) {
  const std::vector<Vec3f> p = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {3, 1, 0}, {2, 1, 0}, {1, 4, 0}};
  Array<std::uint32_t> indices;
  triangulate(p, indices);
  for (std::size_t i = 0; i < indices.size(); i += 3) {
    const Vec3f n = cross(p[indices[i + 1]] - p[indices[i]], p[indices[i + 2]] - p[indices[i]]);
    EXPECT_GE(n.z, 0) << i;
  }
}

TEST(triangulate, stars_and_combs) {
  for (const int points : {5, 12, 100, 1000}) {
    std::vector<Vec3f> star, comb;
    for (int i = 0; i < 2 * points; ++i) {
      const double a = kPi * i / points, r = i % 2 == 0 ? 10 : 3;
      star.push_back(to_float({r * cosine(a), r * sine(a), r * cosine(a)}));
    }
    for (int i = 0; i < points; ++i) {
      comb.push_back({static_cast<float>(i), 0, 0});
      comb.push_back({static_cast<float>(i) + 0.5f, -5, 0});
    }
    comb.push_back({static_cast<float>(points), 1, 0});
    comb.push_back({-1, 1, 0});
    expect_covered(star);
    expect_covered(comb);
    for (Vec3f& q : comb) q = {-q.y, q.x, 0};
    expect_covered(comb);
  }
}

// Polygons that cross themselves, repeat points, lie on a line or are not finite: the count stays right.
TEST(triangulate, nonsense_ends) {
  std::minstd_rand random(7);
  for (int round = 0; round < 300; ++round) {
    std::vector<Vec3f> p(3 + random() % 40);
    for (Vec3f& q : p) q = {static_cast<float>(random() % 5), static_cast<float>(random() % 5), 0};
    if (round % 3 == 0) p[random() % p.size()].x = std::nanf("");
    if (round % 5 == 0) {
      for (Vec3f& q : p) q.y = 0;
    }
    Array<std::uint32_t> indices;
    triangulate(p, indices);
    ASSERT_EQ(indices.size(), 3 * (p.size() - 2));
    for (const std::uint32_t i : indices) ASSERT_LT(i, p.size());
  }
}

TEST(triangulate, a_hostile_polygon_does_not_take_long) {
  std::minstd_rand random(7);
  std::vector<Vec3f> p(kMostEarCorners);
  for (Vec3f& q : p) q = {static_cast<float>(random() % 100000), static_cast<float>(random() % 100000), 0};
  Array<std::uint32_t> indices;
  triangulate(p, indices);
  EXPECT_EQ(indices.size(), 3 * (p.size() - 2));
  p.resize(1'000'000);
  indices.clear();
  triangulate(p, indices);
  EXPECT_EQ(indices.size(), 3 * (p.size() - 2));
}

}  // namespace
}  // namespace blysk::io
