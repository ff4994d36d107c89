// Lighting textures: the reference form against the specification, the kernel against the reference form.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "blysk/metrics.h"
#include "blysk/shapes.h"
#include "shading/lighting_texture_reference.h"
#include "shading/row_normals_reference.h"
#include "shading/testing.h"

namespace blysk {
namespace {

// C.7: levels and their points.
TEST(lighting_texture_reference, levels) {
  int square = 0, triangle = 0;
  for (int steps = 16; steps > 0; steps /= 2) {
    square += reference::square_points(steps);
    triangle += reference::triangle_points(steps);
  }
  EXPECT_EQ(square, 408);
  EXPECT_EQ(triangle, 222);
  EXPECT_EQ(reference::paper_level(100), 0);
  EXPECT_EQ(reference::paper_level(9), 0);
  EXPECT_EQ(reference::paper_level(8), 1);
  EXPECT_EQ(reference::paper_level(3), 2);
  EXPECT_EQ(reference::paper_level(1.5), 3);
  EXPECT_EQ(reference::paper_level(0.1), 4);
  // At one pixel a point none of the paper's coarser levels has fewer points than its triangles have pixels.
  for (double longest = 0.5; longest <= 8; longest += 0.125) {
    const int steps = 16 >> reference::paper_level(longest);
    EXPECT_LT(std::sqrt(3.0) / 4 * longest * longest, reference::triangle_points(steps));
  }
  EXPECT_EQ(reference::texture_steps(16, 1, 400, 200), 0);
  EXPECT_EQ(reference::texture_steps(16, 1, 40000, 400), 16);
  EXPECT_EQ(reference::texture_steps(16, 4, 400, 200), 4);
  EXPECT_EQ(reference::texture_steps(8, 4, 40000, 4000), 8);
  EXPECT_EQ(reference::texture_steps(16, 4, 9, 4), 0);
}

TEST(lighting_texture_reference, fetch) {
  const auto plane = [](int i, int j) { return 3.0 + 2 * i - j; };
  for (const Vec2<double> at : {Vec2<double>{0, 0}, {1, 0}, {0, 1}, {0.3, 0.7}, {0.31, 0.24}, {0.5, 0.5}}) {
    EXPECT_NEAR(reference::fetch_texture(16, plane, at.x, at.y), 3 + 32 * at.x - 16 * at.y, 1e-12);
    EXPECT_NEAR(reference::fetch_texture(1, plane, at.x, at.y), 3 + 2 * at.x - at.y, 1e-12);
  }
  // The middle of a whole cell is the mean of its four points.
  const auto saddle = [](int i, int j) { return double(i * j); };
  EXPECT_NEAR(reference::fetch_texture(4, saddle, 1.5 / 4, 1.5 / 4), 2.25, 1e-12);
}

constexpr int kTexturedSide = 512;

struct Setting {
  const char* name;
  int finest;
  double texel;
};
constexpr Setting kSettings[] = {{"lighting-texture", 16, 4},
                                 {"lighting-texture:texel=2", 16, 2},
                                 {"lighting-texture:texel=1", 16, 1},
                                 {"lighting-texture:nodes=9", 8, 4}};

// A triangle that fills much of the picture's middle: top, bottom, middle corner, and unit normals.
struct Scenery {
  std::array<Vec2<double>, 3> corner;
  std::array<Vec3d, 3> normal;
};

Scenery random_scenery(Random& random, Scene& scene, double size, double cone) {
  Scenery s;
  Mesh& mesh = scene.meshes[0];
  const Vec3d axis = normalize(Vec3d{uniform(random, -0.7, 0.7), uniform(random, -0.7, 0.7), 1});
  for (std::size_t k = 0; k < 3; ++k) {
    s.corner[k] = {std::round(uniform(random, -size, size) * 256) / 256,
                   std::round(uniform(random, -size, size) * 256) / 256};
    s.normal[k] = normalize(axis + random_direction(random) * cone);
    mesh.positions[k] = to_float(Vec3d{s.corner[k].x, s.corner[k].y, 0});
    mesh.normals[k] = to_float(s.normal[k]);
  }
  // Top of the picture first, the middle one last.
  std::array<std::size_t, 3> order = {0, 1, 2};
  std::sort(order.begin(), order.end(), [&](auto a, auto b) { return s.corner[a].y > s.corner[b].y; });
  return {{s.corner[order[0]], s.corner[order[2]], s.corner[order[1]]},
          {s.normal[order[0]], s.normal[order[2]], s.normal[order[1]]}};
}

// More than a million pixels.
TEST(lighting_texture, is_its_reference) {
  constexpr double kShininess = 8;
  Random random(41);
  Material material;
  material.color = {0.5f, 0.5f, 0.5f};
  material.specular = {0.4f, 0.4f, 0.4f};
  material.shininess = kShininess;
  material.double_sided = true;
  Scene scene = scene_of(mesh_of({{}, {}, {}}, {0, 1, 2}), material);
  scene.meshes[0].normals.resize(3);
  RenderOptions o;
  o.antialias = "none";
  o.width = o.height = kTexturedSide;
  o.camera = pixel_camera(kTexturedSide);
  o.ambient = 0;
  o.transfer = Transfer::none;
  o.want_id = true;
  Light light;
  light.vector = {2, 3, 6};
  light.color = {1, 1, 1};
  o.lights = {light};
  const Vec3d towards = normalize(light.vector);
  const auto terms = [&](Vec3d n) {
    const double n_l = dot(n, towards), n_h = (n_l + n.z) / std::sqrt(2 + 2 * towards.z);
    return Vec2<double>{n_l, std::pow(std::clamp(n_h, 0.0, 1.0), kShininess)};
  };
  long pixels = 0, textured = 0, wrong = 0;
  Frame frame;
  for (int round = 0; pixels < 1000000; ++round) {
    const double sizes[] = {8, 20, 60, 250};
    const Setting& setting = kSettings[static_cast<std::size_t>(round) % 4];
    const Scenery s = random_scenery(random, scene, sizes[round / 4 % 4], uniform(random, 0, 0.5));
    const auto& c = s.corner;
    double longest = 0, turn = 0;
    bool facing = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3;
      const double dx = c[k].x - c[next].x, dy = c[k].y - c[next].y;
      longest = std::max(longest, dx * dx + dy * dy);
      turn = std::max(turn, 2 - 2 * dot(s.normal[k], s.normal[next]));
      facing = facing && s.normal[k].z > 0;
    }
    const double twice = (c[1].x - c[0].x) * (c[2].y - c[0].y) - (c[2].x - c[0].x) * (c[1].y - c[0].y);
    int steps = reference::texture_steps(setting.finest, setting.texel, longest, std::abs(twice) / 2);
    if (std::abs(turn * kShininess - kTextureTurn * steps * steps) < 1e-4) continue;
    if (!facing || turn * kShininess > kTextureTurn * steps * steps) steps = 0;
    std::vector<Vec2<double>> points(static_cast<std::size_t>((steps + 1) * (steps + 1)));
    if (steps > 0) {
      const reference::TriangleNodes nodes(s.normal[0], s.normal[1], s.normal[2], steps);
      for (int j = 0; j <= steps; ++j) {
        for (int i = 0; i + j <= steps; ++i) {
          points[static_cast<std::size_t>(j * (steps + 1) + i)] = terms(nodes.at(i, j));
        }
      }
    }
    o.shading = setting.name;
    const std::vector<Isa> isas = available_isas();
    render_to(frame, scene, o, isas[static_cast<std::size_t>(round) % isas.size()]);
    for (int y = 0; y < kTexturedSide; ++y) {
      for (int x = 0; x < kTexturedSide; ++x) {
        const auto at = static_cast<std::size_t>(y * kTexturedSide + x);
        if (frame.id[at] == 0) continue;
        const double px = x + 0.5 - kTexturedSide / 2 - c[0].x, py = kTexturedSide / 2 - (y + 0.5) - c[0].y;
        const double u = (px * (c[2].y - c[0].y) - (c[2].x - c[0].x) * py) / twice;
        const double v = ((c[1].x - c[0].x) * py - px * (c[1].y - c[0].y)) / twice;
        Vec2<double> t;
        if (steps > 0) {
          const auto stored = [&](int i, int j) {
            return points[static_cast<std::size_t>(j * (steps + 1) + i)];
          };
          t.x = reference::fetch_texture(
              steps, [&](int i, int j) { return stored(i, j).x; }, u, v);
          t.y = reference::fetch_texture(
              steps, [&](int i, int j) { return stored(i, j).y; }, u, v);
        } else {
          const Vec3d n = normalize(s.normal[0] * (1 - u - v) + s.normal[1] * u + s.normal[2] * v);
          t = terms(n.z < 0 ? -n : n);
          if (std::abs(n.z) < 1e-3) continue;  // which side faces the viewer is open
        }
        const double expected = t.x > 0 ? 0.5 * t.x + 0.4 * t.y : 0;
        const double error = std::abs((frame.image.pixels[at] & 255) - 255 * expected);
        ASSERT_LT(error, 0.7) << "round " << round << ", " << setting.name << ", pixel " << x << "," << y;
        wrong += error > 0.52 ? 1 : 0;
        ++pixels;
        textured += steps > 0 ? 1 : 0;
      }
    }
  }
  EXPECT_GT(textured, 300000);
  EXPECT_LE(wrong, pixels / 1000);
}

// Spans and gathered pixels of more triangles than are kept, many lamps, clipped triangles, near lamps.
TEST(lighting_texture, instruction_sets_and_company_do_not_show) {
  for (const char* shape : {"sphere?detail=12", "sphere?detail=40", "terrain?detail=30", "plane", "cube"}) {
    Scene scene = std::move(*make_shape(shape));
    if (std::strcmp(shape, "cube") == 0) scene.meshes.at(0).normals.clear();
    scene.materials.at(0).shininess = 4;
    const Scene opposite = turned(scene);
    for (const Setting& setting : kSettings) {
      for (const std::size_t lamps : {std::size_t{1}, std::size_t{3}, std::size_t{6}}) {
        for (const bool inside : {false, true}) {
          SCOPED_TRACE(std::string(shape) + ", " + setting.name + ", lamps " + std::to_string(lamps));
          RenderOptions o;
          o.antialias = "none";
          o.width = 211;
          o.height = 138;
          o.shading = setting.name;
          o.cull = Cull::none;
          o.lights.resize(lamps);
          o.lights[0].vector = {0.3, 1, 0.5};
          for (std::size_t i = 1; i < lamps; ++i) {
            o.lights[i].kind = i == 1 ? Light::Kind::point : Light::Kind::directional;
            o.lights[i].vector = {0.5, 2, 1.0 / double(i)};
            o.lights[i].color = {0.2f, 0.3f, 0.4f};
          }
          if (inside) {
            o.camera = camera_inside();
          }
          const Frame expected = render_frame(scene, o);
          for (const Isa isa : available_isas()) {
            EXPECT_TRUE(same(expected.image, render_frame(scene, o, isa).image)) << isa_name(isa);
          }
          EXPECT_TRUE(same(expected.image, render_frame(opposite, o, Isa::best, 3).image));
        }
      }
    }
  }
}

TEST(lighting_texture, spheres_look_like_phong) {
  for (const int detail : {10, 25, 50, 100}) {
    const Scene scene = *make_shape("spheres?detail=" + std::to_string(detail));
    RenderOptions o;
    o.antialias = "none";
    o.width = 1000;
    o.height = 400;
    o.camera = scene.cameras[0];
    o.transfer = Transfer::none;
    const Frame phong = render_frame(scene, o);
    for (const Setting& setting : kSettings) {
      o.shading = setting.name;
      const double nmse = compare(phong.image, render_frame(scene, o).image)->nmse;
      EXPECT_LT(nmse, 1e-4) << setting.name << ", detail " << detail;
      RecordProperty(std::string(setting.name) + "-" + std::to_string(detail), std::to_string(nmse * 1e6));
    }
  }
}

// Opposite normals, normals of length 0, needles: a colour like any other.
TEST(lighting_texture, hard_triangles) {
  const Mesh mesh = hard_triangles();
  RenderOptions o;
  o.antialias = "none";
  o.width = o.height = 200;
  o.camera = pixel_camera(200);
  o.want_id = true;
  const Frame phong = render_frame(scene_of(mesh), o);
  for (const Setting& setting : kSettings) {
    o.shading = setting.name;
    const Frame frame = render_frame(scene_of(mesh), o);
    EXPECT_TRUE(same(phong.image, frame.image));  // nothing of it can be held by a texture
  }
}

}  // namespace
}  // namespace blysk
