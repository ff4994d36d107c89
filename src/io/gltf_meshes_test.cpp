#include "io/gltf_meshes.h"

#include <gtest/gtest.h>

#include <limits>

#include "io/gltf_testing.h"

namespace blysk::io::gltf_testing {
namespace {

// Six points of a zigzag, so that neighbouring triples make triangles.
Document zigzag() {
  Document d;
  d.array<float>("VEC3", 3, {0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0, 2, 0, 0, 2, 1, 0});
  return d;
}

Array<std::uint32_t> indices_of(Document d, const std::string& primitive) {
  d.primitive(primitive);
  const auto scene = read(d.gltf());
  EXPECT_TRUE(scene) << scene.error().text();
  return scene && !scene->meshes.empty() ? scene->meshes[0].indices : Array<std::uint32_t>{};
}

Mesh mesh_of(const Document& d) {
  const auto scene = read(d.gltf());
  EXPECT_TRUE(scene) << scene.error().text();
  return scene && !scene->meshes.empty() ? scene->meshes[0] : Mesh{};
}

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

}  // namespace

TEST(gltf_meshes, modes_without_indices) {
  const std::string attributes = R"("attributes":{"POSITION":0},"mode":)";
  EXPECT_EQ(indices_of(zigzag(), attributes + "4"), (Array<std::uint32_t>{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(indices_of(zigzag(), attributes + "5"),
            (Array<std::uint32_t>{0, 1, 2, 1, 3, 2, 2, 3, 4, 3, 5, 4}));
  EXPECT_EQ(indices_of(zigzag(), attributes + "6"),
            (Array<std::uint32_t>{1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 5, 0}));
}

TEST(gltf_meshes, index_types) {
  const std::string primitive = R"("attributes":{"POSITION":0},"indices":1)";
  const Array<std::uint32_t> expected{0, 1, 2, 2, 1, 3};
  Document bytes = zigzag(), shorts = zigzag(), words = zigzag();
  bytes.array<std::uint8_t>("SCALAR", 1, {0, 1, 2, 2, 1, 3});
  shorts.array<std::uint16_t>("SCALAR", 1, {0, 1, 2, 2, 1, 3});
  words.array<std::uint32_t>("SCALAR", 1, {0, 1, 2, 2, 1, 3});
  EXPECT_EQ(indices_of(bytes, primitive), expected);
  EXPECT_EQ(indices_of(shorts, primitive), expected);
  EXPECT_EQ(indices_of(words, primitive), expected);
}

TEST(gltf_meshes, joined_strips_leave_no_problem) {
  Document d = zigzag();
  d.array<std::uint8_t>("SCALAR", 1, {0, 1, 2, 2, 3, 3, 4, 5});
  d.primitive(R"("attributes":{"POSITION":0},"indices":1,"mode":5)");
  const auto scene = read(d.gltf());
  ASSERT_TRUE(scene);
  EXPECT_EQ(scene->triangles(), 2u);
  EXPECT_TRUE(scene->problems.empty());
}

TEST(gltf_meshes, corners_left_over) {
  Document d = zigzag();
  d.array<std::uint8_t>("SCALAR", 1, {0, 1, 2, 2, 3});
  d.primitive(R"("attributes":{"POSITION":0},"indices":1)");
  const auto scene = read(d.gltf());
  ASSERT_TRUE(scene);
  EXPECT_EQ(scene->triangles(), 1u);
  ASSERT_EQ(scene->problems.size(), 1u);
  EXPECT_EQ(scene->problems[0],
            "meshes[0].primitives[0]: left out the last 2 corners, which make no triangle");
}

TEST(gltf_meshes, all_attributes) {
  Document d = triangle();
  d.array<float>("VEC3", 3, {0, 0, 1, 0, 0, 2, 0, 0, 0});
  d.array<float>("VEC4", 4, {1, 0, 0, 1, 3, 0, 0, -1, 0, 0, 0, -2});
  d.array<float>("VEC2", 2, {0, 1, 0.5f, 0.25f, kNaN, kInfinity});
  d.array<std::uint8_t>("VEC2", 2, {0, 255, 51, 0, 0, 0}, R"(,"normalized":true)");
  d.array<std::uint16_t>("VEC3", 3, {65535, 0, 0, 0, 65535, 0, 0, 0, 13107});
  d.primitive(
      R"("attributes":{"POSITION":0,"NORMAL":2,"TANGENT":3,"TEXCOORD_0":4,"TEXCOORD_1":5,"COLOR_0":6})");
  const Mesh mesh = mesh_of(d);
  EXPECT_EQ(mesh.normals, (Array<Vec3f>{{0, 0, 1}, {0, 0, 1}, {0, 0, 1}}));
  EXPECT_EQ(mesh.tangents, (Array<Vec4f>{{1, 0, 0, 1}, {1, 0, 0, -1}, {1, 0, 0, -1}}));
  EXPECT_EQ(mesh.texcoords, (Array<Vec2f>{{0, 1}, {0.5f, 0.25f}, {0, 0}}));
  EXPECT_EQ(mesh.texcoords1, (Array<Vec2f>{{0, 1}, {0.2f, 0}, {0, 0}}));
  EXPECT_EQ(mesh.colors, (Array<Vec4f>{{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 0.2f, 1}}));
}

TEST(gltf_meshes, normals_of_any_length) {
  Document d = triangle();
  d.array<float>("VEC3", 3, {0, 1e-44f, 0, -3e38f, 0, 0, kNaN, 0, 0});
  d.primitive(R"("attributes":{"POSITION":0,"NORMAL":2})");
  const Mesh mesh = mesh_of(d);
  ASSERT_EQ(mesh.normals.size(), 3u);
  EXPECT_EQ(mesh.normals[0], (Vec3f{0, 1, 0}));
  for (const Vec3f& n : mesh.normals) EXPECT_NEAR(length(n), 1, 1e-6f);
}

TEST(gltf_meshes, colors_are_clamped) {
  Document d = triangle();
  d.array<float>("VEC4", 4, {2, -1, kNaN, 0.5f, kInfinity, 0, 0, 1, 0, 0, 0, 7});
  d.primitive(R"("attributes":{"POSITION":0,"COLOR_0":2})");
  EXPECT_EQ(mesh_of(d).colors, (Array<Vec4f>{{1, 0, 0, 0.5f}, {1, 0, 0, 1}, {0, 0, 0, 1}}));
}

TEST(gltf_meshes, without_normals_they_stay_empty) {
  Document d = triangle();
  d.array<float>("VEC4", 4, {1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1});
  d.primitive(R"("attributes":{"POSITION":0,"TANGENT":2})");
  const Mesh mesh = mesh_of(d);
  EXPECT_EQ(mesh.positions.size(), 3u);
  EXPECT_TRUE(mesh.normals.empty());
  EXPECT_TRUE(mesh.tangents.empty());
}

TEST(gltf_meshes, triangles_that_are_not_finite_are_left_out) {
  Document d;
  d.array<float>("VEC3", 3, {0, 0, 0, 1, 0, 0, 0, 1, 0, 5, 5, kNaN});
  d.array<std::uint8_t>("SCALAR", 1, {0, 1, 2, 0, 1, 3});
  d.primitive(R"("attributes":{"POSITION":0},"indices":1)");
  const auto scene = read(d.gltf());
  ASSERT_TRUE(scene);
  EXPECT_EQ(scene->triangles(), 1u);
  EXPECT_EQ(scene->problems.size(), 1u);
  EXPECT_EQ(scene->bounds().hi, (Vec3d{1, 1, 0}));
}

TEST(gltf_meshes, index_beyond_the_vertices) {
  Document d = zigzag();
  d.array<std::uint16_t>("SCALAR", 1, {0, 1, 2, 2, 3, 6});
  d.primitive(R"("attributes":{"POSITION":0},"indices":1)");
  EXPECT_EQ(
      error_of(d.gltf()),
      "test.gltf: meshes[0].primitives[0].indices: index 6 is beyond the 6 vertices; export the model again");
}

TEST(gltf_meshes, primitives_take_their_part_of_shared_vertices) {
  Document d = zigzag();
  d.array<std::uint16_t>("SCALAR", 1, {0, 1, 2});
  d.array<std::uint16_t>("SCALAR", 1, {3, 5, 4});
  d.more = R"(,"meshes":[{"name":"two","primitives":[{"attributes":{"POSITION":0},"indices":1},)"
           R"({"attributes":{"POSITION":0},"indices":2}]}],"nodes":[{"mesh":0}])";
  const auto scene = read(d.gltf());
  ASSERT_TRUE(scene) << scene.error().text();
  ASSERT_EQ(scene->meshes.size(), 2u);
  EXPECT_EQ(scene->meshes[1].name, "two");
  EXPECT_EQ(scene->meshes[1].positions, (Array<Vec3f>{{1, 1, 0}, {2, 0, 0}, {2, 1, 0}}));
  EXPECT_EQ(scene->meshes[1].indices, (Array<std::uint32_t>{0, 2, 1}));
}

TEST(gltf_meshes, nodes_and_materials_share_geometry) {
  Document d = triangle();
  d.more = R"(,"materials":[{"name":"red"},{"name":"blue"}],"meshes":[)"
           R"({"name":"a","primitives":[{"attributes":{"POSITION":0},"indices":1,"material":1}]},)"
           R"({"name":"b","primitives":[{"attributes":{"POSITION":0},"indices":1}]}],)"
           R"("nodes":[{"mesh":0,"name":"first"},{"mesh":0},{"mesh":1}])";
  const auto scene = read(d.gltf());
  ASSERT_TRUE(scene) << scene.error().text();
  EXPECT_EQ(scene->meshes.size(), 1u);
  ASSERT_EQ(scene->instances.size(), 3u);
  EXPECT_EQ(scene->instances[0].name, "first");
  EXPECT_EQ(scene->instances[1].name, "a");
  EXPECT_EQ(scene->instances[2].name, "b");
  EXPECT_EQ(scene->instances[1].material, 1u);
  EXPECT_EQ(scene->instances[2].material, 2u);  // the default one
  EXPECT_EQ(scene->materials.size(), 3u);
  EXPECT_EQ(scene->triangles(), 3u);
}

TEST(gltf_meshes, points_and_lines_are_counted) {
  Document d = triangle();
  d.more = R"(,"meshes":[{"primitives":[{"attributes":{"POSITION":0},"mode":0},)"
           R"({"attributes":{"POSITION":0},"mode":1},)"
           R"({"attributes":{"POSITION":0},"mode":3},{"attributes":{}},{"attributes":{"POSITION":0}}]}],)"
           R"("nodes":[{"mesh":0}])";
  const auto scene = read(d.gltf());
  ASSERT_TRUE(scene) << scene.error().text();
  EXPECT_EQ(scene->triangles(), 1u);
  EXPECT_EQ(scene->problems,
            (std::vector<std::string>{"left out 1 primitive of points; only triangles are drawn",
                                      "left out 2 primitives of lines; only triangles are drawn",
                                      "left out 1 primitive without POSITION"}));
}

TEST(gltf_meshes, what_is_wrong_with_a_primitive) {
  struct Case {
    const char* members;
    const char* error;
  };
  const Case cases[] = {
      {R"("attributes":{"POSITION":17})",
       "meshes[0].primitives[0].attributes.POSITION: accessor 17 does not exist; the file has 4"},
      {R"("attributes":{"POSITION":17,"NORMAL":0})", "accessor 17 does not exist"},
      {R"("attributes":{"POSITION":0},"indices":4)",
       "meshes[0].primitives[0].indices: accessor 4 does not exist"},
      {R"("attributes":{"POSITION":0},"indices":0)", "indices: accessor 0 must be SCALAR"},
      {R"("attributes":{"POSITION":0},"indices":3)", "indices: accessor 3 must be SCALAR of type 5121"},
      {R"("attributes":{"POSITION":0},"mode":7)", "mode: is 7; it must be a whole number from 0 to 6"},
      {R"("attributes":{"POSITION":0},"material":0)", "material: material 0 does not exist; the file has 0"},
      {R"("attributes":{"POSITION":0,"NORMAL":2})", "NORMAL: accessor 2 has 2 elements, but POSITION has 3"},
      {R"("attributes":{"POSITION":0,"TEXCOORD_0":0})", "TEXCOORD_0: accessor 0 is VEC3; it must be VEC2"},
      {R"("attributes":{"POSITION":0,"COLOR_0":1})",
       "COLOR_0: accessor 1 is SCALAR; it must be VEC3 or VEC4"},
      {R"("attributes":[0])", "attributes: is an array; it must be an object"},
      {R"("mode":4)", "meshes[0].primitives[0]: lacks \"attributes\""},
  };
  for (const Case& c : cases) {
    Document d = triangle();
    d.array<float>("VEC3", 3, {0, 0, 1, 0, 0, 1});
    d.array<std::int16_t>("SCALAR", 1, {0, 1, 2});
    d.primitive(c.members);
    EXPECT_NE(error_of(d.gltf()).find(c.error), std::string::npos) << c.members << "\n" << error_of(d.gltf());
  }
}

TEST(gltf_meshes, triangles_are_limited_before_they_are_read) {
  Document d = triangle();
  d.more = R"(,"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],)"
           R"("nodes":[{"mesh":0},{"mesh":0},{"mesh":0}])";
  EXPECT_TRUE(read(d.gltf(), {.max_triangles = 3}));
  const auto scene = read(d.gltf(), {.max_triangles = 2});
  ASSERT_FALSE(scene);
  EXPECT_EQ(scene.error().code, ErrorCode::limit);
  const auto memory = read(d.gltf(), {.max_memory = 100});
  ASSERT_FALSE(memory);
  EXPECT_EQ(memory.error().code, ErrorCode::limit);
}

TEST(gltf_meshes, repetition_is_bounded_by_the_size_of_the_file) {
  // 2000 nodes that show a mesh of 2000 primitives ask for 4 million instances with a file of 200 KB.
  Document d = triangle();
  std::string primitives, nodes;
  for (int i = 0; i < 2000; ++i) {
    primitives += std::string(i == 0 ? "" : ",") + R"({"attributes":{"POSITION":0}})";
    nodes += std::string(i == 0 ? "" : ",") + R"({"mesh":0})";
  }
  d.more = R"(,"meshes":[{"primitives":[)" + primitives + R"(]}],"nodes":[)" + nodes + "]";
  EXPECT_NE(error_of(d.gltf()).find("unpacks to more than 256 times its size"), std::string::npos);
}

}  // namespace blysk::io::gltf_testing
