// What a renderer refuses, counts and promises.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "blysk/shapes.h"
#include "render/testing.h"

namespace blysk {
namespace {

void expect_refused(const Scene& scene, const RenderOptions& options, ErrorCode code, const char* word) {
  Renderer& renderer = shared_renderer(Isa::best);
  const Result<Frame> frame = renderer.render(scene, options);
  ASSERT_FALSE(frame) << word;
  EXPECT_EQ(frame.error().code, code) << word;
  EXPECT_NE(frame.error().text().find(word), std::string::npos) << frame.error().text();
  EXPECT_EQ(frame.error().text().find('\n'), std::string::npos);
  EXPECT_TRUE(renderer.render(shape_scene("cube"), sized(8, 8))) << "after " << word;
}

TEST(renderer, refuses_sizes_out_of_range) {
  const Scene scene = shape_scene("cube");
  for (const auto& [width, height] :
       {std::pair{0, 10}, {10, 0}, {-1, 10}, {16385, 1}, {1, 16385}, {1 << 30, 1 << 30}}) {
    expect_refused(scene, sized(width, height), ErrorCode::usage, "16384");
  }
  EXPECT_TRUE(shared_renderer(Isa::best).render(scene, sized(16384, 1)));
  EXPECT_TRUE(shared_renderer(Isa::best).render(scene, sized(1, 16384)));
}

TEST(renderer, refuses_unknown_methods) {
  const Scene scene = shape_scene("cube");
  for (std::string RenderOptions::*method :
       {&RenderOptions::shading, &RenderOptions::lighting, &RenderOptions::lobe, &RenderOptions::antialias}) {
    for (const char* name : {"nonsense", "", "Phong"}) {
      RenderOptions o = sized(8, 8);
      o.*method = name;
      expect_refused(scene, o, ErrorCode::usage, name);
    }
  }
}

TEST(renderer, refuses_cameras_without_sense) {
  const Scene scene = shape_scene("cube");
  RenderOptions o = sized(8, 8);
  o.camera.emplace();
  o.camera->eye = o.camera->target;
  expect_refused(scene, o, ErrorCode::usage, "eye");
  o.camera->eye = {0, 0, 5};
  o.camera->fov_deg = 171;
  expect_refused(scene, o, ErrorCode::usage, "field of view");
}

TEST(renderer, takes_sixteen_lights_and_no_more) {
  const Scene scene = shape_scene("cube");
  RenderOptions o = sized(8, 8);
  o.lights.resize(16);
  EXPECT_TRUE(shared_renderer(Isa::best).render(scene, o));
  o.lights.resize(17);
  expect_refused(scene, o, ErrorCode::limit, "16");
}

TEST(renderer, refuses_instances_of_nothing) {
  for (const bool with_camera : {false, true}) {
    RenderOptions o = sized(8, 8);
    if (with_camera) o.camera.emplace();
    Scene scene = shape_scene("cube");
    scene.instances[0].mesh = 7;
    expect_refused(scene, o, ErrorCode::usage, "mesh");
    scene = shape_scene("cube");
    scene.instances[0].material = 7;
    expect_refused(scene, o, ErrorCode::usage, "material");
  }
}

TEST(renderer, keeps_to_its_limits) {
  const Scene scene = shape_scene("cube");  // 12 triangles
  RenderOptions o = sized(64, 64);
  o.limits.max_triangles = 11;
  expect_refused(scene, o, ErrorCode::limit, "11");
  for (const std::uint64_t most : {std::uint64_t{12}, std::numeric_limits<std::uint64_t>::max()}) {
    o.limits.max_triangles = most;
    EXPECT_TRUE(shared_renderer(Isa::best).render(scene, o)) << most;
  }
  o.limits.max_memory = 64 * 64 * 4 - 1;
  expect_refused(scene, o, ErrorCode::limit, "memory");
  o.limits.max_memory = 1 << 20;
  EXPECT_TRUE(shared_renderer(Isa::best).render(scene, o));
}

TEST(renderer, draws_nothing_of_empty_scenes) {
  Scene no_triangles = scene_of(mesh_of({{0, 0, 0}, {1, 0, 0}}, {}));
  Scene no_points = scene_of(Mesh{});
  Scene behind = shape_scene("cube");
  behind.instances[0].transform = translation({0, 0, 50});
  RenderOptions o = sized(37, 23);
  o.want_depth = o.want_normal = o.want_id = true;
  o.background = {0.2f, 0.4f, 0.6f, 0.5f};
  const std::uint32_t background = 51u | 102u << 8 | 153u << 16 | 128u << 24;
  for (const Scene& scene : {Scene{}, no_triangles, no_points, behind}) {
    for (const bool with_camera : {false, true}) {
      if (with_camera) {
        o.camera.emplace();
      } else if (!scene.instances.empty() && scene.meshes[0].triangles() > 0) {
        continue;
      } else {
        o.camera.reset();
      }
      const Frame frame = render_frame(scene, o);
      ASSERT_EQ(frame.image.pixels.size(), 37u * 23u);
      for (const std::uint32_t p : frame.image.pixels) ASSERT_EQ(p, background);
      for (const float d : frame.depth.values) ASSERT_EQ(d, 1.0f);
      for (const float n : frame.normal.values) ASSERT_EQ(n, 0.0f);
      for (const std::uint32_t id : frame.id) ASSERT_EQ(id, 0u);
      EXPECT_EQ(frame.statistics.pixels_covered, 0u);
      EXPECT_EQ(frame.statistics.triangles_drawn, 0u);
    }
  }
}

TEST(renderer, gives_only_what_is_wanted) {
  const Scene scene = shape_scene("cube");
  RenderOptions o = sized(20, 10);
  Frame frame = render_frame(scene, o);
  EXPECT_TRUE(frame.depth.values.empty() && frame.normal.values.empty() && frame.id.empty());
  o.want_depth = o.want_normal = o.want_id = true;
  render_to(frame, scene, o);
  EXPECT_EQ(frame.depth.values.size(), 200u);
  EXPECT_EQ(frame.depth.channels, 1);
  EXPECT_EQ(frame.normal.values.size(), 600u);
  EXPECT_EQ(frame.normal.channels, 3);
  EXPECT_EQ(frame.id.size(), 200u);
  o.want_depth = o.want_normal = o.want_id = false;
  render_to(frame, scene, o);
  EXPECT_TRUE(frame.depth.values.empty() && frame.normal.values.empty() && frame.id.empty());
}

// Opposite normals, vanishing ones, and ones across the view: pictures and normals stay numbers.
TEST(renderer, normals_that_cancel_face_the_viewer) {
  const Vec3f sets[][3] = {{{0, 0, 1}, {0, 0, -1}, {0, 0, 1}},
                           {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}},
                           {{1, 0, 0}, {-1, 0, 0}, {1, 0, 0}},
                           {{0, 1, 0}, {0, -1, 0}, {0, 0, 0}},
                           {{1e-20f, 0, 0}, {0, 1e-20f, 0}, {0, 0, 1e-20f}}};
  for (const auto& normals : sets) {
    // The edge between the first two corners runs through pixel centres, its middle lies on one.
    Mesh mesh = mesh_of({{-20.5f, 0.5f, 0}, {19.5f, 0.5f, 0}, {0, -20, 0}}, {0, 1, 2});
    mesh.normals.assign(std::begin(normals), std::end(normals));
    RenderOptions o = sized(64, 48);
    o.camera = pixel_camera(48);
    o.want_normal = true;
    for (const char* shading : {"phong", "gouraud", "flat"}) {
      o.shading = shading;
      const Frame frame = render_frame(scene_of(mesh), o);
      ASSERT_GT(frame.statistics.pixels_covered, 300u);
      for (std::size_t p = 0; p < frame.image.pixels.size(); ++p) {
        if (frame.image.pixels[p] == 0) continue;
        const float* n = &frame.normal.values[3 * p];
        const float l = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
        ASSERT_NEAR(l, 1, 1e-5) << shading;
        ASSERT_GE(n[2], 0) << shading;
      }
    }
  }
}

// A square of two triangles, one unit a side, counter-clockwise from +Z.
Mesh square() { return mesh_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {0, 1, 2, 0, 2, 3}); }

