#include <gtest/gtest.h>

#include "blysk/shapes.h"
#include "scene/shapes_testing.h"

namespace {

using blysk::make_shape;
using blysk::Mesh;

Mesh teapot(int detail) { return make_shape("teapot?detail=" + std::to_string(detail))->meshes[0]; }

TEST(teapot, has_32_patches_without_the_flat_halves_at_the_poles) {
  for (const std::size_t d : {1u, 2u, 8u, 31u}) {
    EXPECT_EQ(teapot(static_cast<int>(d)).triangles(), 64 * d * d - 8 * d);
  }
}

// Patches meet without gaps; only the rims of body and lid and the ends of handle and spout are open. By the
// published numbers one point of the handle's lower end lies on the body.
TEST(teapot, is_watertight_but_for_its_known_rims) {
  for (const std::size_t d : {2u, 3u, 8u, 21u}) {
    const blysk::shape::Topology t = blysk::shape::topology(teapot(static_cast<int>(d)));
    EXPECT_EQ(t.bad_edges, 0u);
    EXPECT_EQ(t.border_edges, 4 * d + 4 * d + 2 * 2 * d + 2 * 2 * d);
    EXPECT_EQ(t.euler(), 1 + 1 + 0 + 0 - 1);  // two bowls, two tubes, the common point
  }
}

// Measured on a widely used mesh of the same patches with 10 segments a side: 4 * 13.1651984.
TEST(teapot, has_the_published_proportions) {
  const Mesh mesh = teapot(10);
  blysk::Bounds b;
  for (const blysk::Vec3f& p : mesh.positions) b.add(blysk::to_double(p));
  EXPECT_NEAR(b.lo.x, -3.0 / 2, 1e-6);
  EXPECT_NEAR(b.hi.x, 3.434 / 2, 1e-6);
  EXPECT_NEAR(b.lo.y, -3.15 / 4, 1e-6);
  EXPECT_NEAR(b.hi.y, 3.15 / 4, 1e-6);
  EXPECT_NEAR(b.lo.z, -1, 1e-6);
  EXPECT_NEAR(b.hi.z, 1, 1e-6);
  EXPECT_NEAR(blysk::shape::area(mesh), 52.660793 / 4, 1e-5);
}

TEST(teapot, normals_at_the_poles_are_upright) {
  const Mesh mesh = teapot(8);
  int poles = 0;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const blysk::Vec3f p = mesh.positions[i], n = mesh.normals[i];
    if (p.x != 0 || p.z != 0) continue;
    ++poles;
    EXPECT_EQ(n.y, p.y > 0 ? 1.0f : -1.0f);
    EXPECT_EQ(n.x, 0);
    EXPECT_EQ(n.z, 0);
  }
  EXPECT_EQ(poles, 2 * 32);
}

// Welded vertices have one normal: parts are smooth all over, patch borders and seams included.
TEST(teapot, is_smooth_across_patches) {
  std::map<std::tuple<float, float, float>, blysk::Vec3f> normals;
  const Mesh mesh = teapot(6);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const blysk::Vec3f p = mesh.positions[i], n = mesh.normals[i];
    if (p == blysk::Vec3f{-1, -0.3375f, 0}) continue;  // where the handle touches the body
    const blysk::Vec3f first = normals.try_emplace({p.x, p.y, p.z}, n).first->second;
    EXPECT_GT(blysk::dot(n, first), 0.99999f);
  }
}

// Where two patches of a part meet, their tangent planes are the same.
TEST(teapot, normals_do_not_jump_along_a_fine_mesh) {
  const Mesh mesh = teapot(64);
  double worst = 1;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const auto normal = [&](std::size_t k) { return blysk::to_double(mesh.normals[mesh.indices[i + k]]); };
    worst =
        std::min({worst, dot(normal(0), normal(1)), dot(normal(1), normal(2)), dot(normal(2), normal(0))});
  }
  EXPECT_GT(worst, 0.9);
}

}  // namespace
