// The promise: the same bytes on every instruction set and number of threads, and a pixel that does not
// depend on company.
#include <gtest/gtest.h>

#include <cstring>
#include <numeric>

#include "blysk/methods.h"
#include "blysk/shapes.h"
#include "render/testing.h"

namespace blysk {
namespace {

void expect_same(const Frame& a, const Frame& b) {
  EXPECT_TRUE(same_bytes(a.image.pixels, b.image.pixels));
  EXPECT_TRUE(same_bytes(a.depth.values, b.depth.values));
  EXPECT_TRUE(same_bytes(a.normal.values, b.normal.values));
  EXPECT_TRUE(same_bytes(a.id, b.id));
  EXPECT_EQ(a.statistics.triangles_in, b.statistics.triangles_in);
  EXPECT_EQ(a.statistics.triangles_culled, b.statistics.triangles_culled);
  EXPECT_EQ(a.statistics.triangles_drawn, b.statistics.triangles_drawn);
  EXPECT_EQ(a.statistics.pixels_covered, b.statistics.pixels_covered);
}

struct Case {
  std::string name;
  Scene scene;
  RenderOptions options;
};

RenderOptions with_planes(int width, int height) {
  RenderOptions o = sized(width, height);
  o.want_depth = o.want_normal = o.want_id = true;
  return o;
}

Camera camera_at(Vec3d eye, Vec3d target, double fov_deg) {
  Camera c;
  c.eye = eye;
  c.target = target;
  c.fov_deg = fov_deg;
  return c;
}

Light lamp_at(Light::Kind kind, Vec3d vector, Vec3f color) {
  Light light;
  light.kind = kind;
  light.vector = vector;
  light.color = color;
  return light;
}

// A shape five times: moved, turned, stretched, mirrored, with another material each.
Scene instances_of(const char* text) {
  Scene one = shape_scene(text), all;
  all.meshes = one.meshes;
  for (int i = 0; i < 5; ++i) {
    Material m;
    m.color = {0.2f + 0.15f * static_cast<float>(i), 0.5f, 0.9f - 0.15f * static_cast<float>(i)};
    m.shininess = i == 0 ? 1.0f : i == 1 ? 7.5f : 20.0f * static_cast<float>(i);
    m.double_sided = i % 2 == 0;
    m.unlit = i == 4;
    all.materials.push_back(m);
    Instance instance;
    instance.mesh = 0;
    instance.material = static_cast<std::uint32_t>(i);
    const double s = 0.4 + 0.1 * i;
    instance.transform = translation({i - 2.0, 0.3 * i - 0.6, -0.4 * i}) * rotation({0, 1, 0}, 0.7 * i) *
                         scaling({i % 2 == 1 ? -s : s, s * (1 + 0.5 * i), s});
    all.instances.push_back(instance);
  }
  return all;
}

std::vector<std::string> shadings() {
  std::vector<std::string> names;
  for (const Method& m : methods()) {
    if (m.kind != MethodKind::shading) continue;
    for (const std::string& variant : method_variants(m)) names.push_back(variant);
  }
  return names;
}

std::vector<std::pair<std::string, std::string>> shadings_and_antialias() {
  std::vector<std::pair<std::string, std::string>> pairs;
  for (const std::string& shading : shadings()) {
    pairs.emplace_back(shading, "none");
    pairs.emplace_back(shading, "abuffer");
  }
  return pairs;
}

std::vector<Case> cases() {
  std::vector<Case> all;
  const auto add = [&](const char* name, Scene scene, RenderOptions options) -> RenderOptions& {
    all.push_back({name, std::move(scene), std::move(options)});
    return all.back().options;
  };
  add("plain", shape_scene("teapot"), with_planes(333, 217));
  {
    RenderOptions& o = add("point lights, Phong's lighting, no transfer", shape_scene("sphere?detail=60"),
                           with_planes(256, 192));
    o.lights = {lamp_at(Light::Kind::point, {2, 1, 2}, {1, 0.3f, 0.2f}),
                lamp_at(Light::Kind::point, {-2, 1, 1}, {0.1f, 0.6f, 1})};
    o.lighting = "phong";
    o.transfer = Transfer::none;
  }
  {
    RenderOptions& o = add("Gouraud, screen interpolation, culled", shape_scene("trefoil?detail=200"),
                           with_planes(301, 200));
    o.shading = "gouraud";
    o.interpolation = Interpolation::screen;
    o.cull = Cull::back;
  }
  {
    RenderOptions& o = add("materials, orthographic", shape_scene("xfighter"), with_planes(320, 200));
    o.camera = camera_at({2, 3, 4}, {0, 0, 0}, 45);
    o.camera->height = 2.5;
  }
  {
    RenderOptions& o = add("loose triangles with colours", shape_scene("triangles?count=3000&size=0.3"),
                           with_planes(215, 333));
    o.shading = "flat";
    o.lights = {lamp_at(Light::Kind::point, {0, 0, 3}, {1, 1, 1})};
  }
  {
    RenderOptions& o =
        add("loose triangles, Gouraud", shape_scene("triangles?count=500&size=1"), with_planes(200, 200));
    o.shading = "gouraud";
    o.camera = camera_at({0.1, 0.2, 0.3}, {1, 0, 0}, 110);
  }
  {
    RenderOptions& o = add("terrain from inside", shape_scene("terrain?detail=120"), with_planes(400, 130));
    o.camera = camera_at({0, 0.4, 0.9}, {0, 0.1, -1}, 100);
    o.lighting = "lambert";
  }
  {
    RenderOptions& o = add("pixel-sized triangles, Phong's lighting", shape_scene("trefoil?detail=1500"),
                           with_planes(190, 141));
    o.lighting = "phong";
    o.background = {0.2f, 0.4f, 0.6f, 1};
  }
  {
    RenderOptions& o = add("instances", instances_of("teapot?detail=4"), with_planes(333, 217));
    o.camera = camera_at({0.5, 1.5, 6}, {0, 0, 0}, 50);
    o.lights = {lamp_at(Light::Kind::directional, {1, 2, 1}, {0.7f, 0.7f, 0.5f}),
                lamp_at(Light::Kind::point, {0, 1, 2}, {0.4f, 0.4f, 0.9f})};
  }
  {
    RenderOptions& o = add("instances without normals", instances_of("cube?detail=2"), with_planes(129, 65));
    for (Mesh& mesh : all.back().scene.meshes) mesh.normals.clear();
    o.camera = camera_at({0.5, 1.5, 6}, {0, 0, 0}, 50);
    o.cull = Cull::back;
  }
  {
    RenderOptions& o = add("sixteen lights", shape_scene("icosphere?detail=6"), with_planes(100, 90));
    for (int i = 0; i < 16; ++i) {
      const auto kind = i % 3 == 0 ? Light::Kind::point : Light::Kind::directional;
      o.lights.push_back(lamp_at(kind, {2.0 - 0.3 * i, 1 + 0.1 * i, 3.0 - i * 0.1}, {0.05f, 0.08f, 0.06f}));
    }
  }
  // Every method from close by, where triangles are clipped, with colours; and from afar, without normals.
  for (const std::string& shading : shadings()) {
    RenderOptions& close = add((shading + ", clipped").c_str(), shape_scene("triangles?count=100&size=1"),
                               with_planes(170, 140));
    close.shading = shading;
    close.camera = camera_at({0.1, 0.2, 0.3}, {1, 0, 0}, 110);
    RenderOptions& far =
        add((shading + ", instances").c_str(), instances_of("teapot?detail=4"), with_planes(211, 137));
    far.shading = shading;
    far.camera = camera_at({0.5, 1.5, 6}, {0, 0, 0}, 50);
    far.lights = {lamp_at(Light::Kind::directional, {1, 2, 1}, {0.7f, 0.7f, 0.5f}),
                  lamp_at(Light::Kind::point, {0, 1, 2}, {0.4f, 0.4f, 0.9f})};
    RenderOptions& bare =
        add((shading + ", without normals").c_str(), instances_of("cube?detail=2"), with_planes(129, 65));
    for (Mesh& mesh : all.back().scene.meshes) mesh.normals.clear();
    bare.shading = shading;
  }
  add("one pixel", shape_scene("sphere"), with_planes(1, 1));
  add("one column", shape_scene("sphere"), with_planes(1, 301));
  add("nothing", Scene{}, with_planes(70, 70));
  for (std::size_t i = 0, count = all.size(); i < count; ++i) {
    Case sampled = all[i];
    sampled.name += ", antialiased";
    sampled.options.antialias = "abuffer";
    all.push_back(std::move(sampled));
  }
  return all;
}

// The scalar build is the slow witness: it draws each case once, on one, two or seven threads in turn.
TEST(determinism, instruction_sets_threads_and_repeats_agree) {
  constexpr int kThreads[] = {1, 2, 7};
  std::size_t turn = 0;
  for (const Case& c : cases()) {
    SCOPED_TRACE(c.name);
    const int turn_threads = kThreads[turn++ % 3];
    const Frame expected = render_frame(c.scene, c.options);
    EXPECT_TRUE(c.scene.instances.empty() || expected.statistics.pixels_covered > 0);
    for (const Isa isa : available_isas()) {
      for (const int threads : kThreads) {
        if (isa == Isa::scalar && threads != turn_threads) continue;
        SCOPED_TRACE(std::string(isa_name(isa)) + ", threads " + std::to_string(threads));
        Frame frame;
        render_to(frame, c.scene, c.options, isa, threads);
        expect_same(frame, expected);
        if (isa == Isa::scalar || threads != 2) continue;
        render_to(frame, c.scene, c.options, isa, threads);
        expect_same(frame, expected);
      }
    }
  }
}

// What a renderer drew before leaves no trace.
TEST(determinism, order_of_frames_does_not_show) {
  const std::vector<Case> all = cases();
  Renderer used({.threads = 2});
  Frame frame;
  for (std::size_t i = all.size(); i-- > 0;) {
    SCOPED_TRACE(all[i].name);
    ASSERT_TRUE(used.render(all[i].scene, all[i].options, frame));
    expect_same(frame, render_frame(all[i].scene, all[i].options));
  }
}

template <class T>
void shuffle(std::vector<T>& values, Random& random) {
  for (std::size_t i = values.size(); i > 1; --i) std::swap(values[i - 1], values[random.next() % i]);
}

// Triangles and vertices of every mesh in another order.
Scene shuffled(Scene scene, Random& random) {
  for (Mesh& mesh : scene.meshes) {
    std::vector<std::uint32_t> triangle(mesh.triangles()), vertex(mesh.positions.size());
    std::iota(triangle.begin(), triangle.end(), 0u);
    std::iota(vertex.begin(), vertex.end(), 0u);
    shuffle(triangle, random);
    shuffle(vertex, random);
    const Mesh old = mesh;
    for (std::size_t v = 0; v < vertex.size(); ++v) {
      mesh.positions[vertex[v]] = old.positions[v];
      if (!old.normals.empty()) mesh.normals[vertex[v]] = old.normals[v];
      if (!old.colors.empty()) mesh.colors[vertex[v]] = old.colors[v];
    }
    for (std::size_t t = 0; t < triangle.size(); ++t) {
      for (std::size_t k = 0; k < 3; ++k) mesh.indices[3 * t + k] = vertex[old.indices[3 * triangle[t] + k]];
    }
  }
  return scene;
}

// Where no two depths are equal, the order of triangles decides in which lanes and runs pixels are shaded,
// and no more.
TEST(determinism, order_of_triangles_does_not_show) {
  Random random(21);
  for (const char* text : {"sphere?detail=20", "teapot?detail=6", "trefoil?detail=500",
                           "triangles?count=2000&size=0.2", "terrain?detail=150"}) {
    const Scene scene = shape_scene(text), other = shuffled(scene, random);
    for (const auto& [shading, antialias] : shadings_and_antialias()) {
      SCOPED_TRACE(std::string(text) + ", " + shading + ", " + antialias);
      RenderOptions o = with_planes(233, 170);
      o.shading = shading;
      o.antialias = antialias;
      o.lights = {lamp_at(Light::Kind::point, {1, 2, 3}, {1, 1, 1})};
      const Frame a = render_frame(scene, o), b = render_frame(other, o);
      EXPECT_TRUE(same_bytes(a.image.pixels, b.image.pixels));
      EXPECT_TRUE(same_bytes(a.depth.values, b.depth.values));
      EXPECT_TRUE(same_bytes(a.normal.values, b.normal.values));
      EXPECT_FALSE(same_bytes(a.id, b.id));
    }
  }
}

// A shape whose corners lie on the grid of 1/256 pixel of pixel_camera(), so that whole pixels can be added
// without rounding.
Scene snapped_shape(const char* text, float pixels) {
  Scene scene = shape_scene(text);
  const auto snap = [&](float v) { return std::round(v * pixels * 256) / 256; };
  for (Mesh& mesh : scene.meshes) {
    for (Vec3f& p : mesh.positions) p = {snap(p.x), snap(p.y), p.z * 0.4f};
  }
  return scene;
}

// The same scene elsewhere on a larger canvas: other tiles, other lanes, the same pixels. The small canvas
// cuts it off.
TEST(determinism, place_on_the_canvas_does_not_show) {
  constexpr int kSmall = 110;
  for (const char* text :
       {"sphere?detail=12", "teapot?detail=12", "trefoil?detail=900", "triangles?count=2000&size=0.2"}) {
    const Scene scene = snapped_shape(text, 90);
    for (const auto& [shading, antialias] : shadings_and_antialias()) {
      RenderOptions o = with_planes(kSmall, kSmall);
      o.shading = shading;
      o.antialias = antialias;
      o.lights = {lamp_at(Light::Kind::directional, {1, 2, 3}, {1, 1, 1})};
      o.camera = pixel_camera(kSmall);
      const Frame small = render_frame(scene, o);
      for (const Vec2<int> shift :
           {Vec2<int>{16, 0}, {0, 16}, {48, 80}, {64, 64}, {1, 0}, {7, 13}, {-9, -5}}) {
        SCOPED_TRACE(std::string(text) + ", " + shading + ", " + antialias + ", moved by " +
                     std::to_string(shift.x) + "," + std::to_string(shift.y));
        constexpr int kLarge = 280, kFirst = (kLarge - kSmall) / 2;
        o.width = o.height = kLarge;
        o.camera = pixel_camera(kLarge);
        const Vec3d by = {-double(shift.x), double(shift.y), 0};
        o.camera->eye = o.camera->eye + by;
        o.camera->target = o.camera->target + by;
        const Frame large = render_frame(scene, o);
        int different = 0;
        for (int y = 0; y < kSmall; ++y) {
          for (int x = 0; x < kSmall; ++x) {
            const auto a = static_cast<std::size_t>(y * kSmall + x);
            const auto b = static_cast<std::size_t>((y + kFirst + shift.y) * kLarge + x + kFirst + shift.x);
            different += small.image.pixels[a] != large.image.pixels[b] || small.id[a] != large.id[b] ||
                                 small.depth.values[a] != large.depth.values[b]
                             ? 1
                             : 0;
          }
        }
        EXPECT_EQ(different, 0);
      }
    }
  }
}

}  // namespace
}  // namespace blysk
