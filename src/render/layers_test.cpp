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

// Beyond 64 layers the farthest merge, which nearer ones hide here: whatever the order nothing is to be seen
// of it.
TEST(layers, more_than_a_pixel_holds) {
  RenderOptions o = flat_options(24, 18);
  o.camera = pixel_camera(o.height);
  Random random(73);
  for (int round = 0; round < 10; ++round) {
    const Scene scene = [&] {
      Mesh mesh;
      for (std::uint32_t i = 0; i < 150; ++i) {
        const auto z = static_cast<float>(uniform(random, -0.9, 0.9));
        const Vec4f color = {random.unit(), random.unit(), random.unit(), 1};
        for (const Vec3f corner : {Vec3f{-50, -40, z}, Vec3f{60, -40, z}, Vec3f{0, 70, z}}) {
          mesh.indices.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
          mesh.positions.push_back(corner);
          mesh.colors.push_back(color);
        }
      }
      return scene_of(std::move(mesh), flat_material({1, 1, 1}, 0.3f));
    }();
    FramePlan plan;
    ASSERT_TRUE(plan_frame(scene, o, plan));
    const auto expected =
        reference::BruteForce{o.width, o.height, {}, {0.25, 0.5, 0.125}}.draw(reference::flat_layers(plan));
    const Frame frame = render_frame(scene, o, Isa::best, 2);
    EXPECT_EQ(frame.statistics.layers_merged, frame.statistics.pixels_covered * (150 - 64));
    for (std::size_t i = 0; i < expected.size(); ++i) {
      if (expected[i].doubtful) continue;
      ASSERT_NEAR((frame.image.pixels[i] & 255) / 255.0, expected[i].color.x, 0.6 / 255) << round << " " << i;
    }
  }
}

// Lit, with glass and pictures of depth, normals and triangles; in tiles that the picture cuts off.
TEST(layers, parts_of_pixels_do_not_show_threads) {
  Scene scene = *make_shape("triangles?count=800&size=0.5");
  for (const float opacity : {1.0f, 0.6f}) {
    scene.materials[0].opacity = opacity;
    scene.materials[0].alpha_mode = AlphaMode::blend;
    RenderOptions o;
    o.width = 77;
    o.height = 53;
    o.want_depth = o.want_normal = o.want_id = true;
    for (const char* variant :
         {"abuffer:samples=32", "abuffer-pool:samples=32", "supersample:n=2", "supersample"}) {
      o.antialias = variant;
      const Frame one = render_frame(scene, o, Isa::best, 1);
      for (const Isa isa : available_isas()) {
        for (const int threads : {1, 2, 7}) {
          const Frame other = render_frame(scene, o, isa, threads);
          EXPECT_TRUE(one.image.pixels == other.image.pixels) << variant << threads << isa_name(isa);
          EXPECT_TRUE(one.depth.values == other.depth.values && one.normal.values == other.normal.values &&
                      one.id == other.id)
              << variant << threads << isa_name(isa);
          EXPECT_EQ(one.statistics.pixels_covered, other.statistics.pixels_covered);
        }
      }
    }
  }
}

// Pixels inside a surface, on whose lattice vertices lie under any of them, have the bytes of one sample.
TEST(layers, a_pixel_that_one_surface_covers_is_shaded_once) {
  Mesh mesh = mesh_of({{-20.25f, -14.5f, 0.5f}, {23.5f, -12.75f, -0.5f}, {1.125f, 16.0f, 0.25f}}, {0, 1, 2});
  for (const Vec3d n : {Vec3d{-0.4, -0.3, 1}, Vec3d{0.5, -0.2, 1}, Vec3d{0.1, 0.6, 1}})
    mesh.normals.push_back(to_float(normalize(n)));
  Material material;
  material.specular = {0.6f, 0.6f, 0.6f};
  const Scene scene = scene_of(std::move(mesh), material);
  RenderOptions o;
  o.width = 50;
  o.height = 36;
  o.camera = pixel_camera(o.height);
  o.antialias = "none";
  const Frame plain = render_frame(scene, o);
  const auto covered = [&](int x, int y) {
    return plain.image.pixels[static_cast<std::size_t>(50 * y + x)] != 0;
  };
  for (const char* variant : {"abuffer", "abuffer:samples=32", "abuffer-unlimited:samples=32"}) {
    o.antialias = variant;
    const Frame frame = render_frame(scene, o);
    int inside = 0;
    for (int y = 1; y < 35; ++y) {
      for (int x = 1; x < 49; ++x) {
        if (!covered(x - 1, y) || !covered(x + 1, y) || !covered(x, y - 1) || !covered(x, y + 1)) continue;
        const auto i = static_cast<std::size_t>(50 * y + x);
        if (frame.image.pixels[i] >> 24 != 255) continue;  // an edge
        ++inside;
        EXPECT_EQ(frame.image.pixels[i], plain.image.pixels[i]) << variant << " " << x << "," << y;
      }
    }
    EXPECT_GT(inside, 400) << variant;
  }
}

TEST(layers, pictures_too_large_to_be_cut_up_are_refused) {
  RenderOptions o = flat_options(2000, 100);
  o.antialias = "supersample:n=16";
  const auto frame = Renderer({.threads = 1}).render(*make_shape("cube"), o);
  ASSERT_FALSE(frame);
  EXPECT_EQ(frame.error().code, ErrorCode::usage);
  EXPECT_NE(frame.error().message.find("1024x1024"), std::string::npos) << frame.error().message;
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
