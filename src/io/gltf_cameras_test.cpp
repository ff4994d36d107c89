#include "io/gltf_cameras.h"

#include <gtest/gtest.h>

#include "io/gltf_testing.h"
#include "math/trig.h"

namespace blysk::io::gltf_testing {
namespace {

// A triangle and further nodes.
Result<Scene> scene_with(const std::string& nodes, const std::string& more) {
  Document d = triangle();
  d.more = R"(,"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"nodes":[{"mesh":0},)" + nodes +
           "]" + more;
  return read(d.gltf());
}

std::string lights(const std::string& list) {
  return R"(,"extensions":{"KHR_lights_punctual":{"lights":[)" + list + "]}}";
}

std::string light_node(int index, const std::string& more = "") {
  return R"({"extensions":{"KHR_lights_punctual":{"light":)" + std::to_string(index) + "}}" + more + "}";
}

// A quarter turn about y: what looks along -z then looks along -x.
const std::string kTurned = R"("rotation":[0,0.7071067811865476,0,0.7071067811865476])";

}  // namespace

TEST(gltf_cameras, perspective) {
  const auto scene =
      scene_with(R"({"camera":0,"translation":[1,2,3],"scale":[5,5,5],"name":"node",)" + kTurned + "}",
                 R"(,"cameras":[{"type":"perspective","perspective":{"yfov":0.5,"znear":0.1}}])");
  ASSERT_TRUE(scene) << scene.error().text();
  ASSERT_EQ(scene->cameras.size(), 1u);
  const Camera& camera = scene->cameras[0];
  expect_near(camera.eye, {1, 2, 3});
  expect_near(camera.target, {0, 2, 3});
  expect_near(camera.up, {0, 1, 0});
  EXPECT_NEAR(camera.fov_deg, 0.5 * 180 / kPi, 1e-12);
  EXPECT_EQ(camera.height, 0);
  EXPECT_EQ(camera.near_distance, 0.1);
  EXPECT_EQ(camera.far_distance, 0);
  EXPECT_EQ(camera.name, "node");
}

TEST(gltf_cameras, orthographic) {
  const auto scene =
      scene_with(R"({"camera":0})", R"(,"cameras":[{"name":"top","type":"orthographic",)"
                                    R"("orthographic":{"xmag":2,"ymag":1.5,"znear":0.01,"zfar":100}}])");
  ASSERT_TRUE(scene) << scene.error().text();
  ASSERT_EQ(scene->cameras.size(), 1u);
  EXPECT_EQ(scene->cameras[0].height, 3);
  EXPECT_EQ(scene->cameras[0].far_distance, 100);
  EXPECT_EQ(scene->cameras[0].target, (Vec3d{0, 0, -1}));
  EXPECT_EQ(scene->cameras[0].name, "top");
}

TEST(gltf_cameras, unusable_ones_are_left_out) {
  const auto scene =
      scene_with(R"({"camera":0},{"camera":1},{"camera":2},{"camera":3})",
                 R"(,"cameras":[{"type":"fisheye"},{"type":"perspective","perspective":{"yfov":-1}},)"
                 R"({"type":"orthographic"},{"type":"perspective","perspective":{"yfov":3.1}}])");
  ASSERT_TRUE(scene) << scene.error().text();
  ASSERT_EQ(scene->cameras.size(), 1u);
  EXPECT_EQ(scene->cameras[0].fov_deg, 170);
  EXPECT_EQ(scene->problems.size(), 3u);
}

TEST(gltf_lights, directions_and_positions) {
  const auto scene = scene_with(
      light_node(0, ",\"scale\":[3,3,3]," + kTurned) + "," + light_node(1, R"(,"translation":[0,4,0])"),
      lights(R"({"type":"directional","name":"sun","color":[1,0.5,0],"intensity":3},{"type":"point"})"));
  ASSERT_TRUE(scene) << scene.error().text();
  ASSERT_EQ(scene->lights.size(), 2u);
  EXPECT_EQ(scene->lights[0].kind, Light::Kind::directional);
  expect_near(scene->lights[0].vector, {1, 0, 0});  // towards the light, away from where it shines
  EXPECT_EQ(scene->lights[0].name, "sun");
  EXPECT_EQ(scene->lights[0].color, (Vec3f{1, 0.5f, 0}));
  EXPECT_EQ(scene->lights[1].kind, Light::Kind::point);
  expect_near(scene->lights[1].vector, {0, 4, 0});
  EXPECT_LT(scene->lights[1].color.x, 0.05f);
}

TEST(gltf_lights, brightness_is_relative) {
  const auto colors = [](const std::string& a, const std::string& b, const std::string& c) {
    const auto lamp = [](const std::string& intensity) {
      return R"({"type":"directional","intensity":)" + intensity + "}";
    };
    const auto scene = scene_with(light_node(0) + "," + light_node(1) + "," + light_node(2),
                                  lights(lamp(a) + "," + lamp(b) + "," + lamp(c)));
    EXPECT_TRUE(scene) << scene.error().text();
    std::vector<float> values;
    for (const Light& light : scene->lights) values.push_back(light.color.x);
    return values;
  };
  EXPECT_EQ(colors("1000", "500", "250"), (std::vector<float>{1, 0.5f, 0.25f}));
  EXPECT_EQ(colors("1", "1", "2"), (std::vector<float>{0.5f, 0.5f, 1}));
  EXPECT_EQ(colors("3", "3", "6"), (std::vector<float>{0.5f, 0.5f, 1}));
  EXPECT_EQ(colors("4", "4", "4"), (std::vector<float>{2.0f / 3, 2.0f / 3, 2.0f / 3}));
  EXPECT_EQ(colors("0", "-2", "1e300"), (std::vector<float>{}));
}

TEST(gltf_lights, spots_and_unknown_types) {
  const auto spot = scene_with(light_node(0), lights(R"({"type":"spot","spot":{}})"));
  ASSERT_TRUE(spot);
  EXPECT_EQ(spot->lights[0].kind, Light::Kind::point);
  ASSERT_EQ(spot->problems.size(), 1u);
  EXPECT_NE(spot->problems[0].find("lights[0]: a spot light shines to all sides"), std::string::npos);
  const auto unknown = scene_with(light_node(0), lights(R"({"type":"tube"})"));
  ASSERT_FALSE(unknown);
  EXPECT_NE(unknown.error().message.find("\"tube\" is none of"), std::string::npos);
}

}  // namespace blysk::io::gltf_testing
