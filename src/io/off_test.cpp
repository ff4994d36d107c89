#include "io/testing.h"
#include "math/srgb.h"

namespace blysk::io {
namespace {

const Mesh& mesh_of(const Result<Scene>& scene) {
  static const Mesh kNone;
  EXPECT_TRUE(scene) << scene.error().text();
  return scene ? scene->meshes.at(0) : kNone;
}

TEST(off, every_way_to_begin) {
  for (const char* start :
       {"OFF\n4 1 4\n", "OFF 4 1 4\n", "OFF\n# hello\n\n4 1 # edges are missing\n", "4 1 4\n",
        "OFF\r\n4 1\r\n", "OFF\n4\n1\n4\n", "# first\nOFF # second\n4 1 0\n"}) {
    const Result<Scene> scene = load_text(start + kSquareRows + "4 0 1 2 3\n", "x.off");
    const Mesh& mesh = mesh_of(scene);
    EXPECT_EQ(mesh.indices, (Array<std::uint32_t>{0, 1, 2, 0, 2, 3})) << start;
    EXPECT_TRUE(mesh.colors.empty());
  }
}

TEST(off, what_is_refused) {
  const auto error = [](const std::string& text) {
    return less_remedy(load_text(text, "x.off").error().text());
  };
  EXPECT_EQ(error("4OFF\n1 1 1\n"),
            "x.off:1: OFF in other than three dimensions (4OFF, nOFF) is not read; project it first");
  EXPECT_EQ(error("OFF BINARY\n1 1 1\n"), "x.off:1: binary OFF is not read; save the model as text");
  EXPECT_EQ(error("ODD\n1 1 1\n"), "x.off:1: does not begin with OFF");
  EXPECT_EQ(error("OFF\nmany\n"), "x.off:2: needs the numbers of its vertices and faces after OFF");
  EXPECT_EQ(error("OFF\n3 1 0\n0 0 0\n1 0 0\n0 x 0\n3 0 1 2\n"), "x.off:5: vertex 2 needs more numbers");
  EXPECT_EQ(error("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1\n"),
            "x.off:7: is cut short: face 0 needs more corners");
  for (const std::string index : {"3", "-1", "1.5", "99999999999999999999"}) {
    EXPECT_EQ(error("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 " + index + "\n"),
              "x.off:6: face 0 uses vertex " + index + ", but they count from 0 to 2; save the model again");
  }
  EXPECT_LT(error("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 " + std::string(100000, '9') + "\n").size(), 200u);
  EXPECT_EQ(error("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n-3 0 1 2\n"),
            "x.off:6: face 0 needs the number of its corners");
}

TEST(off, counts_that_lie) {
  for (const char* counts :
       {"353535235358 6 0", "4 4000000000 0", "9223372036854775807 9223372036854775807 0"}) {
    const Result<Scene> scene = load_text("OFF\n" + std::string(counts) + "\n" + kSquareRows, "x.off");
    ASSERT_FALSE(scene);
    EXPECT_EQ(scene.error().code, ErrorCode::input);
  }
  EXPECT_FALSE(load_text("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n2000000000 0 1 2\n", "x.off"));
}

TEST(off, vertex_colors_whole_and_fractional) {
  const std::string whole = "COFF\n3 1 0\n0 0 0 255 51 0 128\n1 0 0 0 0 0\n0 1 0 0 0 0 255\n3 0 1 2\n";
  const Result<Scene> scene = load_text(whole, "x.off");
  EXPECT_EQ(
      mesh_of(scene).colors,
      (Array<Vec4f>{{1, srgb_to_linear(std::uint8_t{51}), 0, 128.0f / 255}, {0, 0, 0, 1}, {0, 0, 0, 1}}));
  const std::string fractional = "COFF\n3 1 0\n0 0 0 1 0.2 0 0.5\n1 0 0 0 0 0 1\n0 1 0 0 0 0 1\n3 0 1 2\n";
  const Result<Scene> second = load_text(fractional, "x.off");
  const Vec4f color = mesh_of(second).colors.at(0);
  EXPECT_EQ(color.x, 1.0f);
  EXPECT_NEAR(color.y, srgb_to_linear(std::uint8_t{51}), 1e-6f);
  EXPECT_EQ(color.w, 0.5f);
}

TEST(off, all_prefixes_together) {
  const Result<Scene> scene = load_text(
      "STCNOFF\n3 1 0\n0 0 0 0 0 1 1 0 0 0.5 0.25\n1 0 0 0 0 1 0 1 0 1 0 1\n0 1 0 0 0 2 0 0 1 0 1\n3 0 1 2\n",
      "x.off");
  const Mesh& mesh = mesh_of(scene);
  EXPECT_EQ(mesh.normals, (Array<Vec3f>{{0, 0, 1}, {0, 0, 1}, {0, 0, 1}}));
  EXPECT_EQ(mesh.texcoords, (Array<Vec2f>{{0.5f, 0.25f}, {0, 1}, {0, 1}}));
  EXPECT_EQ(mesh.colors[0], (Vec4f{1, 0, 0, 1}));
}

TEST(off, faces_show_their_own_colors) {
  const Result<Scene> scene = load_text(
      "OFF\n4 3 0\n" + kSquareRows + "3 0 1 2  1 0 0\n3 0 2 3\n3 1 2 3 0 0 1 0.5 # blue\n", "x.off");
  const Mesh& mesh = mesh_of(scene);
  expect_sound(mesh);
  ASSERT_EQ(mesh.triangles(), 3u);
  const Vec4f expected[] = {{1, 0, 0, 1}, {0.8f, 0.8f, 0.8f, 1}, {0, 0, 1, 0.5f}};
  for (std::size_t i = 0; i < 9; ++i) EXPECT_EQ(mesh.colors[mesh.indices[i]], expected[i / 3]) << i;
  EXPECT_EQ(scene->materials.at(0).color, (Vec3f{1, 1, 1}));
}

// A vertex of very many faces, each of its own colour, must not take squared time.
TEST(off, many_colors_at_one_vertex) {
  constexpr int kFaces = 60000;
  std::string file = "OFF\n" + std::to_string(kFaces + 2) + " " + std::to_string(kFaces) + " 0\n0 0 0\n";
  for (int i = 0; i <= kFaces; ++i) file += std::to_string(i) + " 1 0\n";
  for (int i = 1; i <= kFaces; ++i) {
    file += "3 0 " + std::to_string(i) + " " + std::to_string(i + 1) + " 0." + std::to_string(100000 + i) +
            " 0 0\n";
  }
  const Result<Scene> scene = load_text(file, "x.off");
  expect_sound(mesh_of(scene));
  EXPECT_EQ(scene->triangles(), std::uint64_t{kFaces});
}

TEST(off, all_on_one_line_does_not_take_long) {
  constexpr int kVertices = 200'000;
  std::string file = "COFF " + std::to_string(kVertices) + " 1 0";
  for (int i = 0; i < kVertices; ++i) {
    file += ' ';
    file += std::to_string(i);
    file += i % 2 == 0 ? " 0 0 0 0 0 1" : " 1 0 0 0 0 1";
  }
  const Result<Scene> scene = load_text(file + " 3 0 1 2", "x.off");
  EXPECT_EQ(mesh_of(scene).triangles(), 1u);
}

TEST(off, every_prefix_survives) {
  expect_all_prefixes_survive("OFF\n4 2 0\n" + kSquareRows + "3 0 1 2 255 0 0\n3 0 2 3\n", "x.off");
  expect_all_prefixes_survive("STCNOFF\n1 1 0\n0 0 0 0 0 1 1 0 0 0.5 0.25\n1 0\n", "x.off");
}

TEST(off, geomview_cube_has_six_colored_sides) {
  const std::string models = BLYSK_MODELS;
  if (models.empty()) GTEST_SKIP() << "BLYSK_MODELS names no folder of models";
  const Result<Scene> scene = load_model(models + "/mesh/geomview_cube.off");
  const Mesh& mesh = mesh_of(scene);
  EXPECT_EQ(mesh.triangles(), 12u);
  EXPECT_EQ(mesh.positions.size(), 24u);
  EXPECT_NEAR(mesh.colors.at(0).x, srgb_to_linear(0.784f), 1e-6f);
}

}  // namespace
}  // namespace blysk::io
