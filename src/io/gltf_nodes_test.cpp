#include "io/gltf_nodes.h"

#include <gtest/gtest.h>

#include "io/gltf_testing.h"

namespace blysk::io::gltf_testing {
namespace {

// A triangle as mesh 0 with these nodes and further members.
std::string with_nodes(const std::string& nodes, const std::string& more = "") {
  Document d = triangle();
  d.more = R"(,"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"nodes":[)" + nodes + "]" + more;
  return d.gltf();
}

std::vector<std::string> names_of(const std::string& file) {
  const auto scene = read(file);
  EXPECT_TRUE(scene) << scene.error().text();
  std::vector<std::string> names;
  if (scene) {
    for (const Instance& i : scene->instances) names.push_back(i.name);
  }
  return names;
}

Mat4 transform_of(const std::string& node) {
  const auto scene = read(with_nodes(R"({"mesh":0,)" + node + "}"));
  EXPECT_TRUE(scene) << scene.error().text();
  return scene ? scene->instances[0].transform : Mat4{};
}

const std::string kThree = R"({"mesh":0,"name":"a"},{"mesh":0,"name":"b"},{"mesh":0,"name":"c"})";

}  // namespace

TEST(gltf_nodes, scale_then_rotation_then_translation) {
  // A quarter turn about z carries x to y.
  const Mat4 m = transform_of(
      R"("translation":[10,20,30],"rotation":[0,0,0.7071067811865476,0.7071067811865476],"scale":[2,3,4])");
  expect_near(transform_point(m, {1, 0, 0}), {10, 22, 30});
  expect_near(transform_point(m, {0, 1, 0}), {7, 20, 30});
  expect_near(transform_point(m, {0, 0, 1}), {10, 20, 34});
}

TEST(gltf_nodes, matrices_are_stored_by_columns) {
  const Mat4 m = transform_of(R"("matrix":[1,2,3,0,4,5,6,0,7,8,9,0,10,11,12,1])");
  EXPECT_EQ(transform_point(m, {0, 0, 0}), (Vec3d{10, 11, 12}));
  EXPECT_EQ(transform_direction(m, {1, 0, 0}), (Vec3d{1, 2, 3}));
  EXPECT_EQ(transform_direction(m, {0, 0, 1}), (Vec3d{7, 8, 9}));
}

TEST(gltf_nodes, mirrors_keep_their_sign) {
  EXPECT_EQ(determinant3(transform_of(R"("scale":[-1,2,3])")), -6);
  EXPECT_EQ(determinant3(transform_of(R"("scale":[-1,-2,3])")), 6);
}

TEST(gltf_nodes, a_bottom_row_is_not_projective) {
  const auto scene = read(with_nodes(R"({"mesh":0,"matrix":[1,0,0,5,0,1,0,0,0,0,1,0,0,0,0,1]})"));
  ASSERT_TRUE(scene);
  EXPECT_EQ(scene->instances[0].transform, Mat4{});
  EXPECT_EQ(scene->problems.size(), 1u);
}

TEST(gltf_nodes, children_stand_in_their_parents) {
  const auto scene =
      read(with_nodes(R"({"translation":[1,0,0],"children":[2]},{"mesh":0,"name":"leaf","scale":[2,2,2]},)"
                      R"({"scale":[3,3,3],"translation":[0,1,0],"children":[1]})"));
  ASSERT_TRUE(scene) << scene.error().text();
  ASSERT_EQ(scene->instances.size(), 1u);
  EXPECT_EQ(transform_point(scene->instances[0].transform, {1, 1, 1}), (Vec3d{7, 7, 6}));
}

