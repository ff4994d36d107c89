// Layers of surfaces, opaque and transparent, whatever the antialiasing: against brute force at every sample.
#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>

#include "blysk/model.h"
#include "blysk/shapes.h"
#include "render/brute_force.h"
#include "render/testing.h"

namespace blysk {
namespace {

RenderOptions flat_options(int width, int height) {
  RenderOptions o;
  o.width = width;
  o.height = height;
  o.cull = Cull::none;
  o.transfer = Transfer::none;
  o.background = {0.25f, 0.5f, 0.125f, 1};
  return o;
}

Material flat_material(Vec3f color, float opacity) {
  Material m;
  m.color = color;
  m.unlit = true;
  m.opacity = opacity;
  m.alpha_mode = opacity < 1 ? AlphaMode::blend : AlphaMode::opaque;
  return m;
}

struct Agreement {
  long pixels = 0, clear = 0;  ///< clear: rounding decides nothing there
};

// Half a code is what rounding to bytes takes.
void expect_brute_force(const Scene& scene, RenderOptions o, const std::vector<std::string>& variants,
                        Agreement& agreement) {
  FramePlan plan;
  o.antialias = variants.front();
  ASSERT_TRUE(plan_frame(scene, o, plan));
  const Vec3d background = {double{o.background.x}, double{o.background.y}, double{o.background.z}};
  const auto expected =
      reference::BruteForce{o.width, o.height, plan.subpixels, background}.draw(reference::flat_layers(plan));
  for (const std::string& variant : variants) {
    o.antialias = variant;
    const Frame frame = render_frame(scene, o, Isa::best, 2);
    ASSERT_EQ(frame.statistics.layers_merged, 0u);
    for (std::size_t i = 0; i < expected.size(); ++i) {
      ++agreement.pixels;
      if (expected[i].doubtful) continue;
      ++agreement.clear;
      const std::uint32_t pixel = frame.image.pixels[i];
      const double wanted[] = {expected[i].color.x, expected[i].color.y, expected[i].color.z};
      for (int c = 0; c < 3; ++c) {
        ASSERT_NEAR((pixel >> 8 * c & 255) / 255.0, wanted[c], 0.6 / 255) << variant << ", pixel " << i;
      }
    }
  }
}

// Triangles that cover much of a picture, each of its own colour, every third mesh's opaque.
Scene random_layers(Random& random, const RenderOptions& o, int count) {
  constexpr float kOpacities[] = {1.0f, 0.3f, 0.6f};
  const bool glass = whole(random, 0, 1) == 1;
  Mesh meshes[3];
  for (int i = 0; i < count; ++i) {
    Mesh& mesh = meshes[glass ? i % 3 : 0];
    const Vec4f color = {random.unit(), random.unit(), random.unit(), 1};
    for (int k = 0; k < 3; ++k) {
      const auto at = [&](int size) { return static_cast<float>(uniform(random, -1.2, 1.2) * size); };
      const float x = at(o.width), y = at(o.height);
      mesh.indices.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
      mesh.positions.push_back({x, y, static_cast<float>(uniform(random, -0.99, 0.99))});
      mesh.colors.push_back(color);
    }
  }
  Scene scene;
  for (int i = 0; i < 3; ++i) {
    if (!meshes[i].indices.empty()) scene.add(std::move(meshes[i]), flat_material({1, 1, 1}, kOpacities[i]));
  }
  return scene;
}

void expect_random_scenes(int scenes, const std::vector<std::string>& variants) {
  RenderOptions o = flat_options(8, 6);
  o.camera = pixel_camera(o.height);
  Random random(71);
  Agreement agreement;
  for (int i = 0; i < scenes; ++i) {
    const Scene scene = random_layers(random, o, 1 + i % 60);
    SCOPED_TRACE(i);
    expect_brute_force(scene, o, variants, agreement);
    if (testing::Test::HasFatalFailure()) return;
  }
  EXPECT_GT(agreement.clear, agreement.pixels * 95 / 100);
}

TEST(layers, a_thousand_scenes_of_up_to_sixty) {
  expect_random_scenes(1000, {"abuffer", "abuffer-unlimited"});
}

TEST(layers, thirty_two_samples) {
  expect_random_scenes(120, {"abuffer:samples=32", "abuffer-unlimited:samples=32"});
}

TEST(layers, every_sub_pixel_counts) {
  expect_random_scenes(60, {"supersample:n=2"});
  expect_random_scenes(15, {"supersample:n=4"});
}

// Triangles of each mesh in another order.
Scene shuffled(Scene scene, std::uint64_t seed) {
  Random random(seed);
  for (Mesh& mesh : scene.meshes) {
    for (std::size_t i = mesh.triangles(); i > 1; --i) {
      const std::size_t k = random.next() % i;
      for (std::size_t c = 0; c < 3; ++c) std::swap(mesh.indices[3 * (i - 1) + c], mesh.indices[3 * k + c]);
    }
  }
  return scene;
}

void expect_brute_force_in_any_order(const Scene& scene, RenderOptions o) {
  const std::vector<std::string> variants = {"abuffer", "abuffer-unlimited"};
  Agreement agreement;
  expect_brute_force(scene, o, variants, agreement);
  EXPECT_GT(agreement.clear, agreement.pixels * 95 / 100);
  for (const std::string& variant : variants) {
    o.antialias = variant;
    const Frame given = render_frame(scene, o, Isa::best, 2);
    for (const std::uint64_t seed : {1u, 2u}) {
      const Frame other = render_frame(shuffled(scene, seed), o, Isa::best, 1);
      EXPECT_TRUE(given.image.pixels == other.image.pixels) << variant << ", seed " << seed;
    }
  }
}

Mat4 moved(double x, double scale) {
  Mat4 m;
  for (int i = 0; i < 3; ++i) m.m[i][i] = scale;
  m.m[0][3] = x;
  return m;
}

Scene glass_spheres(const std::vector<Mat4>& places) {
  Scene scene;
  constexpr Vec3f kColors[] = {{0.9f, 0.2f, 0.1f}, {0.1f, 0.8f, 0.3f}, {0.2f, 0.3f, 0.9f}};
  for (std::size_t i = 0; i < places.size(); ++i) {
    Scene sphere = *make_shape("icosphere?detail=3");
    scene.add(std::move(sphere.meshes[0]), flat_material(kColors[i % 3], 0.4f), places[i]);
  }
  return scene;
}

TEST(layers, nested_glass_spheres) {
  expect_brute_force_in_any_order(glass_spheres({moved(0, 1), moved(0, 0.8), moved(0, 0.5)}),
                                  flat_options(90, 70));
}

TEST(layers, intersecting_glass_spheres) {
  expect_brute_force_in_any_order(glass_spheres({moved(0, 1), moved(0.83, 0.9), moved(1.57, 0.7)}),
                                  flat_options(110, 70));
}

TEST(layers, sixty_four_leaves_in_one_plane) {
  Mesh mesh;
  for (std::uint32_t i = 0; i < 64; ++i) {
    for (const Vec3f corner :
         {Vec3f{-17.3f, -11.9f, 0.25f}, Vec3f{18.1f, -13.2f, 0.25f}, Vec3f{3.7f, 15.4f, 0.25f}})
      mesh.positions.push_back(corner);
    for (std::uint32_t k = 0; k < 3; ++k) mesh.indices.push_back(3 * i + k);
  }
  RenderOptions o = flat_options(40, 30);
  o.camera = pixel_camera(o.height);
  expect_brute_force_in_any_order(scene_of(std::move(mesh), flat_material({0.9f, 0.7f, 0.1f}, 0.03f)), o);
}

TEST(layers, the_alpha_test_of_gltf) {
  const std::filesystem::path models = BLYSK_MODELS;
  if (models.empty()) GTEST_SKIP() << "configure with -DBLYSK_MODELS=FOLDER to read real models";
  Result<Scene> scene = load_model((models / "gltf/AlphaBlendModeTest/AlphaBlendModeTest.glb").string());
  ASSERT_TRUE(scene) << scene.error().text();
  int blended = 0;
  for (Material& m : scene->materials) {
    m.unlit = true;
    if (m.alpha_mode != AlphaMode::blend) continue;
    m.opacity = 0.2f + 0.15f * static_cast<float>(++blended % 4);  // its textures hold the opacities
  }
  EXPECT_GT(blended, 0);
  expect_brute_force_in_any_order(*scene, flat_options(160, 120));
}

}  // namespace
}  // namespace blysk
