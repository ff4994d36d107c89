// Shapes that promise more than a sound mesh: the thesis' spheres, the terrain, the fighter, loose triangles.
#include <gtest/gtest.h>

#include <set>

#include "blysk/shapes.h"
#include "math/trig.h"
#include "scene/shapes_testing.h"

namespace {

using blysk::make_shape;
using blysk::Mesh;
using blysk::Scene;
using blysk::Vec3f;

TEST(spheres, are_those_of_the_specification) {
  constexpr int kRez = 7;
  const Scene scene = *make_shape("spheres?detail=7");
  const Mesh& mesh = scene.meshes[0];
  std::set<std::tuple<long, long, long>> made;
  const auto key = [](double x, double y, double z) {
    return std::tuple{std::lround(x * 1e5), std::lround(y * 1e5), std::lround(z * 1e5)};
  };
  for (const Vec3f& p : mesh.positions) made.insert(key(double{p.x}, double{p.y}, double{p.z}));
  EXPECT_EQ(made.size(), kRez * (kRez - 1) + 2u);
  for (int s = 0; s < kRez; ++s) {
    for (int t = 0; t <= kRez; ++t) {
      const double a = 2 * blysk::kPi * s / kRez, b = blysk::kPi * t / kRez;
      EXPECT_TRUE(made.contains(
          key(blysk::sine(a) * blysk::sine(b), blysk::cosine(a) * blysk::sine(b), blysk::cosine(b))));
    }
  }
  EXPECT_EQ(scene.instances.size(), 2u);
  const blysk::Bounds b = make_shape("spheres")->bounds();
  EXPECT_NEAR(b.lo.x, -3, 0.003);  // 50 slices have no vertex at +-X
  EXPECT_NEAR(b.hi.x, 3, 0.003);
}

// Each cell is cut from P(s,t) to P(s+1,t+1).
TEST(spheres, have_the_specified_diagonals) {
  const Mesh mesh = make_shape("spheres?detail=50")->meshes[0];
  std::set<std::pair<std::tuple<float, float, float>, std::tuple<float, float, float>>> edges;
  const auto key = [](Vec3f p) { return std::tuple{p.x, p.y, p.z}; };
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    for (std::size_t k = 0; k < 3; ++k) {
      edges.insert(
          {key(mesh.positions[mesh.indices[i + k]]), key(mesh.positions[mesh.indices[i + (k + 1) % 3]])});
    }
  }
  // Row t of a latitude-longitude mesh begins after the pole's 50 vertices and t - 1 rows of 51.
  const auto at = [&](std::size_t s, std::size_t t) { return key(mesh.positions[50 + (t - 1) * 51 + s]); };
  EXPECT_GT(std::get<1>(at(0, 1)), 0);  // slices begin at +Y and turn to +X
  EXPECT_GT(std::get<0>(at(1, 1)), 0);
  for (std::size_t t = 1; t <= 48; ++t) {
    EXPECT_TRUE(edges.contains({at(0, t), at(1, t + 1)}));
    EXPECT_FALSE(edges.contains({at(1, t), at(0, t + 1)}));
  }
}

TEST(spheres, bring_camera_light_and_material) {
  const Scene scene = *make_shape("spheres");
  ASSERT_EQ(scene.cameras.size(), 1u);
  EXPECT_EQ(scene.cameras[0].eye, (blysk::Vec3d{0, 1, 4}));
  EXPECT_EQ(scene.cameras[0].fov_deg, 45);
  ASSERT_EQ(scene.lights.size(), 1u);
  EXPECT_NEAR(length(scene.lights[0].vector), 1, 1e-15);
  EXPECT_EQ(scene.materials[0].shininess, 50);
  EXPECT_FLOAT_EQ(scene.materials[0].color.y, 77.0f / 255);
}

TEST(sphere, and_icosphere_tend_to_the_ball) {
  for (const char* text : {"sphere?detail=200", "icosphere?detail=60"}) {
    const Mesh mesh = make_shape(text)->meshes[0];
    EXPECT_NEAR(blysk::shape::area(mesh), 4 * blysk::kPi, 0.005) << text;
    EXPECT_NEAR(blysk::shape::volume(mesh), 4 * blysk::kPi / 3, 0.005) << text;
    for (const Vec3f& p : mesh.positions) ASSERT_NEAR(blysk::length(p), 1, 1e-6f);
  }
}

TEST(torus, has_the_volume_of_its_ratio) {
  const double ring = 1 / 1.4, tube = 0.4 / 1.4;
  EXPECT_NEAR(blysk::shape::volume(make_shape("torus?detail=400")->meshes[0]),
              2 * blysk::kPi * blysk::kPi * ring * tube * tube, 1e-3);
}

TEST(terrain, seeds_and_height_change_it) {
  const auto hash = [](const char* text) { return blysk::shape::hash(*make_shape(text)); };
  EXPECT_NE(hash("terrain"), hash("terrain?seed=2"));
  EXPECT_EQ(hash("terrain"), hash("terrain?seed=1"));
  EXPECT_NE(hash("terrain?seed=4294967295"), hash("terrain?seed=4294967294"));
  EXPECT_EQ(make_shape("terrain?height=0")->bounds().hi.y, 0);
  EXPECT_GT(make_shape("terrain")->bounds().hi.y, 0.1);
  EXPECT_LT(make_shape("terrain?height=1&seed=5")->bounds().hi.y, 1.04);
}

