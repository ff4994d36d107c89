// Opacity that differs from vertex to vertex: against what colours do, on every path and in every variant.
#include "antialias/vertex_opacity.h"

#include <gtest/gtest.h>

#include <cstring>

#include "blysk/metrics.h"
#include "render/testing.h"

namespace blysk {
namespace {

constexpr int kSide = 64;

Material glass(AlphaMode mode = AlphaMode::blend, float opacity = 1) {
  Material m;
  m.color = {1, 1, 1};
  m.unlit = true;
  m.alpha_mode = mode;
  m.opacity = opacity;
  return m;
}

RenderOptions options_of(const Camera& camera) {
  RenderOptions o;
  o.width = o.height = kSide;
  o.camera = camera;
  o.cull = Cull::none;
  o.transfer = Transfer::none;
  o.background = {0, 0, 0, 1};
  return o;
}

RenderOptions flat_options() { return options_of(pixel_camera(kSide)); }

// Looks along a floor that reaches from behind it to far away, or begins before it.
RenderOptions floor_options() {
  Camera camera;
  camera.eye = {0, 1, 0};
  camera.target = {0, 0, -3};
  camera.fov_deg = 60;
  camera.near_distance = 0.1;
  camera.far_distance = 50;
  return options_of(camera);
}

// A square with a gray and an alpha at each corner.
Mesh square(const std::vector<Vec3f>& corners, const std::vector<Vec2f>& gray_alpha) {
  Mesh mesh = mesh_of(corners, {0, 1, 2, 0, 2, 3});
  for (const Vec2f& c : gray_alpha) mesh.colors.push_back({c.x, c.x, c.x, c.y});
  return mesh;
}

Mesh picture_square(const std::vector<Vec2f>& gray_alpha) {
  constexpr float k = kSide / 2.0f;
  return square({{-k, -k, 0}, {k, -k, 0}, {k, k, 0}, {-k, k, 0}}, gray_alpha);
}

Mesh floor(float from, float to, const std::vector<Vec2f>& gray_alpha) {
  return square({{-2, 0, -from}, {2, 0, -from}, {2, 0, -to}, {-2, 0, -to}}, gray_alpha);
}

int red(const Frame& frame, int x, int y) {
  return static_cast<int>(frame.image.pixels[static_cast<std::size_t>(y * kSide + x)] & 255);
}

bool same_picture(const Frame& a, const Frame& b) {
  return std::memcmp(a.image.pixels.data(), b.image.pixels.data(), a.image.pixels.size() * 4) == 0;
}

TEST(vertex_opacity, runs_across_a_triangle) {
  const Scene scene = scene_of(picture_square({{1, 0}, {1, 1}, {1, 1}, {1, 0}}), glass());
  const Frame frame = render_frame(scene, flat_options());
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) EXPECT_NEAR(red(frame, x, y), 255 * (x + 0.5) / kSide, 1.01) << x << y;
  }
}

TEST(vertex_opacity, one_alpha_is_that_of_the_material) {
  const std::vector<Vec2f> half(4, {0.75f, 0.5f}), whole(4, {0.75f, 1});
  const Frame vertices = render_frame(scene_of(picture_square(half), glass()), flat_options()),
              material = render_frame(scene_of(picture_square(whole), glass(AlphaMode::blend, 0.5f)),
                                      flat_options()),
              both =
                  render_frame(scene_of(picture_square(half), glass(AlphaMode::blend, 0.5f)), flat_options());
  EXPECT_TRUE(same_picture(vertices, material));
  EXPECT_NEAR(red(material, 9, 9), 255 * 0.75 * 0.5, 1);
  EXPECT_NEAR(red(both, 9, 9), 255 * 0.75 * 0.25, 1);
}

// A triangle out of sight makes the alphas of the mesh differ: the others take the way of those that vary.
TEST(vertex_opacity, the_same_alpha_by_either_way_gives_the_same_bytes) {
  Scene uniform, varying;
  for (const double z : {-0.5, 0.0, 0.5}) {
    const Mesh mesh = picture_square(std::vector<Vec2f>(4, {static_cast<float>(0.5 + z), 0.5f}));
    Mesh more = mesh;
    for (const float x : {1000.0f, 1001.0f, 1002.0f}) {
      more.indices.push_back(static_cast<std::uint32_t>(more.positions.size()));
      more.positions.push_back({x, x * x / 1000, 0});
      more.colors.push_back({1, 1, 1, 0.25f});
    }
    Mat4 turned;
    turned.m[0][0] = 0.7;
    turned.m[0][1] = 0.3;
    turned.m[1][0] = -0.3;
    turned.m[2][0] = 0.01 * z;
    turned.m[2][3] = z;
    uniform.add(mesh, glass(), turned);
    varying.add(more, glass(), turned);
  }
  for (const char* method : {"abuffer", "abuffer-unlimited", "abuffer-merge:n=2"}) {
    RenderOptions o = flat_options();
    o.antialias = method;
    const Frame a = render_frame(uniform, o), b = render_frame(varying, o);
    EXPECT_TRUE(same_picture(a, b)) << method;
    EXPECT_GT(a.statistics.fragments_shaded, 1000u);
  }
}

// Where gray and alpha are the same, what is seen over black is the square of what an opaque one shows.
void expect_square_of_gray(const Mesh& mesh, RenderOptions o, double within) {
  o.want_coverage = true;
  const Frame opaque = render_frame(scene_of(mesh, glass(AlphaMode::opaque)), o),
              blended = render_frame(scene_of(mesh, glass()), o);
  int seen = 0;
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const double gray = red(opaque, x, y) / 255.0;
      // On edges what is opaque is mixed with the background before it is squared.
      if (opaque.coverage.values[static_cast<std::size_t>(y * kSide + x)] < 1) continue;
      EXPECT_NEAR(red(blended, x, y) / 255.0, gray * gray, within) << x << "," << y;
      ++seen;
    }
  }
  EXPECT_GT(seen, 800);
}

