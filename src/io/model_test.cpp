#include "blysk/model.h"

#include <filesystem>

#include "io/testing.h"

namespace blysk {
namespace {

TEST(load_model, file_errors) {
  const Result<Scene> missing = load_model("/nowhere/x.ply");
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().code, ErrorCode::input);
  EXPECT_EQ(missing.error().text(),
            "/nowhere/x.ply: cannot be read: there is no such file; check its name and folder");
}

TEST(load_model, a_byte_order_mark_says_nothing) {
  const std::string mark = "\xef\xbb\xbf";
  const std::string stl =
      "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 "
      "0\nendloop\nendfacet\nendsolid\n";
  const std::string texts[] = {
      stl, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "OFF 3 1 0 0 0 0 1 0 0 0 1 0 3 0 1 2\n",
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0 1 0 0 0 1 0 3 0 1 2\n"};
  for (const std::string& text : texts) {
    const Result<Scene> scene = io::load_text(mark + text, "x");
    ASSERT_TRUE(scene) << scene.error().text();
    EXPECT_EQ(scene->triangles(), 1u);
    EXPECT_TRUE(scene->problems.empty());
  }
  // Lines count as before.
  EXPECT_EQ(io::less_remedy(io::load_text(mark + "v 1 2\n", "x.obj").error().text()),
            "x.obj:1: a vertex needs three numbers, this one has 2");
  // The header of a binary STL may be anything.
  const std::string binary = mark + std::string(77, ' ') + io::packed(1u) + std::string(12, '\0') +
                             io::packed(0.0f, 0.0f, 0.0f, 1.0f, 0.0f, 0.0f, 0.0f, 1.0f, 0.0f) + "ab";
  for (const std::string& file : {binary, binary + "trailing"}) {
    const Result<Scene> scene = io::load_text(file, "x.stl");
    ASSERT_TRUE(scene) << scene.error().text();
    EXPECT_EQ(scene->triangles(), 1u);
  }
}

TEST(load_model, files_without_triangles_may_be_wanted) {
  const std::string texts[] = {"v 0 0 0\n", "OFF 1 0 0 0 0 0\n", "solid x\nendsolid x\n",
                               R"({"asset":{"version":"2.0"}})", std::string(1000, '\0')};
  for (const std::string& text : texts) {
    const Result<Scene> refused = io::load_text(text, "x.stl");
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::input);
    ModelOptions options;
    options.may_be_empty = true;
    const Result<Scene> scene = io::load_text(text, "x.stl", options);
    ASSERT_TRUE(scene) << scene.error().text();
    EXPECT_EQ(scene->triangles(), 0u);
    ASSERT_EQ(scene->problems.size(), 1u) << text;
    EXPECT_NE(refused.error().message.find(scene->problems[0]), std::string::npos);
  }
}

TEST(load_model, memory_limit_counts_the_file) {
  const std::string models = BLYSK_MODELS;
  if (models.empty()) GTEST_SKIP() << "BLYSK_MODELS names no folder of models";
  ModelOptions options;
  options.limits.max_memory = 1000;
  const Result<Scene> scene = load_model(models + "/mesh/teapot.stl", options);
  ASSERT_FALSE(scene);
  EXPECT_EQ(scene.error().code, ErrorCode::limit);
}

// Files of the formats without their own notes say what they hold.
TEST(load_model, real_meshes) {
  const std::string models = BLYSK_MODELS;
  if (models.empty()) GTEST_SKIP() << "BLYSK_MODELS names no folder of models";
  struct Case {
    const char* name;
    std::uint64_t triangles;
    bool normals;
  };
  for (const Case& c :
       {Case{"L.off", 4, true}, Case{"camelhead.off", 22704, true}, Case{"comments.off", 12, true},
        Case{"geomview_dodec.off", 36, true}, Case{"geomview_mushroom.off", 448, true},
        Case{"bun_zipper.ply", 69451, true}, Case{"suzanne.ply", 968, true}, Case{"bunny.stl", 69451, false},
        Case{"featuretype.STL", 3476, false}, Case{"icosahedron_ascii.stl", 20, false},
        Case{"multibody.stl", 32, false}, Case{"../ply_quirks/suzanne_be_double_rgba.ply", 968, true}}) {
    const Result<Scene> scene = load_model(models + "/mesh/" + c.name);
    ASSERT_TRUE(scene) << scene.error().text();
    EXPECT_EQ(scene->triangles(), c.triangles) << c.name;
    for (const Mesh& mesh : scene->meshes) {
      io::expect_sound(mesh);
      EXPECT_EQ(!mesh.normals.empty(), c.normals) << c.name;
    }
  }
}

// Every file there is, hostile ones among them: a sound scene or one sentence.
TEST(load_model, every_file_loads_or_says_why) {
  const std::string models = BLYSK_MODELS;
  if (models.empty()) GTEST_SKIP() << "BLYSK_MODELS names no folder of models";
  for (const char* folder : {"bad", "ply_quirks", "obj_quirks"}) {
    for (const auto& entry : std::filesystem::directory_iterator(models + "/" + folder)) {
      const Result<Scene> scene = load_model(entry.path().string());
      if (!scene) {
        EXPECT_NE(scene.error().code, ErrorCode::internal) << entry.path();
        EXPECT_FALSE(scene.error().message.empty()) << entry.path();
        continue;
      }
      EXPECT_GT(scene->triangles(), 0u);
      for (const Mesh& mesh : scene->meshes) io::expect_sound(mesh);
    }
  }
}

// STL and glTF mean flat faces: theirs are smooth only for who asks.
TEST(load_model, crease_of_flat_formats) {
  const std::string roof =
      "solid x\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 "
      "0.1\nendloop\nendfacet\n"
      "facet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 0 1 0.1\nvertex -1 0 "
      "0\nendloop\nendfacet\nendsolid\n";
  ModelOptions options;
  EXPECT_TRUE(io::load_text(roof, "x.stl", options)->meshes[0].normals.empty());
  options.crease_deg = 0;
  EXPECT_TRUE(io::load_text(roof, "x.stl", options)->meshes[0].normals.empty());
  options.crease_deg = 60;
  EXPECT_EQ(io::load_text(roof, "x.stl", options)->meshes[0].normals.size(), 4u);
}

TEST(load_model, crease_option) {
  const std::string cube =
      "OFF\n8 6 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n"
      "4 3 2 1 0\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n";
  const auto vertices = [&](double crease) {
    ModelOptions options;
    options.crease_deg = crease;
    const Result<Scene> scene = io::load_text(cube, "x.off", options);
    return scene ? std::pair(scene->meshes[0].positions.size(), scene->meshes[0].normals.size())
                 : std::pair(0ul, 0ul);
  };
  EXPECT_EQ(vertices(60), std::pair(24ul, 24ul));
  EXPECT_EQ(vertices(100), std::pair(8ul, 8ul));
  EXPECT_EQ(vertices(0), std::pair(8ul, 0ul));
}

}  // namespace
}  // namespace blysk