// On a fine mesh the exact normals are those of the triangles.
TEST(terrain, normals_are_the_slopes) {
  const Mesh mesh = make_shape("terrain?detail=800&octaves=2")->meshes[0];
  EXPECT_GT(blysk::shape::worst_normal(mesh), 0.999);
}

TEST(xfighter, is_closed_in_every_part_and_thin) {
  const Scene scene = *make_shape("xfighter");
  EXPECT_GE(scene.triangles(), 500u);
  EXPECT_LE(scene.triangles(), 2000u);
  EXPECT_EQ(scene.meshes.size(), scene.materials.size());
  for (const Mesh& mesh : scene.meshes) {
    EXPECT_TRUE(blysk::shape::topology(mesh).closed()) << mesh.name;
    EXPECT_GT(blysk::shape::volume(mesh), 0) << mesh.name;
    EXPECT_EQ(blysk::shape::topology(mesh).euler() % 2, 0) << mesh.name;
  }
  const blysk::Bounds b = scene.bounds();
  EXPECT_NEAR(b.hi.z - b.lo.z, 9.1, 0.1);
}

TEST(xfighter, has_a_canopy_of_glass) {
  const Scene scene = *make_shape("xfighter");
  const auto glass =
      std::find_if(scene.materials.begin(), scene.materials.end(),
                   [](const blysk::Material& m) { return m.alpha_mode == blysk::AlphaMode::blend; });
  ASSERT_NE(glass, scene.materials.end());
  EXPECT_EQ(glass->opacity, 0.5f);
  EXPECT_EQ(glass->name, "glass");
}

TEST(triangles, stay_in_their_cube) {
  for (const char* text : {"triangles", "triangles?size=2", "triangles?size=0.0001&count=5000",
                           "triangles?count=3000&layers=7&intersecting=0&size=1.5"}) {
    const blysk::Bounds b = make_shape(text)->bounds();
    EXPECT_TRUE(b.lo.x >= -1 && b.lo.y >= -1 && b.lo.z >= -1) << text;
    EXPECT_TRUE(b.hi.x <= 1 && b.hi.y <= 1 && b.hi.z <= 1) << text;
  }
}

TEST(triangles, parallel_ones_have_depths_of_their_own_in_layers) {
  const Mesh mesh = make_shape("triangles?count=1003&layers=10&intersecting=0&seed=3")->meshes[0];
  std::map<float, int> depths;
  std::set<int> layers;
  for (std::size_t i = 0; i < mesh.positions.size(); i += 3) {
    const float z = mesh.positions[i].z;
    EXPECT_EQ(z, mesh.positions[i + 1].z);
    EXPECT_EQ(z, mesh.positions[i + 2].z);
    ++depths[z];
    const double place = (double{z} + 1) * 5, inside = place - std::floor(place);
    EXPECT_TRUE(inside >= 0.25 && inside <= 0.75) << z;
    layers.insert(static_cast<int>(place));
  }
  EXPECT_EQ(depths.size(), 1003u);
  EXPECT_EQ(layers.size(), 10u);
}

TEST(triangles, face_the_camera) {
  for (const char* text :
       {"triangles", "triangles?intersecting=0&layers=5", "triangles?intersecting=0&layers=10000"}) {
    const Mesh mesh = make_shape(text)->meshes[0];
    for (std::size_t i = 0; i < mesh.positions.size(); i += 3) {
      const Vec3f a = mesh.positions[i], b = mesh.positions[i + 1], c = mesh.positions[i + 2];
      ASSERT_GT(cross(b - a, c - a).z, 0);
    }
  }
}

// 128 pixels of the picture they are made for; depths 0 to 1 are z from 1 to -1, steep slopes go beyond.
TEST(screen_scenes, stand_in_their_picture) {
  for (const char* text :
       {"soup?layers=3", "micro?layers=3", "meshes?triangles=2000&objects=3", "grass", "fans"}) {
    const Scene scene = *make_shape(text);
    ASSERT_EQ(scene.cameras.size(), 1u) << text;
    EXPECT_EQ(scene.cameras[0].height, 2) << text;
    EXPECT_TRUE(scene.materials[0].unlit) << text;
    const blysk::Bounds b = scene.bounds();
    EXPECT_TRUE(b.lo.x < -0.4 && b.hi.x > 0.4 && b.lo.y < -0.4 && b.hi.y > 0.4) << text;
    EXPECT_TRUE(b.lo.z > -3 && b.hi.z < 3) << text;
  }
}

TEST(screen_scenes, layers_are_as_many_as_asked_for) {
  const Mesh mesh = make_shape("soup?layers=4&size=10")->meshes[0];
  double area = 0;  // in pixels: the picture is 2 wide and 128 pixels
  for (std::size_t i = 0; i < mesh.positions.size(); i += 3) {
    const Vec3f u = mesh.positions[i + 1] - mesh.positions[i], v = mesh.positions[i + 2] - mesh.positions[i];
    area += (double{u.x} * double{v.y} - double{u.y} * double{v.x}) / 2 * 64 * 64;
  }
  EXPECT_NEAR(area / (148 * 148), 4, 0.01);
}

}  // namespace