TEST(renderer, counts_by_hand) {
  RenderOptions o = sized(100, 80);
  o.camera = pixel_camera(80);
  o.cull = Cull::back;
  Scene scene;
  scene.add(square(), {}, translation({-40, -30, 0}) * scaling({20, 10, 1}));  // 200 pixels
  scene.add(square(), {},
            translation({0, 0, -0.5}) * scaling({200, 150, 1}));             // the upper right quarter: 2000
  scene.add(square(), {}, translation({10, 10, 0.5}) * scaling({5, 5, 1}));  // hides 25 of them
  scene.add(square(), {},
            translation({10, 20, 0.7}) * rotation({0, 1, 0}, 3.2) * scaling({5, 5, 0.1}));  // away
  scene.add(square(), {}, translation({5.1, -20.9, 0}) * scaling({0.2, 0.2, 1}));  // between pixel centres
  scene.add(square(), {}, translation({300, 0, 0}) * scaling({9, 9, 1}));          // outside
  scene.add(square(), {}, translation({0, 0, 5}) * scaling({9, 9, 1}));            // before the near plane
  const Frame frame = render_frame(scene, o);
  EXPECT_EQ(frame.statistics.triangles_in, 14u);
  EXPECT_EQ(frame.statistics.triangles_culled, 2u);
  EXPECT_EQ(frame.statistics.triangles_drawn, 6u);
  EXPECT_EQ(frame.statistics.pixels_covered, 2200u);
  o.cull = Cull::none;
  EXPECT_EQ(render_frame(scene, o).statistics.triangles_culled, 0u);
}

