// What every shape keeps, and how their text is read.
#include "blysk/shapes.h"

#include <gtest/gtest.h>

#include <string>

#include "scene/shapes_testing.h"

namespace {

using blysk::ErrorCode;
using blysk::make_shape;
using blysk::Mesh;
using blysk::Scene;

Scene made(const std::string& text) {
  auto scene = make_shape(text);
  EXPECT_TRUE(scene) << text << ": " << scene.error().text();
  return scene ? std::move(*scene) : Scene{};
}

std::string refused(std::string_view text) {
  const auto scene = make_shape(text);
  EXPECT_FALSE(scene) << text;
  EXPECT_EQ(scene.error().code, ErrorCode::usage) << text;
  EXPECT_EQ(scene.error().text().find('\n'), std::string::npos);
  return scene.error().text();
}

void expect_sound(const Mesh& mesh, const std::string& text) {
  SCOPED_TRACE(text + " " + mesh.name);
  const std::size_t n = mesh.positions.size();
  ASSERT_GT(mesh.triangles(), 0u);
  ASSERT_EQ(mesh.indices.size() % 3, 0u);
  ASSERT_TRUE(mesh.normals.empty() || mesh.normals.size() == n);
  ASSERT_EQ(mesh.texcoords.size(), n);
  std::vector<bool> used(n);
  for (const std::uint32_t i : mesh.indices) {
    ASSERT_LT(i, n);
    used[i] = true;
  }
  EXPECT_EQ(std::count(used.begin(), used.end(), false), 0);
  for (const blysk::Vec3f& p : mesh.positions) {
    ASSERT_TRUE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
  }
  for (const blysk::Vec3f& v : mesh.normals) ASSERT_NEAR(blysk::length(v), 1, 1e-6f);
  for (const blysk::Vec2f& t : mesh.texcoords) ASSERT_TRUE(t.x >= 0 && t.x <= 1 && t.y >= 0 && t.y <= 1);
  EXPECT_EQ(blysk::shape::flat_triangles(mesh), 0u);
}

TEST(shapes, table_is_sound) {
  for (const blysk::ShapeInfo& info : blysk::shapes()) {
    EXPECT_EQ(std::count_if(blysk::shapes().begin(), blysk::shapes().end(),
                            [&](const auto& other) { return other.name == info.name; }),
              1);
    EXPECT_FALSE(info.help.empty());
    for (const blysk::ShapeParameter& p : info.parameters) {
      EXPECT_LE(p.minimum, p.initial);
      EXPECT_LE(p.initial, p.maximum);
      EXPECT_FALSE(p.help.empty());
    }
  }
}

TEST(shapes, every_default_is_sound) {
  for (const blysk::ShapeInfo& info : blysk::shapes()) {
    const Scene scene = made(std::string(info.name));
    for (const Mesh& mesh : scene.meshes) expect_sound(mesh, std::string(info.name));
    for (const blysk::Instance& i : scene.instances) {
      EXPECT_LT(i.mesh, scene.meshes.size());
      EXPECT_LT(i.material, scene.materials.size());
    }
  }
}

// Any change of a shape's bytes shows here, and so does any difference between machines.
TEST(shapes, every_default_has_the_same_bytes_for_ever) {
  const std::map<std::string_view, std::uint64_t> hashes = {
      {"teapot", 0xF1F532D51357483Cu},    {"sphere", 0x33383D812FA859E4u},
      {"icosphere", 0x16FCD770FAFF6667u}, {"torus", 0x0053D10BE5E8A574u},
      {"cube", 0x9CF64EB451CB42A5u},      {"cylinder", 0xBB01AA440246B2E5u},
      {"plane", 0x94FC9BFFE012FEF6u},     {"trefoil", 0xCFE3A1459999EB16u},
      {"terrain", 0xB5254A1E461EB3D9u},   {"xfighter", 0x96948FA46055894Cu},
      {"triangles", 0x89C5EC6ACD21B15Cu}, {"spheres", 0x78BE38B391CF7134u},
      {"soup", 0x686715DD0CE0D5EFu},      {"micro", 0xCB9EC1F47DD4C1B1u},
      {"meshes", 0x4C45D3413DABFE05u},    {"grass", 0x25D1546645A3C4A9u},
      {"fans", 0xA63F041BCAE47972u},
  };
  for (const blysk::ShapeInfo& info : blysk::shapes()) {
    ASSERT_TRUE(hashes.contains(info.name)) << info.name;
    EXPECT_EQ(blysk::shape::hash(made(std::string(info.name))), hashes.at(info.name))
        << info.name << std::hex << " 0x" << blysk::shape::hash(made(std::string(info.name)));
  }
}

TEST(shapes, solids_are_closed_and_look_outwards) {
  const std::map<std::string, long long> euler = {{"sphere", 2},
                                                  {"sphere?detail=2", 2},
                                                  {"sphere?detail=7", 2},
                                                  {"icosphere", 2},
                                                  {"icosphere?detail=1", 2},
                                                  {"icosphere?detail=5", 2},
                                                  {"torus", 0},
                                                  {"torus?detail=3", 0},
                                                  {"torus?ratio=0.01", 0},
                                                  {"torus?ratio=0.99", 0},
                                                  {"torus?detail=7", 0},
                                                  {"cube", 2},
                                                  {"cube?detail=3", 2},
                                                  {"cylinder", 2},
                                                  {"cylinder?detail=3", 2},
                                                  {"trefoil", 0},
                                                  {"trefoil?detail=24", 0},
                                                  {"trefoil?tube=0.05", 0},
                                                  {"trefoil?tube=0.7", 0},
                                                  {"spheres", 2},
                                                  {"spheres?detail=3", 2}};
  for (const auto& [text, expected] : euler) {
    const Scene scene = made(text);
    ASSERT_EQ(scene.meshes.size(), 1u);
    expect_sound(scene.meshes[0], text);
    const blysk::shape::Topology t = blysk::shape::topology(scene.meshes[0]);
    EXPECT_TRUE(t.closed()) << text;
    EXPECT_EQ(t.euler(), expected) << text;
    EXPECT_GT(blysk::shape::volume(scene.meshes[0]), 0) << text;
    EXPECT_FALSE(scene.materials[0].double_sided) << text;
  }
}

TEST(shapes, normals_agree_with_fronts) {
  for (const std::string text :
       {"teapot", "teapot?detail=40", "sphere", "icosphere", "torus", "torus?detail=100&ratio=0.8", "cube",
        "cylinder", "plane", "trefoil", "trefoil?tube=0.7", "terrain", "xfighter", "spheres"}) {
    for (const Mesh& mesh : made(text).meshes)
      EXPECT_GT(blysk::shape::worst_normal(mesh), 0.25) << text << mesh.name;
  }
  for (const std::string text : {"cube", "plane"})
    EXPECT_EQ(blysk::shape::worst_normal(made(text).meshes[0]), 1);
  for (const std::string text : {"sphere?detail=200", "icosphere?detail=100", "trefoil?detail=3000"}) {
    EXPECT_GT(blysk::shape::worst_normal(made(text).meshes[0]), 0.999) << text;
  }
}

TEST(shapes, counts_are_as_documented) {
  const auto count = [](const std::string& text) { return made(text).triangles(); };
  EXPECT_EQ(count("sphere?detail=2"), 8u);
  EXPECT_EQ(count("sphere?detail=32"), 4u * 32 * 31);
  EXPECT_EQ(count("icosphere?detail=1"), 20u);
  EXPECT_EQ(count("icosphere?detail=9"), 20u * 81);
  EXPECT_EQ(count("torus?detail=48"), 48u * 48);
  EXPECT_EQ(count("cube"), 12u);
  EXPECT_EQ(made("cube").meshes[0].positions.size(), 24u);
  EXPECT_EQ(count("cube?detail=5"), 12u * 25);
  EXPECT_EQ(count("cylinder?detail=12"), 48u);
  EXPECT_EQ(count("plane"), 2u);
  EXPECT_EQ(count("plane?detail=7"), 98u);
  EXPECT_EQ(count("trefoil?detail=80"), 2u * 80 * 10);
  EXPECT_EQ(count("terrain?detail=1"), 2u);
  EXPECT_EQ(count("triangles?count=1"), 1u);
  EXPECT_EQ(count("spheres"), 2u * 4900);
  EXPECT_EQ(count("grass"), 3000u);
  EXPECT_EQ(count("fans"), 12u * 12 * 2);
  EXPECT_EQ(count("meshes"), 3u * (2 * 76 * 37 + 2 * 54 * 54));
}

TEST(shapes, no_shape_exceeds_50_million_triangles) {
  const auto maximum = [](std::string_view shape, std::size_t parameter = 0) {
    for (const auto& info : blysk::shapes()) {
      if (info.name == shape) return info.parameters[parameter].maximum;
    }
    return 0.0;
  };
  const auto square = [](double x) { return x * x; };
  EXPECT_LE(64 * square(maximum("teapot")), 50e6);
  EXPECT_LE(4 * square(maximum("sphere")), 50e6);
  EXPECT_LE(20 * square(maximum("icosphere")), 50e6);
  EXPECT_LE(square(maximum("torus")), 50e6);
  EXPECT_LE(12 * square(maximum("cube")), 50e6);
  EXPECT_LE(4 * maximum("cylinder"), 50e6);
  EXPECT_LE(2 * square(maximum("plane")), 50e6);
  EXPECT_LE(square(maximum("trefoil")) / 4, 50e6);
  EXPECT_LE(2 * square(maximum("terrain")), 50e6);
  EXPECT_LE(maximum("triangles"), 50e6);
  EXPECT_LE(4 * square(maximum("spheres")), 50e6);
  EXPECT_LE(maximum("soup") * square(128 + 2) / 0.2, 50e6);  // triangles of size 1 have an area of 0.23
  EXPECT_LE(maximum("meshes"), 50e6);
  EXPECT_LE(maximum("grass"), 50e6);
  EXPECT_LE(24 * maximum("fans"), 50e6);
}

TEST(shapes, prefix_and_trailing_separators_are_allowed) {
  EXPECT_EQ(made("shape:cube").triangles(), 12u);
  EXPECT_EQ(made("cube?").triangles(), 12u);
  EXPECT_EQ(made("cube?detail=2&").triangles(), 48u);
  EXPECT_EQ(made("cube?detail=2e0").triangles(), 48u);
}

TEST(shapes, unknown_shapes_are_named_with_the_nearest_and_all) {
  const std::string error = refused("shape:teapott?detail=8");
  EXPECT_NE(error.find("'teapott'"), std::string::npos) << error;
  EXPECT_NE(error.find("did you mean 'teapot'?"), std::string::npos) << error;
  for (const auto& info : blysk::shapes()) EXPECT_NE(error.find(info.name), std::string::npos) << error;
  EXPECT_EQ(refused("zzz").find("did you mean"), std::string::npos);
  EXPECT_NE(refused("").find("no shape is named"), std::string::npos);
  EXPECT_NE(refused("shape:").find("teapot"), std::string::npos);
  EXPECT_NE(refused("shape:shape:cube").find("'shape:cube'"), std::string::npos);
}

TEST(shapes, unknown_keys_are_named_with_the_nearest_and_all) {
  const std::string error = refused("torus?detial=8");
  EXPECT_NE(error.find("torus has no parameter 'detial'; did you mean 'detail'? Parameters: detail, ratio"),
            std::string::npos)
      << error;
  EXPECT_NE(refused("xfighter?detail=8").find("it has none"), std::string::npos);
  EXPECT_NE(refused("cube?=3").find("''"), std::string::npos);
  EXPECT_NE(refused("cube?&detail=3").find("''"), std::string::npos);
}

TEST(shapes, values_must_be_numbers_in_their_range) {
  for (const char* value :
       {"", "0", "2001", "-1", "1.5", "x", "3x", " 3", "3 ", "nan", "inf", "1e99", "1e999", "0x3"}) {
    const std::string error = refused(std::string("cube?detail=") + value);
    EXPECT_NE(
        error.find("cube's detail must be a whole number from 1 to 2000, not '" + std::string(value) + "'"),
        std::string::npos)
        << error;
  }
  EXPECT_NE(refused("cube?detail").find("as in detail=1"), std::string::npos);
  EXPECT_NE(refused("torus?ratio=1").find("must be a number from 0.01 to 0.99"), std::string::npos);
  EXPECT_NE(refused("torus?ratio=nan").find("from 0.01 to 0.99"), std::string::npos);
  EXPECT_NE(refused("cylinder?detail=1000001").find("from 3 to 1000000,"), std::string::npos);
  EXPECT_NE(refused("cube?detail=2&detail=2").find("twice"), std::string::npos);
}

TEST(shapes, messages_stay_one_printable_line) {
  EXPECT_LT(refused(std::string(100000, 'a')).size(), 400u);
  EXPECT_NE(refused("cu\nbe\x01").find("'cu?be?'"), std::string::npos);
  EXPECT_LT(refused("cube?detail=" + std::string(100000, '9')).size(), 400u);
}

TEST(shapes, values_at_the_ends_of_their_ranges_are_taken) {
  for (const blysk::ShapeInfo& info : blysk::shapes()) {
    for (const blysk::ShapeParameter& p : info.parameters) {
      const std::string key = std::string(info.name) + "?" + std::string(p.name) + "=";
      const auto low = made(key + std::to_string(p.minimum));
      for (const Mesh& mesh : low.meshes) expect_sound(mesh, key + std::to_string(p.minimum));
      const bool large = (p.name == "detail" && info.name != "teapot") || p.name == "count";
      if (large) continue;  // no_shape_exceeds_50_million_triangles() does the sums instead
      EXPECT_GT(made(key + std::to_string(p.maximum)).triangles(), 0u);
    }
  }
}

}  // namespace