TEST(vertex_opacity, keeps_to_the_perspective_of_colours) {
  const std::vector<Vec2f> grays = {{0.2f, 0.2f}, {0.4f, 0.4f}, {1, 1}, {0.9f, 0.9f}};
  RenderOptions o = floor_options();
  expect_square_of_gray(floor(1, 40, grays), o, 0.012);
  expect_square_of_gray(floor(-5, 40, grays), o, 0.012);  // clipped
  o.interpolation = Interpolation::screen;
  expect_square_of_gray(floor(1.5f, 4, grays), o, 0.012);
}

TEST(vertex_opacity, masks_cut) {
  const Mesh ramp = picture_square({{0.5f, 0}, {0.5f, 1}, {0.5f, 1}, {0.5f, 0}});
  Scene masked = scene_of(ramp, glass(AlphaMode::mask)), opaque = scene_of(ramp, glass(AlphaMode::opaque));
  RenderOptions o = flat_options();
  o.want_coverage = o.want_fragments = true;
  const Frame frame = render_frame(masked, o), whole = render_frame(opaque, o);
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const auto at = static_cast<std::size_t>(y * kSide + x);
      const bool there = x >= kSide / 2;
      EXPECT_EQ(frame.image.pixels[at], there ? whole.image.pixels[at] : 0xff000000u) << x << "," << y;
      EXPECT_EQ(frame.coverage.values[at] > 0, there) << x << "," << y;
    }
  }
  masked.materials[0].alpha_cutoff = 0;
  EXPECT_TRUE(same_picture(render_frame(masked, o), whole));
  masked.materials[0].alpha_cutoff = 1.5f;
  EXPECT_EQ(render_frame(masked, o).statistics.pixels_covered, 0u);
}

// What lies behind a fragment that is wholly opaque is not seen, and does not count as there.
TEST(vertex_opacity, opaque_fragments_of_glass_hide) {
  Scene scene;
  Mat4 nearer;
  nearer.m[2][3] = 0.5;
  scene.add(picture_square(std::vector<Vec2f>(4, {1, 0.5f})), glass());
  scene.add(picture_square({{0.5f, 1}, {0.5f, 0.2f}, {0.5f, 1}, {0.5f, 1}}), glass(), nearer);
  RenderOptions o = flat_options();
  o.want_fragments = true;
  const Frame frame = render_frame(scene, o);
  // The upper left half of the near square is opaque.
  EXPECT_EQ(frame.fragments[static_cast<std::size_t>(8 * kSide + 4)], 1u);
  EXPECT_NEAR(red(frame, 4, 8), 128, 1);
  EXPECT_EQ(frame.fragments[static_cast<std::size_t>((kSide - 5) * kSide + kSide - 10)], 2u);
  o.antialias = "none";  // shows all as opaque
  EXPECT_NEAR(red(render_frame(scene, o), kSide - 10, kSide - 5), 128, 1);
}

Scene crowd() {
  Random random(5);
  Mesh mesh;
  for (std::uint32_t i = 0; i < 900; ++i) {
    mesh.indices.push_back(i);
    const auto place = [&] { return static_cast<float>(uniform(random, -kSide / 2.0, kSide / 2.0)); };
    const auto part = [&] { return static_cast<float>(uniform(random, 0, 1)); };
    const float x = place(), y = place(), z = 2 * part() - 1;
    mesh.positions.push_back({x, y, z});
    const float r = part(), g = part(), b = part(), alpha = part();
    mesh.colors.push_back({r, g, b, alpha < 0.2f ? 0 : alpha > 0.8f ? 1 : alpha});
  }
  // Few layers: not so many that they merge.
  for (std::size_t i = 0; i < 900; i += 3) {
    for (std::size_t k = 1; k < 3; ++k) {
      mesh.positions[i + k].x = mesh.positions[i].x + (mesh.positions[i + k].x - mesh.positions[i].x) * 0.3f;
      mesh.positions[i + k].y = mesh.positions[i].y + (mesh.positions[i + k].y - mesh.positions[i].y) * 0.3f;
    }
  }
  return scene_of(std::move(mesh), glass());
}

TEST(vertex_opacity, lists_show_what_the_default_shows) {
  RenderOptions o = flat_options();
  const Frame samples = render_frame(crowd(), o);
  o.antialias = "abuffer-unlimited";
  const Frame lists = render_frame(crowd(), o);
  EXPECT_EQ(samples.statistics.layers_merged, 0u);
  EXPECT_LT(compare(samples.image, lists.image)->nmse, 1e-4);
  EXPECT_LE(compare(samples.image, lists.image)->max_difference, 16);
}

TEST(vertex_opacity, threads_and_instruction_sets_do_not_show) {
  for (const AlphaMode mode : {AlphaMode::blend, AlphaMode::mask}) {
    Scene scene = crowd();
    scene.materials[0].alpha_mode = mode;
    scene.append(scene_of(floor(-5, 40, {{1, 1}, {1, 0}, {1, 0.5f}, {1, 0.2f}}), glass(mode)));
    for (const RenderOptions& o : {flat_options(), floor_options()}) {
      const Frame one = render_frame(scene, o);
      for (const int threads : {2, 7})
        EXPECT_TRUE(same_picture(one, render_frame(scene, o, Isa::best, threads)));
      for (const Isa isa : available_isas()) EXPECT_TRUE(same_picture(one, render_frame(scene, o, isa)));
    }
  }
}

}  // namespace
}  // namespace blysk
