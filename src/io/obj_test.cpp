#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>

#include "io/obj_mesh.h"
#include "io/obj_parse.h"
#include "io/reader.h"
#include "io/testing.h"
#include "math/srgb.h"

namespace blysk::io {
namespace {

const std::string kTriangleText = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
const std::string kSquareText = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

Result<Scene> read_text(std::string_view text, int threads = 1, const std::filesystem::path& folder = {}) {
  Source source;
  source.bytes = std::as_bytes(std::span(text));
  source.name = "model.obj";
  source.folder = folder;
  source.options.threads = threads;
  return read_obj(source);
}

Scene scene_of(std::string_view text) {
  Result<Scene> scene = read_text(text);
  EXPECT_TRUE(scene) << scene.error().text();
  return scene ? std::move(*scene) : Scene{};
}

Mesh mesh_of(std::string_view text) {
  Scene scene = scene_of(text);
  EXPECT_EQ(scene.meshes.size(), 1u);
  return scene.meshes.empty() ? Mesh{} : std::move(scene.meshes[0]);
}

void expect_error(std::string_view text, std::string_view message) {
  const Result<Scene> scene = read_text(text);
  ASSERT_FALSE(scene) << text;
  EXPECT_EQ(scene.error().code, ErrorCode::input);
  EXPECT_EQ(less_remedy(scene.error().text()), message);
}

std::string problems_of(const Scene& scene) {
  std::string all;
  for (const std::string& p : scene.problems) all += p + "\n";
  return all;
}

template <class T>
bool same_bytes(const Array<T>& a, const Array<T>& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

void expect_same(const Scene& a, const Scene& b) {
  ASSERT_EQ(a.meshes.size(), b.meshes.size());
  for (std::size_t i = 0; i < a.meshes.size(); ++i) {
    EXPECT_EQ(a.meshes[i].name, b.meshes[i].name);
    EXPECT_TRUE(same_bytes(a.meshes[i].positions, b.meshes[i].positions));
    EXPECT_TRUE(same_bytes(a.meshes[i].normals, b.meshes[i].normals));
    EXPECT_TRUE(same_bytes(a.meshes[i].colors, b.meshes[i].colors));
    EXPECT_TRUE(same_bytes(a.meshes[i].texcoords, b.meshes[i].texcoords));
    EXPECT_TRUE(same_bytes(a.meshes[i].indices, b.meshes[i].indices));
  }
  EXPECT_EQ(a.problems, b.problems);
}

TEST(obj, a_triangle) {
  const Scene scene = scene_of(kTriangleText + "f 1 2 3\n");
  ASSERT_EQ(scene.meshes.size(), 1u);
  const Mesh& mesh = scene.meshes[0];
  ASSERT_EQ(mesh.positions.size(), 3u);
  EXPECT_EQ(mesh.positions[1], (Vec3f{1, 0, 0}));
  EXPECT_EQ(mesh.indices, (Array<std::uint32_t>{0, 1, 2}));
  EXPECT_TRUE(mesh.normals.empty() && mesh.texcoords.empty() && mesh.colors.empty());
  EXPECT_TRUE(scene.problems.empty());
  ASSERT_EQ(scene.instances.size(), 1u);
  EXPECT_EQ(scene.materials.size(), 1u);
}

TEST(obj, white_space_line_ends_comments_and_case) {
  const Mesh expected = mesh_of(kTriangleText + "f 1 2 3\n");
  for (const char* text : {
           "v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3\r\n",
           "v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3\r",
           "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3",

           "  \t v\t0  0 0 \n\n\n v 1 0 0\t\n   # x\n\t\nv 0 1 0 # y\nf\t1  2\t3 # z\n",
           "v 0 0\\\n 0\nv 1 \\\r\n0 0\nv 0 1 0\nf 1 \\\n\\\n 2 3\\",
           "# C:\\models\\\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n#\\",
           "v +0 -0.0 0e5\nv 1.e0 .0 0\nv 0 .1e1 -0\nf 1 2 3\n",
           "g a b\nv 0 0 0\nv 1 0 0\nv 0 1 0\ng\nf 1 2 3\n",
       }) {
    const Mesh mesh = mesh_of(text);
    EXPECT_EQ(mesh.positions, expected.positions) << text;
    EXPECT_EQ(mesh.indices, expected.indices) << text;
  }
}

TEST(obj, the_forms_of_a_corner) {
  const std::string lists = kTriangleText + "vt .5 .25\nvt 1 0\nvn 0 0 2\n";
  const Mesh both = mesh_of(lists + "f 1/1/1 2/2/1 3/1/1\n");
  EXPECT_EQ(both.texcoords, (Array<Vec2f>{{.5f, .25f}, {1, 0}, {.5f, .25f}}));
  EXPECT_EQ(both.normals, (Array<Vec3f>{{0, 0, 1}, {0, 0, 1}, {0, 0, 1}}));
  const Mesh normals = mesh_of(lists + "f 1//1 2//1 3//1\n");
  EXPECT_TRUE(normals.texcoords.empty());
  EXPECT_EQ(normals.normals.size(), 3u);
  for (const char* face : {"f 1/1 2/2 3/1\n", "f 1/1/ 2/2/ 3/1/\n", "f -3/-2 -2/-1 -1/-2\n"}) {
    const Mesh texcoords = mesh_of(lists + face);
    EXPECT_EQ(texcoords.texcoords, both.texcoords);
    EXPECT_TRUE(texcoords.normals.empty());
  }
  EXPECT_TRUE(mesh_of(lists + "f 1// 2// 3//\n").normals.empty());
}

TEST(obj, vertices_are_the_distinct_corners) {
  const Mesh mesh = mesh_of(kSquareText + "vt 0 0\nvt 1 1\nf 1/1 2/1 3/1\nf 1/1 3/1 4/1\nf 1/2 3/1 4/1\n");
  EXPECT_EQ(mesh.positions.size(), 5u);
  EXPECT_EQ(mesh.indices, (Array<std::uint32_t>{0, 1, 2, 0, 2, 3, 4, 2, 3}));
}

// Lists that run along with the positions are taken as they are: no vertex is split or reordered.
TEST(obj, parallel_lists_keep_their_order) {
  const Mesh mesh = mesh_of("vt 0 1\nvt 0 2\nvt 0 3\n" + kTriangleText + "f 3/3 2/2 1/1\n");
  EXPECT_EQ(mesh.indices, (Array<std::uint32_t>{2, 1, 0}));
  EXPECT_EQ(mesh.texcoords, (Array<Vec2f>{{0, 1}, {0, 2}, {0, 3}}));
}

TEST(obj, mixed_corners_get_what_they_lack) {
  const Mesh mesh = mesh_of(kSquareText + "vt 5 6\nvn 1 0 0\nf 1/1/1 2/1/1 3/1/1\nf 1 3 4\n");
  ASSERT_EQ(mesh.texcoords.size(), 6u);
  EXPECT_EQ(mesh.texcoords[0], (Vec2f{5, 6}));
  EXPECT_EQ(mesh.texcoords[5], (Vec2f{0, 0}));
  EXPECT_EQ(mesh.normals[0], (Vec3f{1, 0, 0}));
  EXPECT_EQ(mesh.normals[5], (Vec3f{0, 0, 1}));
}

TEST(obj, normals_become_unit_or_are_made) {
  const Mesh mesh = mesh_of(kTriangleText + "vn 0 3 4\nvn 0 0 0\nvn nan 0 1\nf 1//1 2//2 3//3\n");
  ASSERT_EQ(mesh.normals.size(), 3u);
  EXPECT_FLOAT_EQ(mesh.normals[0].y, 0.6f);
  EXPECT_FLOAT_EQ(mesh.normals[0].z, 0.8f);
  EXPECT_EQ(mesh.normals[1], (Vec3f{0, 0, 1}));
  EXPECT_EQ(mesh.normals[2], (Vec3f{0, 0, 1}));
}

TEST(obj, faces_may_stand_before_their_vertices) {
  EXPECT_EQ(mesh_of("f 1 2 3\n" + kTriangleText).triangles(), 1u);
}

TEST(obj, negative_indices_count_from_the_face) {
  const Mesh mesh = mesh_of(kTriangleText + "f -3 -2 -1\nv 5 5 5\nf -4 -3 -1\n");
  EXPECT_EQ(mesh.indices, (Array<std::uint32_t>{0, 1, 2, 0, 1, 3}));
}

TEST(obj, polygons_become_triangles) {
  EXPECT_EQ(mesh_of(kSquareText + "f 1 2 3 4\n").indices, (Array<std::uint32_t>{0, 1, 2, 0, 2, 3}));
  // A dart: the fan from its first corner would leave it.
  const Mesh dart = mesh_of("v 0 0 0\nv 1 4 0\nv 0 1 0\nv -1 4 0\nv 9 9 9\nv 9 9 8\nf 2 3 4 1\nf 1 5 6\n");
  EXPECT_EQ(dart.triangles(), 3u);
  double area = 0;
  for (std::size_t i = 0; i < 6; i += 3) {
    const Vec3f a = dart.positions[dart.indices[i]];
    const Vec3f n = cross(dart.positions[dart.indices[i + 1]] - a, dart.positions[dart.indices[i + 2]] - a);
    area += std::abs(static_cast<double>(n.z)) / 2;
  }
  EXPECT_DOUBLE_EQ(area, 1);
  // The same through the table of vertices.
  EXPECT_EQ(mesh_of("vt 0 0\n" + kSquareText + "f 1/1 2/1 3/1 4/1\nf 1/1 2/1 3/1\n").indices,
            (Array<std::uint32_t>{0, 1, 2, 0, 2, 3, 0, 1, 2}));
}

TEST(obj, weights_are_ignored_and_colours_decoded) {
  EXPECT_TRUE(mesh_of("v 0 0 0 .1\nv 1 0 0 .2\nv 0 1 0 .3\nf 1 2 3\n").colors.empty());
  const Mesh mesh = mesh_of("v 0 0 0\nv 1 0 0 1 .5 0\nv 0 1 0 2 -1 nan\nf 1 2 3\n");
  ASSERT_EQ(mesh.colors.size(), 3u);
  EXPECT_EQ(mesh.colors[0], (Vec4f{1, 1, 1, 1}));
  EXPECT_EQ(mesh.colors[1], (Vec4f{1, srgb_to_linear(.5f), 0, 1}));
  EXPECT_EQ(mesh.colors[2], (Vec4f{1, 0, 0, 1}));
  EXPECT_EQ(mesh_of("v 0 0 0 # 1 2 3\nv 1 0 0 x\nv 0 1 0\nf 1 2 3\n").colors.size(), 0u);
}

TEST(obj, triangles_that_are_not_finite_are_left_out) {
  const Scene scene =
      scene_of(kTriangleText + "v nan -nan 1.#IND\nv inf -1.#INF 1e999\nf 1 2 3\nf 1 2 4\nf 1 2 5\n");
  EXPECT_EQ(scene.triangles(), 1u);
  EXPECT_EQ(scene.meshes[0].positions.size(), 3u);
  EXPECT_EQ(scene.problems.size(), 1u);
}

TEST(obj, one_mesh_for_each_material) {
  const Scene scene = scene_of(
      kSquareText + "usemtl red\no one\nf 1 2 3\nusemtl blue paint \nf 2 3 4\nusemtl red\nf 1 3 4\n");
  ASSERT_EQ(scene.meshes.size(), 2u);
  EXPECT_EQ(scene.meshes[0].triangles(), 2u);
  EXPECT_EQ(scene.meshes[0].positions.size(), 4u);
  EXPECT_EQ(scene.meshes[1].positions, (Array<Vec3f>{{1, 0, 0}, {1, 1, 0}, {0, 1, 0}}));
  EXPECT_EQ(scene.materials[0].name, "red");
  EXPECT_EQ(scene.materials[1].name, "blue paint");
  EXPECT_EQ(scene.instances[1].mesh, 1u);
  EXPECT_EQ(scene.instances[1].material, 1u);
  EXPECT_EQ(scene.instances[1].name, "one");
  EXPECT_EQ(problems_of(scene), "no material file defines 'red', 'blue paint', so the default stands in\n");
}

// A group may come again, two may share a material, and two objects may have a group of the same name.
TEST(obj, one_mesh_for_each_object_and_group) {
  const Scene scene = scene_of(kSquareText +
                               "usemtl red\no body\nf 1 2 3\ng left  wing\nf 2 3 4\ng empty\no body\n"
                               "f 1 3 4\nusemtl blue\nf 1 2 4\no tail\ng left  wing\nf 1 2 3\n");
  ASSERT_EQ(scene.meshes.size(), 4u);
  EXPECT_EQ(scene.meshes[0].name, "body");
  EXPECT_EQ(scene.meshes[0].triangles(), 2u);
  EXPECT_EQ(scene.meshes[1].name, "body/left  wing");
  EXPECT_EQ(scene.meshes[1].positions.size(), 3u);
  EXPECT_EQ(scene.meshes[2].name, "body");
  EXPECT_EQ(scene.meshes[3].name, "tail/left  wing");
  ASSERT_EQ(scene.materials.size(), 2u);
  EXPECT_EQ(scene.instances[1].material, 0u);
  EXPECT_EQ(scene.instances[2].material, 1u);
}

TEST(obj, many_groups_are_not_kept_apart) {
  for (const std::size_t groups : {kMostGroups, kMostGroups + 1}) {
    std::string text = kTriangleText;
    for (std::size_t i = 0; i < groups; ++i) text += "g " + std::to_string(i) + "\nf 1 2 3\ng none\n";
    const Scene scene = scene_of(text);
    EXPECT_EQ(scene.meshes.size(), groups == kMostGroups ? groups : 1);
    EXPECT_EQ(scene.triangles(), groups);
    EXPECT_EQ(scene.problems.size(), groups == kMostGroups ? 0u : 1u);
  }
}

TEST(obj, names_of_meshes) {
  EXPECT_EQ(scene_of("o a b\n" + kTriangleText + "f 1 2 3\n").instances[0].name, "a b");
  EXPECT_EQ(scene_of("o a\n" + kTriangleText + "o b\nf 1 2 3\n").instances[0].name, "b");
  EXPECT_EQ(scene_of("usemtl red\n" + kTriangleText + "f 1 2 3\n").meshes[0].name, "red");
  EXPECT_EQ(scene_of("o a\x1b[2J\n" + kTriangleText + "f 1 2 3\n").instances[0].name, "a?[2J");
}

// Two squares that meet at a right angle along vertices 2 and 3.
const std::string kRoof = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 1 0 1\nv 1 1 1\n";

TEST(obj, a_smoothing_group_is_smooth_and_off_is_flat) {
  const Mesh smooth = mesh_of(kRoof + "s 1\nf 1 2 3 4\nf 5 6 3 2\n");
  ASSERT_EQ(smooth.positions.size(), 6u);
  EXPECT_FLOAT_EQ(smooth.normals[1].z, std::sqrt(0.5f));
  EXPECT_FLOAT_EQ(std::abs(smooth.normals[1].x), std::sqrt(0.5f));
  EXPECT_EQ(smooth.normals[0], (Vec3f{0, 0, 1}));

  const Mesh groups = mesh_of(kRoof + "s 1\nf 1 2 3 4\ns 2\nf 5 6 3 2\n");
  EXPECT_EQ(groups.positions.size(), 8u);
  EXPECT_EQ(groups.normals[1], (Vec3f{0, 0, 1}));

  for (const char* off : {"s off\n", "s 0\n", "s\n"}) {
    const Mesh flat = mesh_of(kRoof + "s 1\nf 1 2 3 4\n" + off + "f 5 6 3 2\nf 6 5 1\n");
    EXPECT_EQ(flat.positions.size(), 11u) << off;
    EXPECT_EQ(std::abs(flat.normals[4].x), 1) << off;
  }
}

TEST(obj, groups_smooth_across_materials) {
  const Scene scene = scene_of(kRoof + "s 1\nusemtl a\nf 1 2 3 4\nusemtl b\nf 5 6 3 2\n");
  ASSERT_EQ(scene.meshes.size(), 2u);
  EXPECT_EQ(scene.meshes[0].normals[1], scene.meshes[1].normals[3]);
}

// Three squares in a row, bent by 45 degrees each, in two materials.
TEST(obj, creases_are_found_across_materials) {
  const std::string text =
      "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 1.7 0 -.7\nv 1.7 1 -.7\nv 1.7 0 -1.7\nv 1.7 1 -1.7\nv nan 0 0\n"
      "usemtl a\nf 1 2 3 4\nf 5 7 8 6\nf 2 3 9\nusemtl b\nf 2 5 6 3\n";
  const Scene scene = scene_of(text);
  ASSERT_EQ(scene.meshes.size(), 2u);
  const Mesh &a = scene.meshes[0], &b = scene.meshes[1];
  EXPECT_EQ(a.triangles(), 4u);
  int shared = 0;
  for (std::size_t i = 0; i < a.positions.size(); ++i) {
    for (std::size_t j = 0; j < b.positions.size(); ++j) {
      if (a.positions[i] != b.positions[j]) continue;
      ++shared;
      EXPECT_EQ(a.normals[i], b.normals[j]);
      EXPECT_GT(a.normals[i].x, 0.2f);
      EXPECT_LT(a.normals[i].x, 0.99f);
    }
  }
  EXPECT_EQ(shared, 4);
  Source source;
  source.bytes = std::as_bytes(std::span(text));
  source.options.crease_deg = 0;
  EXPECT_TRUE(read_obj(source)->meshes[1].normals.empty());
  source.options.crease_deg = 30;
  EXPECT_EQ(read_obj(source)->meshes[0].normals[1], (Vec3f{0, 0, 1}));
}

TEST(obj, normals_of_the_file_go_before_groups) {
  const Mesh mesh = mesh_of(kTriangleText + "vn 1 0 0\ns 1\nf 1//1 2//1 3//1\n");
  EXPECT_EQ(mesh.normals[0], (Vec3f{1, 0, 0}));
  EXPECT_TRUE(mesh_of(kTriangleText + "s off\nf 1 2 3\n").normals.empty());
}

TEST(obj, what_is_left_out_is_told) {
  const Scene scene =
      scene_of(kTriangleText + "p 1\nl 1 2\nl 2 3\nvp 1 2\nf 1 2\ncurv 1\nf\nf 1 2 3\nvw 1 1\n");
  EXPECT_EQ(scene.triangles(), 1u);
  EXPECT_EQ(problems_of(scene),
            "left out 2 faces of fewer than 3 corners, the first in line 8\n"
            "left out 1 point statement\n"
            "left out 2 line statements\n"
            "left out 3 statements that Blysk does not know, the first is 'vp' in line 7\n");
}

TEST(obj, attributes_that_the_file_does_not_have_at_all) {
  const Scene scene = scene_of(kTriangleText + "f 1/1/1 2/2/-2 3/99/0\n");
  EXPECT_EQ(scene.triangles(), 1u);
  EXPECT_TRUE(scene.meshes[0].normals.empty() && scene.meshes[0].texcoords.empty());
  EXPECT_EQ(problems_of(scene),
            "faces refer to texture coordinates, but the file has none\n"
            "faces refer to normals, but the file has none\n");
}

TEST(obj, wrong_indices) {
  expect_error(kTriangleText + "\nf 1 2 4\n", "model.obj:5: a face uses vertex 4, but the file has only 3");
  expect_error(kTriangleText + "f 1 2 -4\n",
               "model.obj:4: a face uses vertex -4, but only 3 stand before it");
  expect_error("f -1 -1 -1\n" + kTriangleText,
               "model.obj:1: a face uses vertex -1, but only 0 stand before it");
  expect_error(kTriangleText + "f 0 1 2\n", "model.obj:4: a face uses vertex 0, but they count from 1 to 3");
  expect_error(kTriangleText + "f 1 2 99999999999999999999\n",
               "model.obj:4: a face uses vertex 1099511627776, but the file has only 3");
  expect_error("f 1 2 3\n", "model.obj:1: a face uses vertex 1, but the file has none");
  expect_error("vt 0 0\n" + kTriangleText + "f 1/1 2/2 3/1\n",
               "model.obj:5: a face uses texture coordinate 2, but the file has only 1");
  expect_error("vn 0 0 1\n" + kTriangleText + "f 1//1 2//1 3//0\n",
               "model.obj:5: a face uses normal 0, but they count from 1 to 1");
}

TEST(obj, wrong_statements) {
  const std::string corner = "model.obj:4: a face corner must be an index or index/index/index, not ";
  expect_error(kTriangleText + "f 1 2 x\n", corner + "'x'");
  expect_error(kTriangleText + "f 1 2 3.5\n", corner + "'3.5'");
  expect_error(kTriangleText + "f 1 2 /3\n", corner + "'/3'");
  expect_error(kTriangleText + "f 1 2 -\n", corner + "'-'");
  expect_error("vt 0 0\nvn 0 0 1\nv 0 0 0\nf 1/1/1/1 1 1\n", corner + "'1/1/1/1'");
  expect_error(kTriangleText + "f 1 2 3\x1b[31m\n", corner + "'[31m'");
  expect_error("v 0 0 0\nv 1 2\n", "model.obj:2: a vertex needs three numbers, this one has 2");
  expect_error("v\n", "model.obj:1: a vertex needs three numbers, this one has 0");
  expect_error("v 1,5 2 3\n", "model.obj:1: a vertex needs three numbers, this one has 0");
  expect_error("\r\r\rv 1 x 3\r", "model.obj:4: a vertex needs three numbers, this one has 1");
  expect_error("v 1 \\\n2\n", "model.obj:1: a vertex needs three numbers, this one has 2");
  expect_error("vt\n", "model.obj:1: a texture coordinate needs a number");
  expect_error("vn 1 0\n", "model.obj:1: a normal needs three numbers, this one has 2");
}

TEST(obj, no_faces) {
  const auto problems = [](const std::string& text) {
    const Scene scene = scene_of(text);
    EXPECT_TRUE(scene.meshes.empty() && scene.instances.empty());
    return problems_of(scene);
  };
  EXPECT_EQ(problems(""), "there are neither vertices nor faces\n");
  EXPECT_EQ(problems("v 0 0 0\n"), "there is 1 vertex, but no faces\n");
  EXPECT_EQ(problems(kTriangleText + "l 1 2\np 1\n"),
            "there are 3 vertices, but no faces\nleft out 1 point statement\nleft out 1 line statement\n");
  EXPECT_EQ(problems(kTriangleText + "f 1\nf 1 2\n"),
            "left out 2 faces of fewer than 3 corners, the first in line 4\n");
}

TEST(obj, limits_are_kept) {
  const std::string text = kSquareText + "f 1 2 3 4\n";
  Source source;
  source.bytes = std::as_bytes(std::span(text));
  source.options.limits.max_triangles = 1;
  EXPECT_EQ(read_obj(source).error().code, ErrorCode::limit);
  source.options.limits.max_triangles = 2;
  EXPECT_TRUE(read_obj(source));
  source.options.limits.max_memory = 40;
  EXPECT_EQ(read_obj(source).error().code, ErrorCode::limit);
}

// Several megabytes of everything, so that the text is cut into pieces.
std::string large_text() {
  std::string text = "o large\n";
  for (int i = 0; i < 60'000; ++i) {
    const std::string n = std::to_string(i);
    text += "v " + n + " 0." + n + " " + (i % 5000 == 4999 ? "1 .5 .25 1" : "1") + "\nvt 0." + n + " 1\n";
    if (i % 1000 == 3) text += "usemtl m" + std::to_string(i % 7000) + "\ns " + std::to_string(i % 4) + "\n";
    if (i % 777 == 0) text += "vn 0 0." + n + " 1\n";
    if (i < 5) continue;
    text += i % 3 == 0 ? "f -1/-1 -2/-1 -3/-2 -4/-3\n" : "f " + n + "/" + n + "/1 -2 1\n";
    text += "f -1 -2 -4\n";
    if (i % 9000 == 0) text += "f 1 2\nvp 1\nl 1 2\n";
  }
  return text;
}

TEST(obj, threads_do_not_show) {
  const std::string text = large_text();
  ASSERT_GT(text.size(), 3u << 20);
  const Result<Scene> one = read_text(text, 1);
  ASSERT_TRUE(one) << one.error().text();
  EXPECT_EQ(one->meshes.size(), 7u);
  for (const int threads : {2, 7}) {
    const Result<Scene> many = read_text(text, threads);
    ASSERT_TRUE(many);
    expect_same(*one, *many);
  }
  // The last error of the text does not win over the first.
  const std::string broken = "f 1 2 999999\n" + text + "f 1 2 0\n";
  for (const int threads : {1, 2, 7}) EXPECT_EQ(read_text(broken, threads).error().line, 1);
  EXPECT_EQ(read_text(text + "f 1 2 0\n", 2).error().line, 1 + std::count(text.begin(), text.end(), '\n'));
}

// Mending makes a copy of the text, and one piece more or less must not show either.
TEST(obj, a_large_text_with_a_continued_line) {
  const std::string text = large_text();
  std::string continued = text;
  continued.replace(continued.find(" 1\nvt"), 2, " \\\n1");
  Scene expected = scene_of(text), got = scene_of(continued);
  got.problems = expected.problems;  // one line further down
  expect_same(expected, got);
}

// Lists of the file read in pieces of so many bytes, or the error.
std::string lists_of(std::string_view text, std::size_t piece_bytes) {
  ObjText pieces(text, piece_bytes);
  Source source;
  source.options.threads = 2;
  const Result<ObjFile> file = parse_obj(source, pieces);
  if (!file) return file.error().text();
  std::string all;
  const auto add = [&](const auto& list) {
    all += std::to_string(list.size()) + ":";
    all.append(reinterpret_cast<const char*>(list.data()), list.size() * sizeof list[0]);
  };
  add(file->positions);
  add(file->colors);
  add(file->texcoords);
  add(file->normals);
  add(file->face_sizes);
  add(file->corner_positions);
  add(file->corner_texcoords);
  add(file->corner_normals);
  for (const ObjEvent& e : file->events) all += std::to_string(e.face) + std::string(e.text) + "\n";
  const ObjOmissions& o = file->omissions;
  for (const std::size_t n :
       {o.short_faces, o.first_short_face, o.points, o.lines, o.unknown, o.first_unknown}) {
    all += std::to_string(n) + " ";
  }
  return all += std::string(o.first_keyword) + (o.normals ? "n" : "") + (o.texcoords ? "t" : "");
}

TEST(obj, where_pieces_are_cut_does_not_show) {
  const std::string lists = kSquareText + "vt 0 0\nvt 1 1\nvn 0 0 1\n";
  for (const std::string& text :
       {lists + "f 1 2 3\nf 1//1 2\nf 1 2 3\n", lists + "f 1/1 2\n# \n# \n# \nf 1 2 3\nusemtl a\nf 1 2 3\n",
        lists + "f 1 2 3\nf 1 2 3 4\nf 1/1 2/2 3/1\nf 1//1 2//1 3//1\nv 1 2 3 1 0 0\nv 4 5 6\nf -1 -2 -3\n",
        "o a\nf 1 2 3\ns 1\n" + lists +
            "usemtl b\nf -1 -2 -3\nvp 1\nl 1 2\ncurv 2\nf 1\nmtllib x y\np 1\n\\\n",
        "\xef\xbb\xbf" + kTriangleText + "f 1 2 \\\n3\n# \\\nf 1 2 3/9/9\r\n\r\n\r\nf 1 2 x",
        lists + "v 1 2\nf 0 1 2\n",
        std::string("v 0 0 0\rv 1 0 0\rv 1 1 0\rf 1 2 3\rf 2 3 1\r\r\r\rf 1 9 1")}) {
    const std::string expected = lists_of(text, ObjText::kPieceBytes);
    for (const std::size_t bytes : {0, 1, 7, 16, 31, 64}) EXPECT_EQ(lists_of(text, bytes), expected) << text;
  }
}

// A face that is left out must not make the file one with normals.
TEST(obj, normals_of_a_face_left_out) {
  const Scene scene = scene_of(kSquareText + "vn 0 0 1\nusemtl a\nf 1 2 3\nf 1//1 2\nusemtl b\nf 1 3 4\n");
  ASSERT_EQ(scene.meshes.size(), 2u);
  EXPECT_EQ(scene.meshes[0].normals.size(), 3u);
}

// Time must not be squared by a million corners that share a vertex, nor may one of them be lost.
TEST(obj, many_corners_of_one_vertex) {
  constexpr int kCount = 100'000;
  std::string text = kTriangleText;
  for (int i = 0; i < kCount; ++i) text += "vt 0." + std::to_string(i) + " 0\n";
  for (int twice = 0; twice < 2; ++twice) {
    for (int i = 1; i <= kCount; ++i) text += "f 1/" + std::to_string(i) + " 2/1 3/1\n";
  }
  EXPECT_EQ(mesh_of(text).positions.size(), std::size_t{kCount} + 2);
}

// A file cut off anywhere is read or refused, and nothing else.
TEST(obj, every_prefix) {
  const std::string text =
      "# \xc3\xa4\r\nmtllib a.mtl\no x\nv 0 0 0 1 .5 0\nv 1e-2 0 0\nv 0 1 0\\\n \nv .5 .5 1.#IND\nvt 0 1\nvn "
      "0 0 1\ns 1\n"
      "usemtl m\nf 1 2 3\nf -4/-1/-1 2/1/1 3//1\ns off\nf 1 2 3 4\nl 1 2\n";
  for (std::size_t size = 0; size <= text.size(); ++size) {
    // Memory of its own, so that sanitizers see a step too far.
    const std::vector<char> prefix(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(size));
    const Result<Scene> scene = read_text({prefix.data(), prefix.size()});
    if (scene) {
      EXPECT_LE(scene->triangles(), 4u);
    } else {
      EXPECT_EQ(scene.error().code, ErrorCode::input);
    }
  }
}

class ObjFolder : public testing::Test {
 protected:
  void SetUp() override {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    folder_ =
        std::filesystem::path(testing::TempDir()) / (std::string("blysk_obj_") + info->name()) / "models";
    std::filesystem::create_directories(folder_ / "sub");
    for (const char* name : {"a.mtl", "b c.mtl", "sub/d.mtl", "../outside.mtl"}) {
      std::ofstream(folder_ / name) << "newmtl " << name[0] << "\nKd 1 0 0\nmap_Kd t.png\nmap_Bump " << name
                                    << ".png\n";
    }
  }
  void TearDown() override { std::filesystem::remove_all(folder_.parent_path()); }

  Scene with_library(const std::string& statement, const std::string& material) const {
    const std::string text =
        "mtllib " + statement + "\nusemtl " + material + "\n" + kTriangleText + "f 1 2 3\n";
    Result<Scene> scene = read_text(text, 1, folder_);
    EXPECT_TRUE(scene);
    return scene ? std::move(*scene) : Scene{};
  }

  std::filesystem::path folder_;
};

TEST_F(ObjFolder, libraries_are_found) {
  for (const auto& [statement, material] :
       {std::pair("a.mtl", "a"), std::pair("b c.mtl", "b"), std::pair("\"b c.mtl\"", "b"),
        std::pair("b\\ c.mtl", "b"), std::pair("a.mtl b c.mtl", "b"), std::pair("b c.mtl a.mtl", "b"),
        std::pair("sub/d.mtl\r", "s"), std::pair(".\\sub\\d.mtl", "s"),
        std::pair("\"a.mtl\" sub/d.mtl", "s")}) {
    const Scene scene = with_library(statement, material);
    EXPECT_EQ(scene.materials[0].color, (Vec3f{1, 0, 0})) << statement;
    EXPECT_EQ(problems_of(scene), "") << statement;
    ASSERT_EQ(scene.textures.size(), 2u);
    EXPECT_EQ(scene.textures[0].uri, "t.png");
    EXPECT_EQ(scene.materials[0].color_texture, 0);
    EXPECT_EQ(scene.materials[0].normal_texture, 1);
  }
}

TEST_F(ObjFolder, missing_libraries_are_problems) {
  EXPECT_EQ(problems_of(with_library("no.mtl a.mtl no.mtl", "a")),
            "material file 'no.mtl' was not found beside the model\n");
  EXPECT_EQ(problems_of(with_library("sub", "")), "material file 'sub' was not found beside the model\n");
}

TEST_F(ObjFolder, libraries_outside_the_folder_are_refused) {
  const std::string outside = (folder_.parent_path() / "outside.mtl").string();
  for (const std::string& name : {std::string("../outside.mtl"), std::string("sub/../../outside.mtl"),
                                  std::string("..\\outside.mtl"), outside, std::string("C:\\outside.mtl")}) {
    const Scene scene = with_library(name, ".");
    EXPECT_EQ(scene.materials[0].color, Material{}.color) << name;
    ASSERT_EQ(scene.problems.size(), 2u);
    EXPECT_NE(scene.problems[0].find("outside the model's folder"), std::string::npos) << scene.problems[0];
  }
}

TEST_F(ObjFolder, without_a_folder_nothing_is_read) {
  const std::string text = "mtllib a.mtl\n" + kTriangleText + "f 1 2 3\n";
  EXPECT_EQ(problems_of(scene_of(text)), "material file 'a.mtl' was not read: the model has no folder\n");
}

TEST_F(ObjFolder, a_thousand_libraries_are_not_looked_for) {
  std::string text = kTriangleText + "f 1 2 3\n";
  for (int i = 0; i < 1000; ++i) text += "mtllib no" + std::to_string(i) + ".mtl\n";
  const Result<Scene> scene = read_text(text, 1, folder_);
  ASSERT_TRUE(scene);
  EXPECT_LT(scene->problems.size(), 70u);
}

TEST_F(ObjFolder, textures_are_shared) {
  const std::string text =
      "mtllib a.mtl b c.mtl\n" + kTriangleText + "usemtl a\nf 1 2 3\nusemtl b\nf 1 2 3\n";
  const Result<Scene> scene = read_text(text, 1, folder_);
  ASSERT_TRUE(scene);
  EXPECT_EQ(scene->textures.size(), 3u);
  EXPECT_EQ(scene->materials[1].color_texture, 0);
}

// Triangles of real files: after cutting polygons and leaving out what cannot be drawn.
TEST(obj, real_files) {
  const std::filesystem::path models(BLYSK_MODELS);
  if (models.empty()) GTEST_SKIP() << "BLYSK_MODELS is not set";
  struct Known {
    const char* file;
    std::size_t triangles, meshes;
  };
  for (const Known& known :
       {Known{"mesh/armadillo.obj", 86482, 1}, Known{"mesh/teapot.obj", 6320, 1},
        Known{"mesh/suzanne.obj", 968, 1}, Known{"mesh/beetle.obj", 2053, 1},
        Known{"mesh/plane.obj", 2564, 1}, Known{"mesh/cornell_box.obj", 34, 7},
        Known{"spot/spot_mtl.obj", 5856, 1}, Known{"spot/spot_quadrangulated.obj", 5856, 1},
        Known{"xfighter/xfighter.obj", 1000, 6}, Known{"obj_quirks/issue-319-003.obj", 8, 1},
        Known{"obj_quirks/test-nan.obj", 34, 8}, Known{"obj_quirks/map-bump.obj", 400, 2}}) {
    const Result<Scene> scene = load_model((models / known.file).string());
    ASSERT_TRUE(scene) << scene.error().text();
    EXPECT_EQ(scene->triangles(), known.triangles) << known.file;
    EXPECT_EQ(scene->meshes.size(), known.meshes) << known.file;
  }
}

}  // namespace
}  // namespace blysk::io
