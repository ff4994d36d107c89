// The method that chooses for itself: as near Phong shading as it promises, whatever the scene.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "blysk/metrics.h"
#include "blysk/shapes.h"
#include "shading/testing.h"

namespace blysk {
namespace {

Scene shape(const char* name) { return std::move(*make_shape(name)); }

RenderOptions small_picture() {
  RenderOptions o;
  o.width = 600;
  o.height = 400;
  return o;
}

Light lamp(Vec3d to, Vec3f color) {
  Light light;
  light.vector = to;
  light.color = color;
  return light;
}

Frame shaded(const Scene& scene, RenderOptions o, const char* shading, Isa isa = Isa::best) {
  o.shading = shading;
  return render_frame(scene, o, isa);
}

// Half a code of rounding, and 0.54 of the transfer function's table, come on top of the error.
TEST(auto_shading, stays_within_its_error) {
  for (const char* name : {"teapot?detail=20", "sphere?detail=60", "sphere?detail=32"}) {
    const Scene scene = shape(name);
    for (int i = 0; i < 16; ++i) {
      RenderOptions o = small_picture();
      o.interpolation = (i & 1) == 0 ? Interpolation::perspective : Interpolation::screen;
      o.transfer = (i & 2) == 0 ? Transfer::srgb : Transfer::none;
      o.lights = {lamp({1, 2, 3}, {0.6f, 0.5f, 0.4f})};
      if ((i & 4) != 0) {
        o.lights.push_back(lamp({-3, 1, 1}, {0.2f, 0.3f, 0.4f}));
        o.lights.push_back(lamp({0, 1, -2}, {0.3f, 0.1f, 0.3f}));
      }
      o.max_error = (i & 8) == 0 ? 1.0f / 512 : 0.02f;
      o.lobe = i % 3 == 0 ? "w16" : "power";
      if (scene.triangles() > 5000) o.antialias = "none";  // small ones pay without it alone
      const Difference d = *compare(shaded(scene, o, "phong").image, shaded(scene, o, "auto").image);
      EXPECT_LE(d.max_difference, (i & 8) == 0 ? 1 : 6) << name << ", options " << i;
      EXPECT_GT(d.different_pixels, 0u) << name << ", options " << i;
      EXPECT_LT(d.nmse, (i & 8) == 0 ? 2e-5 : 5e-4) << name << ", options " << i;
    }
  }
}

// A triangle of twenty pixels keeps half of them for itself, and for those it does not pay to look.
TEST(auto_shading, antialiasing_takes_pixels_of_small_triangles) {
  const Scene small = shape("sphere?detail=60"), large = shape("sphere?detail=24");
  RenderOptions o = small_picture();
  o.lights = {lamp({1, 2, 3}, {0.8f, 0.8f, 0.8f})};
  const auto is_phong = [&](const Scene& scene) {
    return same(shaded(scene, o, "phong").image, shaded(scene, o, "auto").image);
  };
  EXPECT_TRUE(is_phong(small));
  EXPECT_FALSE(is_phong(large));
  o.antialias = "none";
  EXPECT_FALSE(is_phong(small));
}

TEST(auto_shading, is_phong_where_nothing_can_be_said) {
  Scene scene = shape("sphere?detail=24");
  RenderOptions o = small_picture();
  o.lights = {lamp({1, 2, 3}, {0.8f, 0.8f, 0.8f})};
  const auto expect_phong = [&](const char* why) {
    EXPECT_TRUE(same(shaded(scene, o, "phong").image, shaded(scene, o, "auto").image)) << why;
  };
  o.lobe = "schlick";
  expect_phong("a lobe that is not convex");
  o.lobe = "power";
  o.lighting = "phong";
  expect_phong("R.V");
  o.lighting = "blinn";
  scene.materials[0].shininess = 1.5f;
  expect_phong("a lobe without a bounded bend");
  scene.materials[0].shininess = 50;
  o.lights[0].kind = Light::Kind::point;
  expect_phong("a point light");
  o.lights[0].kind = Light::Kind::directional;
  EXPECT_FALSE(same(shaded(scene, o, "phong").image, shaded(scene, o, "auto").image));
  for (Mesh& mesh : scene.meshes) {
    mesh.colors.resize(mesh.positions.size());
    std::fill_n(mesh.colors.data(), mesh.colors.size(), Vec4f{0.5f, 1, 0.2f, 1});
  }
  expect_phong("colours of vertices");
}

// What it costs to find out would not come back.
TEST(auto_shading, leaves_draws_of_which_little_fits_to_phong) {
  for (const char* name : {"sphere?detail=300", "sphere?detail=6", "sphere?detail=24"}) {
    const Scene scene = shape(name);
    const RenderOptions o = small_picture();
    const Frame phong = shaded(scene, o, "phong"), chosen = shaded(scene, o, "auto");
    EXPECT_EQ(same(phong.image, chosen.image), std::strcmp(name, "sphere?detail=24") != 0) << name;
  }
}

// Planes hardly fit triangles that turn by ten degrees: what differs from Phong shading are surfaces.
TEST(auto_shading, has_surfaces_for_large_triangles) {
  const Scene scene = shape("sphere?detail=24");
  RenderOptions o = small_picture();
  o.lighting = "lambert";
  o.transfer = Transfer::none;
  o.interpolation = Interpolation::screen;
  const Image phong = shaded(scene, o, "phong").image;
  const Difference d = *compare(phong, shaded(scene, o, "auto").image);
  EXPECT_GT(d.different_pixels, 100u);
  EXPECT_LE(d.max_difference, 1);
}

// Spans, gathered pixels, clipped company, flat faces; every instruction set.
TEST(auto_shading, instruction_sets_and_company_do_not_show) {
  for (const char* name :
       {"teapot?detail=12", "sphere?detail=24", "terrain?detail=200", "triangles?count=400&size=1", "cube"}) {
    Scene scene = shape(name);
    if (std::strcmp(name, "cube") == 0) scene.meshes.at(0).normals.clear();
    const Scene opposite = turned(scene);
    RenderOptions o = small_picture();
    o.cull = Cull::none;
    o.camera = camera_inside();
    const Frame first = shaded(scene, o, "auto");
    for (const Isa isa : available_isas()) {
      EXPECT_TRUE(same(first.image, shaded(scene, o, "auto", isa).image)) << name << isa_name(isa);
    }
    EXPECT_TRUE(same(first.image, shaded(opposite, o, "auto").image)) << name;
    EXPECT_LE(compare(first.image, shaded(scene, o, "phong").image)->max_difference, 1) << name;
  }
}

TEST(auto_shading, wants_an_error_from_0_to_1) {
  const Scene scene = shape("cube");
  RenderOptions o = small_picture();
  for (const float error : {-0.1f, 1.5f}) {
    o.max_error = error;
    Renderer renderer({.threads = 1});
    EXPECT_FALSE(renderer.render(scene, o));
  }
}

}  // namespace
}  // namespace blysk
