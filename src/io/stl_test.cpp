#include <chrono>

#include "io/testing.h"

namespace blysk::io {
namespace {

std::string triangle(Vec3f a, Vec3f b, Vec3f c) {
  return packed(0.0f, 0.0f, 0.0f, a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z, std::uint16_t{0});
}

std::string binary(std::string_view header, std::uint32_t count, std::string_view triangles) {
  std::string file(header);
  file.resize(80, ' ');
  return file + packed(count) + std::string(triangles);
}

const std::string kTwo =
    triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}) + triangle({-0.0f, 1, 0}, {1, -0.0f, 0}, {1, 1, 0});

constexpr std::string_view kFacet =
    "facet normal 0 0 1\n outer loop\n  vertex 0 0 0\n  vertex 1 0 0\n  vertex 0 1 0\n endloop\nendfacet\n";

TEST(stl, binary_is_welded_and_stays_flat) {
  const Result<Scene> scene = load_text(binary("made by hand", 2, kTwo), "x.stl");
  ASSERT_TRUE(scene) << scene.error().text();
  const Mesh& mesh = scene->meshes.at(0);
  EXPECT_EQ(mesh.positions, (Array<Vec3f>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}));
  EXPECT_EQ(mesh.indices, (Array<std::uint32_t>{0, 1, 2, 2, 1, 3}));
  EXPECT_TRUE(mesh.normals.empty());
  EXPECT_TRUE(scene->problems.empty());
  EXPECT_EQ(scene->instances.size(), 1u);
  EXPECT_EQ(scene->materials.size(), 1u);
}

TEST(stl, binary_may_call_itself_solid) {
  const Result<Scene> scene = load_text(binary("solid facet normal", 2, kTwo), "x.stl");
  ASSERT_TRUE(scene) << scene.error().text();
  EXPECT_EQ(scene->triangles(), 2u);
}

TEST(stl, binary_with_bytes_behind) {
  const Result<Scene> scene = load_text(binary("", 2, kTwo + "tail"), "x.stl");
  ASSERT_TRUE(scene);
  EXPECT_EQ(scene->problems.at(0), "ignored 4 bytes after the last of 2 triangles");
}

TEST(stl, binary_that_announces_too_much) {
  const Result<Scene> scene = load_text(binary("", 0xffffffff, kTwo), "x.stl");
  ASSERT_FALSE(scene);
  EXPECT_EQ(less_remedy(scene.error().text()),
            "x.stl: is cut short: it announces 4294967295 triangles and holds 2");
}

TEST(stl, bad_triangles_are_left_out) {
  const float nan = std::nanf("");
  const std::string bad =
      triangle({0, 0, 0}, {0, 0, 0}, {5, 5, 5}) + triangle({nan, 0, 0}, {1, 0, 0}, {0, 1, 0});
  const Result<Scene> scene = load_text(binary("", 4, bad + kTwo), "x.stl");
  ASSERT_TRUE(scene);
  expect_sound(scene->meshes[0]);
  EXPECT_EQ(scene->triangles(), 2u);
  EXPECT_EQ(scene->meshes[0].positions.size(), 4u);
  EXPECT_EQ(scene->problems.at(0), "mesh: left out 1 degenerate and 1 non-finite triangles");
}

TEST(stl, nothing_to_draw) {
  const Result<Scene> scene = load_text(binary("", 0, ""), "x.stl");
  ASSERT_FALSE(scene);
  EXPECT_EQ(scene.error().code, ErrorCode::input);
  EXPECT_FALSE(load_text("solid\nendsolid\n", "x.stl"));
}

TEST(stl, ascii_solids_are_meshes) {
  const std::string file = "solid first one\n" + std::string(kFacet) + "endsolid first one\nsolid\n" +
                           std::string(kFacet) + std::string(kFacet) + "endsolid";
  const Result<Scene> scene = load_text(file, "x.stl");
  ASSERT_TRUE(scene) << scene.error().text();
  ASSERT_EQ(scene->meshes.size(), 2u);
  EXPECT_EQ(scene->meshes[0].name, "first one");
  EXPECT_EQ(scene->instances[1].mesh, 1u);
  EXPECT_EQ(scene->meshes[1].triangles(), 2u);
  EXPECT_EQ(scene->meshes[1].positions.size(), 3u);
  EXPECT_TRUE(scene->problems.empty());
}