TEST(gltf_nodes, the_scene_decides) {
  using Names = std::vector<std::string>;
  EXPECT_EQ(names_of(with_nodes(kThree)), (Names{"a", "b", "c"}));
  EXPECT_EQ(names_of(with_nodes(kThree, R"(,"scenes":[])")), (Names{"a", "b", "c"}));
  EXPECT_EQ(names_of(with_nodes(kThree, R"(,"scenes":[{"nodes":[1]},{"nodes":[2,0]}])")), (Names{"b"}));
  EXPECT_EQ(names_of(with_nodes(kThree, R"(,"scenes":[{"nodes":[1]},{"nodes":[2,0]}],"scene":1)")),
            (Names{"c", "a"}));
  EXPECT_EQ(names_of(with_nodes(kThree, R"(,"scenes":[{}])")), (Names{}));
  // A node of the scene may have a parent outside of it.
  EXPECT_EQ(names_of(with_nodes(R"({"children":[1],"translation":[1,1,1]},{"mesh":0,"name":"a"})",
                                R"(,"scenes":[{"nodes":[1]}])")),
            (Names{"a"}));
  EXPECT_EQ(names_of(with_nodes(
                R"({"children":[2,1],"mesh":0,"name":"a"},{"mesh":0,"name":"b"},{"mesh":0,"name":"c"})")),
            (Names{"a", "c", "b"}));
}

TEST(gltf_nodes, no_tree) {
  EXPECT_NE(error_of(with_nodes(R"({"children":[1]},{"children":[2]},{"children":[0]})"))
                .find("its own descendants"),
            std::string::npos);
  EXPECT_NE(
      error_of(with_nodes(R"({"children":[0]})")).find("nodes[0]: the node is among its own descendants"),
      std::string::npos);
  EXPECT_NE(error_of(with_nodes(R"({"children":[2]},{"children":[2]},{})"))
                .find("nodes[1].children[0]: nodes[2] has the parents nodes[0] and nodes[1]"),
            std::string::npos);
  EXPECT_NE(error_of(with_nodes(R"({"children":[1,1]},{})")).find("has the parents"), std::string::npos);
  EXPECT_NE(error_of(with_nodes(kThree, R"(,"scenes":[{"nodes":[1,1]}])")).find("lists the node twice"),
            std::string::npos);
  EXPECT_NE(error_of(with_nodes(R"({"children":[1]},{})", R"(,"scenes":[{"nodes":[0,1]}])")).find("twice"),
            std::string::npos);
}

TEST(gltf_nodes, deep_chains) {
  const auto chain = [](int depth) {
    std::string nodes = R"({"mesh":0})";
    for (int i = 1; i < depth; ++i) nodes += R"(,{"children":[)" + std::to_string(i - 1) + "]}";
    return with_nodes(nodes);
  };
  EXPECT_EQ(names_of(chain(4096)).size(), 1u);
  EXPECT_NE(error_of(chain(4097)).find("more than 4096 nodes deep"), std::string::npos);
}

TEST(gltf_nodes, wrong_members) {
  struct Case {
    const char* node;
    const char* error;
  };
  const Case cases[] = {
      {R"({"mesh":1})", "nodes[0].mesh: mesh 1 does not exist; the file has 1"},
      {R"({"camera":0})", "nodes[0].camera: camera 0 does not exist; the file has 0"},
      {R"({"children":[5]})", "nodes[0].children[0]: node 5 does not exist; the file has 1"},
      {R"({"children":{}})", "nodes[0].children: is an object; it must be an array"},
      {R"({"scale":[1,2]})", "nodes[0].scale: has 2 elements; it must have 3"},
      {R"({"matrix":[1,2,3]})", "nodes[0].matrix: has 3 elements; it must have 16"},
      {R"({"rotation":[0,0,0,"1"]})", "nodes[0].rotation[3]: is a string; it must be a number"},
      {R"({"scale":[1e200,1,1],"translation":[0,0,0]})", "nodes[0]: its transform is not finite"},
      {R"({"extensions":{"KHR_lights_punctual":{"light":0}}})", "light: light 0 does not exist"},
      {R"(7)", "nodes[0]: must be an object"},
  };
  for (const Case& c : cases) {
    EXPECT_NE(error_of(with_nodes(c.node)).find(c.error), std::string::npos) << c.node << "\n"
                                                                             << error_of(with_nodes(c.node));
  }
  EXPECT_NE(error_of(with_nodes(kThree, R"(,"scenes":[{"nodes":[3]}])")).find("scenes[0].nodes[0]: node 3"),
            std::string::npos);
  EXPECT_NE(error_of(with_nodes(kThree, R"(,"scenes":[{}],"scene":1)")).find("scene: scene 1 does not exist"),
            std::string::npos);
}

}  // namespace blysk::io::gltf_testing
