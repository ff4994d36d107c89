#include "scene/normals.h"

#include <gtest/gtest.h>

#include <cmath>

#include "math/trig.h"

namespace blysk {
namespace {

// A strip of quads along a polyline in the x-y plane, one unit deep in z.
Mesh strip(std::initializer_list<Vec2f> line) {
  Mesh mesh;
  for (const Vec2f& p : line) {
    mesh.positions.push_back({p.x, p.y, 0});
    mesh.positions.push_back({p.x, p.y, 1});
  }
  for (std::uint32_t i = 0; i + 2 < mesh.positions.size(); i += 2) {
    mesh.indices.insert(mesh.indices.end(), {i, i + 1, i + 2, i + 2, i + 1, i + 3});
  }
  return mesh;
}

// Two walls that meet at an angle.
Mesh bend(double degrees) {
  const double a = radians(degrees);
  return strip({{-1, 0}, {0, 0}, {static_cast<float>(cosine(a)), static_cast<float>(sine(a))}});
}

void expect_near(Vec3f a, Vec3f b) { EXPECT_LT(length(a - b), 1e-6f) << a.x << " " << a.y << " " << a.z; }

TEST(make_normals, flat_is_exact) {
  Mesh mesh = strip({{0, 0}, {1, 0}, {5, 0}});
  make_normals(mesh, 60);
  for (const Vec3f& n : mesh.normals) EXPECT_EQ(n, (Vec3f{0, 1, 0}));
  EXPECT_EQ(mesh.positions.size(), 6u);
}

TEST(make_normals, below_the_crease_is_smooth) {
  Mesh mesh = bend(50);
  make_normals(mesh, 60);
  ASSERT_EQ(mesh.positions.size(), 6u);
  const double a = radians(50);
  // The fold has two triangles of one wall and one of the other at either end.
  const Vec3d left{0, 1, 0}, right{-sine(a), cosine(a), 0};
  expect_near(mesh.normals[2], to_float(normalize(left + left + right)));
  expect_near(mesh.normals[3], to_float(normalize(left + right + right)));
  expect_near(mesh.normals[0], {0, 1, 0});
}

TEST(make_normals, beyond_the_crease_is_hard_and_attributes_follow) {
  Mesh mesh = bend(70);
  for (std::size_t i = 0; i < 6; ++i) {
    const auto f = static_cast<float>(i);
    mesh.colors.push_back({f, 0, 0, 1});
    mesh.texcoords.push_back({f, 1});
    mesh.texcoords1.push_back({f, 2});
    mesh.tangents.push_back({f, 0, 0, 1});
  }
  const Mesh before = mesh;
  make_normals(mesh, 60);
  ASSERT_EQ(mesh.positions.size(), 8u);
  ASSERT_EQ(mesh.normals.size(), 8u);
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
    const std::uint32_t now = mesh.indices[i], then = before.indices[i];
    EXPECT_EQ(mesh.positions[now], before.positions[then]);
    EXPECT_EQ(mesh.colors[now], before.colors[then]);
    EXPECT_EQ(mesh.texcoords[now], before.texcoords[then]);
    EXPECT_EQ(mesh.texcoords1[now], before.texcoords1[then]);
    EXPECT_EQ(mesh.tangents[now], before.tangents[then]);
    const double a = i < 6 ? 0 : radians(70);
    expect_near(mesh.normals[now], to_float({-sine(a), cosine(a), 0}));
  }
}

TEST(make_normals, larger_faces_weigh_more) {
  Mesh mesh = strip({{-3, 0}, {0, 0}, {0, 1}});
  make_normals(mesh, 180);
  expect_near(mesh.normals[2], normalize(Vec3f{-1, 6, 0}));
  expect_near(mesh.normals[3], normalize(Vec3f{-2, 3, 0}));
}

TEST(make_normals, the_ends_of_the_range) {
  Mesh mesh = bend(170);
  make_normals(mesh, 180);
  EXPECT_EQ(mesh.positions.size(), 6u);
  EXPECT_EQ(mesh.normals.size(), 6u);
  make_normals(mesh, 0);
  EXPECT_TRUE(mesh.normals.empty());
  EXPECT_EQ(mesh.positions.size(), 6u);
}

TEST(make_normals, a_seam_in_the_texture_is_no_edge) {
  Mesh whole = bend(40);
  Mesh seam = whole;
  // The second wall gets vertices of its own where the first ends.
  seam.positions.push_back(seam.positions[2]);
  seam.positions.push_back(seam.positions[3]);
  for (std::size_t i = 6; i < seam.indices.size(); ++i) {
    if (seam.indices[i] == 2 || seam.indices[i] == 3) seam.indices[i] += 4;
  }
  make_normals(whole, 60);
  make_normals(seam, 60);
  ASSERT_EQ(seam.positions.size(), 8u);
  EXPECT_EQ(seam.normals[2], whole.normals[2]);
  EXPECT_EQ(seam.normals[6], whole.normals[2]);
  EXPECT_EQ(seam.normals[7], whole.normals[3]);
}

TEST(make_normals, sheets_back_to_back_keep_their_sides) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.indices = {0, 1, 2, 0, 2, 1};
  make_normals(mesh, 60);
  ASSERT_EQ(mesh.positions.size(), 6u);
  for (std::size_t i = 0; i < 6; ++i)
    EXPECT_EQ(mesh.normals[mesh.indices[i]], (Vec3f{0, 0, i < 3 ? 1.0f : -1.0f}));
}