TEST(stl, ascii_lines_do_not_matter) {
  std::string file = "solid a\n" + std::string(kFacet) + "endsolid a\n";
  const Result<Scene> usual = load_text(file, "x.stl");
  for (std::size_t at = 0; (at = file.find('\n', at)) != std::string::npos; at += 2)
    file.replace(at, 1, "\r\n");
  const Result<Scene> crlf = load_text(file, "x.stl");
  std::string one_line(kFacet);
  for (char& c : one_line) c = c == '\n' ? ' ' : c;
  const Result<Scene> line = load_text("solid a\n" + one_line + " endsolid a", "x.stl");
  std::string capitals = "SOLID a\n" + std::string(kFacet) + "ENDSOLID a\n";
  for (char& c : capitals) c = c >= 'b' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  const Result<Scene> loud = load_text(capitals, "x.stl");
  ASSERT_TRUE(usual && crlf && line && loud);
  EXPECT_EQ(loud->meshes[0].positions, usual->meshes[0].positions);
  EXPECT_EQ(crlf->meshes[0].positions, usual->meshes[0].positions);
  EXPECT_EQ(crlf->meshes[0].name, "a");
  EXPECT_EQ(line->meshes[0].positions, usual->meshes[0].positions);
}

TEST(stl, ascii_polygons_are_cut) {
  const Result<Scene> scene = load_text(
      "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 4 0 0\nvertex 4 4 0\nvertex 3 1 0\n"
      "endloop\nendfacet\nendsolid\n",
      "x.stl");
  ASSERT_TRUE(scene) << scene.error().text();
  EXPECT_NEAR(area(scene->meshes[0]), 4, 1e-6);
}

TEST(stl, ascii_errors_have_lines) {
  const auto error = [](std::string text) { return less_remedy(load_text(text, "x.stl").error().text()); };
  EXPECT_EQ(error("solid\nfacet normal 0 0 1\nouter loop\nvertex 0 x 0\n"),
            "x.stl:4: a vertex needs three numbers");
  EXPECT_EQ(error("solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nendloop\n"),
            "x.stl:5: a facet needs three vertices");
  EXPECT_EQ(error("solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n"),
            "x.stl:5: is cut short: it ends in a facet");
  EXPECT_EQ(error("solid\nfacet normal 0 0 1\nhello\n"),
            "x.stl:3: has a word that is not of STL where a facet or a vertex should stand");
}

TEST(stl, ascii_without_endsolid_is_told) {
  const Result<Scene> scene = load_text("solid\n" + std::string(kFacet), "x.stl");
  ASSERT_TRUE(scene);
  EXPECT_EQ(scene->problems.size(), 1u);
}

TEST(stl, limits) {
  ModelOptions options;
  options.limits.max_triangles = 1;
  EXPECT_EQ(load_text(binary("", 2, kTwo), "x.stl", options).error().code, ErrorCode::limit);
  const std::string ascii = "solid\n" + std::string(kFacet) + std::string(kFacet) + "endsolid\n";
  EXPECT_EQ(load_text(ascii, "x.stl", options).error().code, ErrorCode::limit);
  options.limits = {.max_memory = 100};
  EXPECT_EQ(load_text(binary("", 2, kTwo), "x.stl", options).error().code, ErrorCode::limit);
}

TEST(stl, every_prefix_survives) {
  expect_all_prefixes_survive(binary("solid", 2, kTwo), "x.stl");
  expect_all_prefixes_survive(
      "solid a\n" + std::string(kFacet) + "endsolid a\nsolid b\n" + std::string(kFacet), "x.stl");
}

// Thousands of solids of a triangle each cost no more than their triangles.
TEST(stl, many_small_solids) {
  std::string text;
  for (int i = 0; i < 20000; ++i) {
    text +=
        "solid\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 "
        "0\nendloop\nendfacet\nendsolid\n";
  }
  const auto start = std::chrono::steady_clock::now();
  const Result<Scene> scene = load_text(text, "x.stl");
  ASSERT_TRUE(scene) << scene.error().text();
  EXPECT_EQ(scene->meshes.size(), 20000u);
  // A table for a large mesh, cleared for every solid, took five seconds.
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(2));
}

}  // namespace
}  // namespace blysk::io