// Mirrored instances keep their fronts: a negative determinant turns the winding, not the surface.
TEST(renderer, culling_knows_mirrored_instances) {
  RenderOptions o = sized(60, 60);
  o.camera = pixel_camera(60);
  const struct {
    Vec3d scale;
    bool front;
  } rows[] = {{{9, 9, 0.1}, true},   {{-9, 9, 0.1}, true},  {{9, -9, 0.1}, true},
              {{9, 9, -0.1}, false}, {{-9, -9, 0.1}, true}, {{-9, -9, -0.1}, false}};
  for (const auto& [scale, front] : rows) {
    for (const bool double_sided : {false, true}) {
      for (const Cull cull : {Cull::none, Cull::back, Cull::material}) {
        Scene scene;
        Material material;
        material.double_sided = double_sided;
        scene.add(square(), material, scaling(scale));
        o.cull = cull;
        const Frame frame = render_frame(scene, o);
        const bool culled = !front && (cull == Cull::back || (cull == Cull::material && !double_sided));
        EXPECT_EQ(frame.statistics.triangles_culled, culled ? 2u : 0u)
            << scale.x << " " << scale.y << " " << scale.z;
        EXPECT_EQ(frame.statistics.pixels_covered, culled ? 0u : 81u);
      }
    }
  }
}

// A closed solid looks the same with its back faces culled, mirrored or not; large and clipped triangles too.
TEST(renderer, culling_does_not_show_on_solids) {
  for (const double mirror : {1.0, -1.0}) {
    for (const char* text : {"teapot?detail=6", "torus?detail=200", "cube"}) {
      Scene scene = shape_scene(text);
      scene.instances[0].transform = scaling({mirror, 1, 1});
      RenderOptions o = sized(400, 300);
      o.camera.emplace();
      o.camera->eye = {0.9, 1.2, 1.6};
      o.camera->fov_deg = 70;
      o.shading = "flat";
      o.cull = Cull::none;
      const Frame all = render_frame(scene, o);
      o.cull = Cull::back;
      const Frame culled = render_frame(scene, o);
      if (std::string_view(text).starts_with("teapot"))
        continue;  // open: the spout and the lid's rim show insides
      EXPECT_GT(culled.statistics.triangles_culled, 0u) << text;
      EXPECT_TRUE(all.image.pixels == culled.image.pixels) << text << ", " << mirror;
    }
  }
}

TEST(renderer, holds_few_bytes_a_triangle) {
  const Scene scene = shape_scene("sphere?detail=500");
  Renderer renderer({.threads = 2});
  const Result<Frame> frame = renderer.render(scene, sized(1280, 720));
  ASSERT_TRUE(frame);
  EXPECT_GT(frame->statistics.triangles_in, 990'000u);
  EXPECT_LT(frame->statistics.memory_bytes, 64 * frame->statistics.triangles_in);
  EXPECT_GT(frame->statistics.memory_bytes, 8 * frame->statistics.triangles_in);
}

TEST(renderer, says_what_it_is) {
  for (const Isa isa : available_isas()) {
    const Renderer renderer({.threads = 3, .isa = isa});
    EXPECT_EQ(renderer.isa(), isa);
    EXPECT_EQ(renderer.threads(), 3);
    EXPECT_FALSE(isa_name(isa).empty());
  }
  EXPECT_EQ(Renderer({.isa = Isa::best}).isa(), available_isas().back());
  EXPECT_GE(Renderer().threads(), 1);
}

}  // namespace
}  // namespace blysk
