#include "io/gltf_materials.h"

#include <gtest/gtest.h>

#include "io/gltf_testing.h"

namespace blysk::io::gltf_testing {
namespace {

std::string with_material(const std::string& members, const std::string& more = "") {
  return triangle_model(R"(,"material":0)", R"(,"materials":[{)" + members + "}]" + more).gltf();
}

Material material_of(const std::string& members) {
  const auto scene = read(with_material(members));
  EXPECT_TRUE(scene) << scene.error().text();
  return scene ? scene->materials[0] : Material{};
}

std::string pbr(const std::string& members) { return R"("pbrMetallicRoughness":{)" + members + "}"; }

}  // namespace

TEST(gltf_materials, factors) {
  const Material m =
      material_of(R"("name":"paint","alphaMode":"MASK","alphaCutoff":0.25,)"
                  R"("doubleSided":true,"emissiveFactor":[0.1,0.2,0.3],)" +
                  pbr(R"("baseColorFactor":[0.2,0.4,0.6,0.8],"metallicFactor":0,"roughnessFactor":1)"));
  EXPECT_EQ(m.name, "paint");
  EXPECT_EQ(m.color, (Vec3f{0.2f, 0.4f, 0.6f}));
  EXPECT_EQ(m.opacity, 0.8f);
  EXPECT_EQ(m.alpha_mode, AlphaMode::mask);
  EXPECT_EQ(m.alpha_cutoff, 0.25f);
  EXPECT_TRUE(m.double_sided);
  EXPECT_EQ(m.emission, (Vec3f{0.1f, 0.2f, 0.3f}));
  EXPECT_EQ(m.color_texture, Material::kNoTexture);
  EXPECT_FALSE(m.unlit);
}

TEST(gltf_materials, defaults) {
  const Material m = material_of("");
  EXPECT_FALSE(m.double_sided);
  EXPECT_EQ(m.alpha_mode, AlphaMode::opaque);
  EXPECT_EQ(m.opacity, 1);
  EXPECT_EQ(m.color, (Vec3f{0.5f, 0.5f, 0.5f}));  // white metal
  const auto scene = read(triangle_model().gltf());
  ASSERT_TRUE(scene);
  ASSERT_EQ(scene->materials.size(), 1u);
  EXPECT_EQ(scene->materials[0].color, m.color);
  EXPECT_EQ(scene->materials[0].specular, m.specular);
}

TEST(gltf_materials, opaque_ignores_alpha) {
  EXPECT_EQ(material_of(pbr(R"("baseColorFactor":[1,1,1,0.3])")).opacity, 1);
  EXPECT_EQ(material_of(R"("alphaMode":"BLEND",)" + pbr(R"("baseColorFactor":[1,1,1,0.3])")).opacity, 0.3f);
}

TEST(gltf_materials, roughness_to_exponent) {
  const auto shininess = [](const char* roughness) {
    return material_of(pbr(R"("metallicFactor":0,"roughnessFactor":)" + std::string(roughness))).shininess;
  };
  EXPECT_EQ(shininess("0"), 1000);
  EXPECT_NEAR(shininess("0.5"), 30, 1e-4);
  EXPECT_EQ(shininess("1"), 1);
  EXPECT_EQ(shininess("-5"), 1000);
  EXPECT_EQ(shininess("1e300"), 1);
}

TEST(gltf_materials, highlights_grow_with_smoothness_up_to_a_bound) {
  float before = 0;
  for (int i = 10; i >= 0; --i) {
    const Material m =
        material_of(pbr(R"("metallicFactor":0,"roughnessFactor":)" + std::to_string(i / 10.0)));
    EXPECT_GE(m.specular.x, before);
    EXPECT_LE(m.specular.x, 0.801f);
    before = m.specular.x;
  }
  // Metals reflect in their own colour.
  const Material gold = material_of(pbr(R"("baseColorFactor":[1,0.75,0.25,1],"roughnessFactor":0.5)"));
  EXPECT_NEAR(gold.specular.y / gold.specular.x, 0.75, 1e-6);
  EXPECT_NEAR(gold.specular.z / gold.specular.x, 0.25, 1e-6);
  EXPECT_NEAR(gold.color.y, 0.375, 1e-6);
}

TEST(gltf_materials, unlit_shows_its_color) {
  const Material m =
      material_of(R"("extensions":{"KHR_materials_unlit":{}},)" + pbr(R"("baseColorFactor":[1,0.5,0,1])"));
  EXPECT_TRUE(m.unlit);
  EXPECT_EQ(m.color, (Vec3f{1, 0.5f, 0}));
  EXPECT_EQ(m.specular, (Vec3f{0, 0, 0}));
}

TEST(gltf_materials, colors_outside_their_range) {
  const Material m = material_of(R"("emissiveFactor":[-1,7,1e300],)" +
                                 pbr(R"("metallicFactor":0,"baseColorFactor":[2,-1,1e300,5])"));
  EXPECT_EQ(m.color, (Vec3f{1, 0, 1}));
  EXPECT_EQ(m.emission, (Vec3f{0, 1, 1}));
}

TEST(gltf_materials, textures_and_images) {
  Document d = triangle();
  const int view = d.view<std::uint8_t>({1, 2, 3});
  d.primitive(R"("attributes":{"POSITION":0},"material":0)");
  d.more += R"(,"images":[{"uri":"a%20b.png"},{"bufferView":)" + std::to_string(view) +
            R"(,"mimeType":"image/png","name":"inside"},{"uri":"data:image/jpeg;base64,AQI="}],)"
            R"("textures":[{"source":1},{"source":0},{"source":2},{"source":1},{}],"materials":[)"
            R"({"pbrMetallicRoughness":{"baseColorTexture":{"index":0}},"normalTexture":{"index":1},)"
            R"("emissiveFactor":[1,1,1],"emissiveTexture":{"index":0}},)"
            R"({"pbrMetallicRoughness":{"baseColorTexture":{"index":3}},"normalTexture":{"index":2}},)"
            R"({"normalTexture":{"index":4}}])";
  const auto scene = read(d.gltf());
  ASSERT_TRUE(scene) << scene.error().text();
  ASSERT_EQ(scene->textures.size(), 3u);
  EXPECT_EQ(scene->materials[0].color_texture, 0);
  EXPECT_EQ(scene->materials[0].normal_texture, 1);
  EXPECT_EQ(scene->materials[1].color_texture, 0);
  EXPECT_EQ(scene->materials[1].normal_texture, 2);
  EXPECT_EQ(scene->materials[2].normal_texture, Material::kNoTexture);
  EXPECT_EQ(scene->materials[0].emission, (Vec3f{0, 0, 0}));
  EXPECT_EQ(scene->textures[0].bytes, (Array<std::uint8_t>{1, 2, 3}));
  EXPECT_EQ(scene->textures[0].mime_type, "image/png");
  EXPECT_EQ(scene->textures[0].name, "inside");
  EXPECT_EQ(scene->textures[1].uri, "a%20b.png");
  EXPECT_TRUE(scene->textures[1].bytes.empty());
  EXPECT_EQ(scene->textures[2].bytes, (Array<std::uint8_t>{1, 2}));
  EXPECT_EQ(scene->textures[2].mime_type, "image/jpeg");
}

TEST(gltf_materials, wrong_members) {
  struct Case {
    std::string members;
    const char* error;
  };
  const Case cases[] = {
      {pbr(R"("baseColorFactor":[1,1,1])"),
       "materials[0].pbrMetallicRoughness.baseColorFactor: has 3 elements"},
      {pbr(R"("metallicFactor":"1")"), "metallicFactor: is a string; it must be a number"},
      {R"("pbrMetallicRoughness":1)", "pbrMetallicRoughness: is a number; it must be an object"},
      {R"("doubleSided":1)", "doubleSided: is a number; it must be a boolean"},
      {R"("normalTexture":{"index":9})", "normalTexture.index: texture 9 does not exist; the file has 1"},
      {R"("normalTexture":{})", "normalTexture: lacks \"index\""},
      {R"("normalTexture":{"index":0})", "textures[0].source: image 3 does not exist; the file has 0"},
      {R"("extensions":[])", "materials[0].extensions: is an array"},
  };
  for (const Case& c : cases) {
    const std::string error = error_of(with_material(c.members, R"(,"textures":[{"source":3}])"));
    EXPECT_NE(error.find(c.error), std::string::npos) << c.members << "\n" << error;
  }
}

}  // namespace blysk::io::gltf_testing
