#include "io/gltf_skins.h"

#include <gtest/gtest.h>

#include "io/gltf_testing.h"

namespace blysk::io::gltf_testing {
namespace {

// A skinned triangle under a node that does not count; node 1 is the joint, bound with an offset of -5 in x.
std::string skinned(const std::string& skin, const std::string& scene = "[0,1]") {
  Document d = triangle();
  d.array<float>("MAT4", 16, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -5, 0, 0, 1});
  d.more =
      R"(,"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"scenes":[{"nodes":)" + scene +
      R"(}],"nodes":[{"mesh":0,"skin":0,"translation":[100,0,0]},{"translation":[0,2,0],"scale":[3,3,3]}],)"
      R"("skins":[)" +
      skin + "]";
  return d.gltf();
}

Vec3d corner_of(const std::string& file) {
  const auto scene = read(file);
  EXPECT_TRUE(scene) << scene.error().text();
  return scene ? transform_point(scene->instances[0].transform, {1, 1, 1}) : Vec3d{};
}

}  // namespace

TEST(gltf_skins, meshes_follow_their_first_joint) {
  EXPECT_EQ(corner_of(skinned(R"({"joints":[1],"inverseBindMatrices":2})")), (Vec3d{-12, 5, 3}));
  EXPECT_EQ(corner_of(skinned(R"({"joints":[1]})")), (Vec3d{3, 5, 3}));
}

TEST(gltf_skins, without_a_skeleton_in_the_scene_the_node_counts) {
  EXPECT_EQ(corner_of(skinned(R"({"joints":[1],"inverseBindMatrices":2})", "[0]")), (Vec3d{101, 1, 1}));
  EXPECT_EQ(corner_of(skinned(R"({"joints":[]})")), (Vec3d{101, 1, 1}));
}

TEST(gltf_skins, wrong_members) {
  const auto expect = [](const std::string& skin, const std::string& error) {
    EXPECT_NE(error_of(skinned(skin)).find(error), std::string::npos) << error_of(skinned(skin));
  };
  expect(R"({"joints":[7]})", "skins[0].joints[0]: node 7 does not exist; the file has 2");
  expect(R"({"joints":[1],"inverseBindMatrices":0})",
         "inverseBindMatrices: accessor 0 must hold MAT4 of type 5126");
  expect(R"({"joints":[1],"inverseBindMatrices":9})", "inverseBindMatrices: accessor 9 does not exist");
  EXPECT_NE(error_of(skinned("")).find("nodes[0].skin: skin 0 does not exist; the file has 0"),
            std::string::npos);
}

}  // namespace blysk::io::gltf_testing