// Areas of areas of such triangles neither overflow nor vanish.
TEST(make_normals, any_size) {
  for (const float size : {1e-30f, 1e-12f, 1e12f, 1e30f, 3e38f}) {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {size, 0, 0}, {size, size, 0}, {0, size, 0}, {size, size, size}};
    mesh.indices = {0, 1, 2, 0, 2, 3, 1, 4, 2};
    make_normals(mesh, 60);
    expect_near(mesh.normals[0], {0, 0, 1});
    EXPECT_EQ(mesh.positions.size(), 7u) << size;
    for (const Vec3f& n : mesh.normals) EXPECT_NEAR(length(n), 1.0f, 1e-5f) << size;
  }
}

TEST(make_normals, threads_leave_no_trace) {
  Mesh mesh;
  constexpr std::uint32_t kSide = 400;
  for (std::uint32_t y = 0; y < kSide; ++y) {
    for (std::uint32_t x = 0; x < kSide; ++x) {
      mesh.positions.push_back({static_cast<float>(x), static_cast<float>(y),
                                static_cast<float>((x * 31 + y * y * 17) % 13) * 0.2f});
    }
  }
  for (std::uint32_t i = 0; i + kSide + 1 < kSide * kSide; ++i) {
    if (i % kSide != kSide - 1)
      mesh.indices.insert(mesh.indices.end(), {i, i + 1, i + kSide, i + 1, i + kSide + 1, i + kSide});
  }
  Mesh one = mesh;
  ThreadPool single(1);
  make_normals(one, 60, single);
  EXPECT_GT(one.positions.size(), mesh.positions.size());
  for (const int threads : {2, 3, 7}) {
    Mesh many = mesh;
    ThreadPool pool(threads);
    make_normals(many, 60, pool);
    EXPECT_EQ(many.normals, one.normals);
    EXPECT_EQ(many.indices, one.indices);
  }
}

// A place with very many faces, all apart: each keeps its own normal, in time that is not squared.
TEST(make_normals, a_hostile_hub) {
  Mesh mesh;
  mesh.positions.push_back({0, 0, 0});
  constexpr std::uint32_t kFaces = 100'000;
  for (std::uint32_t i = 0; i < kFaces; ++i) {
    const auto f = static_cast<float>(i);
    mesh.positions.push_back({1, f, static_cast<float>(i % 7)});
    mesh.positions.push_back({f, static_cast<float>(i % 5), 1});
    mesh.indices.insert(mesh.indices.end(), {0, 2 * i + 1, 2 * i + 2});
  }
  make_normals(mesh, 20);
  for (const std::uint32_t i : mesh.indices) ASSERT_LT(i, mesh.positions.size());
  for (const Vec3f& n : mesh.normals) ASSERT_NEAR(length(n), 1.0f, 1e-5f);
}

TEST(mend_normals, lengths_and_gaps) {
  Mesh mesh = strip({{0, 0}, {1, 0}});
  mesh.normals = {{0, 2, 0}, {0, 0, 0}, {std::nanf(""), 1, 0}, {0.6f, 0.8f, 0}};
  mend_normals(mesh);
  EXPECT_EQ(mesh.normals, (Array<Vec3f>{{0, 1, 0}, {0, 1, 0}, {0, 1, 0}, {0.6f, 0.8f, 0}}));
}

}  // namespace
}  // namespace blysk
