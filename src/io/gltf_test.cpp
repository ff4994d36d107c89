#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>

#include "io/gltf_testing.h"

namespace blysk::io::gltf_testing {
namespace {

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::string with_asset(const std::string& asset) {
  Document d = triangle_model();
  d.asset = asset;
  return d.gltf();
}

// A folder of its own that is gone with the test.
struct Folder {
  std::filesystem::path path;
  explicit Folder(const std::string& name)
      : path(std::filesystem::temp_directory_path() /
             ("blysk_gltf_" + name + "_" + std::to_string(::getpid()))) {
    std::filesystem::create_directories(path);
  }
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
  }
  void write(const std::string& name, const std::string& content) const {
    std::ofstream(path / name, std::ios::binary) << content;
  }
};

Result<Scene> read_in(const std::filesystem::path& folder, const std::string& text) {
  return read_gltf(Source{std::as_bytes(std::span(text)), "test.gltf", folder, {}});
}

}  // namespace

TEST(gltf, text_and_binary_hold_the_same) {
  const Document d = triangle_model();
  const auto text = read(d.gltf()), binary = read(d.glb());
  ASSERT_TRUE(text) << text.error().text();
  ASSERT_TRUE(binary) << binary.error().text();
  EXPECT_EQ(text->triangles(), 1u);
  EXPECT_EQ(text->meshes[0].positions, binary->meshes[0].positions);
  EXPECT_EQ(text->meshes[0].indices, binary->meshes[0].indices);
  EXPECT_TRUE(text->problems.empty());
}

TEST(gltf, truncation_at_every_byte) {
  for (const std::string& file : {triangle_model().glb(), triangle_model().gltf()}) {
    for (std::size_t length = 0; length < file.size(); ++length) {
      const auto scene = read(std::string_view(file).substr(0, length));
      ASSERT_FALSE(scene) << length;
      EXPECT_EQ(scene.error().code, ErrorCode::input);
      EXPECT_FALSE(scene.error().message.empty());
    }
  }
}

TEST(gltf, every_byte_of_a_glb_changed) {
  std::string file = triangle_model().glb();
  for (std::size_t i = 0; i < file.size(); ++i) {
    for (const int flip : {1, 0x80, 0xff}) {
      const char kept = file[i];
      file[i] = static_cast<char>(file[i] ^ flip);
      static_cast<void>(read(file));
      file[i] = kept;
    }
  }
}

TEST(gltf, glb_containers) {
  const Document d = triangle_model();
  const std::string good = d.glb();
  const auto with_word = [&](std::size_t at, std::size_t value) {
    std::string word, file = good;
    append_u32(word, value);
    return file.replace(at, 4, word);
  };
  EXPECT_TRUE(contains(error_of(with_word(4, 1)), "GLB version 1 is not read"));
  EXPECT_TRUE(contains(error_of(with_word(8, good.size() + 1)), "cut short"));
  EXPECT_TRUE(contains(error_of(with_word(8, 0xffffffff)), "cut short"));
  EXPECT_TRUE(contains(error_of(with_word(8, 13)), "gives a length of 13"));
  EXPECT_TRUE(contains(error_of(with_word(12, 0xffffffff)), "the GLB chunk at byte 12 has 4294967295 bytes"));
  EXPECT_TRUE(contains(error_of(with_word(16, 0x12345678)), "first chunk of the GLB file is not JSON"));
  // What follows the announced length, and chunks of other types, are not ours.
  EXPECT_EQ(error_of(good + "more"), "read");
  std::string unknown = good;
  append_u32(unknown, 4);
  unknown += "abcdwxyz";
  std::string length;
  append_u32(length, unknown.size());
  EXPECT_EQ(error_of(unknown.replace(8, 4, length)), "read");
  // Some exporters pad with zeros.
  std::string zeros = d.json("");
  zeros.resize(zeros.size() + 4 - zeros.size() % 4);
  EXPECT_EQ(error_of(make_glb(zeros, d.bin)), "read");
}

TEST(gltf, the_bin_chunk_must_be_there_and_whole) {
  const Document d = triangle_model();
  EXPECT_TRUE(
      contains(error_of(make_glb(d.json(""), "")), "buffers[0]: has no uri, and there is no BIN chunk"));
  EXPECT_TRUE(contains(error_of(make_glb(d.json(""), d.bin.substr(8))),
                       "buffers[0]: its data has 36 bytes, but byteLength says 42"));
}

TEST(gltf, versions) {
  EXPECT_EQ(error_of(with_asset(R"({"version":"2.0"})")), "read");
  EXPECT_EQ(error_of(with_asset(R"({"version":"2.1","minVersion":"2.0"})")), "read");
  EXPECT_EQ(error_of(with_asset(R"({"version":"1.0"})")),
            "test.gltf: asset.version: glTF \"1.0\" is not read, only 2.0; export as glTF 2.0");
  EXPECT_TRUE(
      contains(error_of(with_asset(R"({"version":"2.1","minVersion":"2.1"})")), "needs a reader of glTF"));
  EXPECT_TRUE(
      contains(error_of(with_asset(R"({"version":2})")), "asset.version: is a number; it must be a string"));
  EXPECT_TRUE(contains(error_of(with_asset("{}")), "asset: lacks \"version\""));
  EXPECT_TRUE(contains(error_of(with_asset("3")), "asset: is a number"));
  EXPECT_TRUE(contains(error_of(R"({"meshes":[]})"), "no \"asset\" object"));
  EXPECT_TRUE(contains(error_of("[]"), "no \"asset\" object"));
  EXPECT_TRUE(contains(error_of("{\n \"asset\" 1}"), "test.gltf:2: the JSON text is broken"));
}

TEST(gltf, extensions) {
  const auto needing = [](const std::string& names) {
    return triangle_model("", R"(,"extensionsRequired":[)" + names + "]").gltf();
  };
  EXPECT_EQ(error_of(needing(R"("KHR_mesh_quantization","KHR_materials_unlit","KHR_texture_transform")")),
            "read");
  EXPECT_EQ(error_of(needing(R"("KHR_draco_mesh_compression","EXT_meshopt_compression")")),
            "test.gltf: extensionsRequired: the file cannot be read without \"KHR_draco_mesh_compression\", "
            "\"EXT_meshopt_compression\"; export it without compression and required extensions");
  EXPECT_EQ(error_of(triangle_model("", R"(,"extensionsUsed":["KHR_draco_mesh_compression"])").gltf()),
            "read");
  const auto looks = read(needing(R"("KHR_materials_clearcoat")"));
  ASSERT_TRUE(looks);
  EXPECT_EQ(looks->problems, (std::vector<std::string>{"extensionsRequired[0]: \"KHR_materials_clearcoat\" "
                                                       "is not supported; surfaces may look different"}));
}

TEST(gltf, a_model_of_nothing_says_why) {
  Document d = triangle();
  d.more = R"(,"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}])";
  const auto scene = read(d.gltf());
  ASSERT_TRUE(scene);
  EXPECT_EQ(scene->triangles(), 0u);
  ASSERT_EQ(scene->problems.size(), 1u);
  EXPECT_TRUE(contains(scene->problems[0], "show none of the file's 1 mesh"));
}

TEST(gltf, problems_are_kept_in_number) {
  Document d = triangle();
  d.more = R"(,"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"nodes":[{"mesh":0})";
  for (int i = 0; i < 100; ++i) d.more += R"(,{"mesh":0,"matrix":[1,0,0,1,0,1,0,0,0,0,1,0,0,0,0,1]})";
  d.more += "]";
  const auto scene = read(d.gltf());
  ASSERT_TRUE(scene) << scene.error().text();
  ASSERT_EQ(scene->problems.size(), 33u);
  EXPECT_EQ(scene->problems.back(), "68 further problems of these kinds");
}

// What is shared must not be paid for by everyone who shares it.
TEST(gltf, sharing_costs_no_time_or_memory) {
  constexpr int kMany = 20000;
  std::string junk, cameras, materials, primitives;
  for (int i = 0; i < kMany; ++i) {
    const std::string comma = i == 0 ? "" : ",";
    junk += ",\"j" + std::to_string(i) + "\":0";
    cameras += comma + R"({"camera":0})";
    materials += comma + R"({"normalTexture":{"index":0}})";
    primitives += comma + R"({"attributes":{"POSITION":0}})";
  }
  Document d = triangle();
  d.more = R"(,"nodes":[)" + cameras + R"(],"materials":[)" + materials + R"(],"textures":[{"x":0)" + junk +
           R"(}],"cameras":[{"x":0)" + junk + "}]";
  EXPECT_EQ(error_of(d.gltf()), "read");  // takes minutes unless each is looked at once
  const std::string name(1'000'000, 'n');
  d.more =
      R"(,"meshes":[{"name":")" + name + R"(","primitives":[)" + primitives + R"(]}],"nodes":[{"mesh":0}])";
  EXPECT_TRUE(contains(error_of(d.gltf()), "unpacks to more than")) << error_of(d.gltf());
}

TEST(gltf, messages_are_one_line) {
  const std::string error =
      error_of(R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":[{"camera\n":1,"mesh":5}]})");
  EXPECT_EQ(error.find('\n'), std::string::npos);
  Document d = triangle_model();
  d.array<std::uint8_t>("SCALAR", 1, {0, 0, 0});
  d.more = R"(,"meshes":[{"name":"a\nb","primitives":[{"attributes":{"POSITION":0},"indices":2}]}],)"
           R"("nodes":[{"mesh":0}])";
  const auto degenerate = read(d.gltf());
  ASSERT_TRUE(degenerate) << degenerate.error().text();
  EXPECT_EQ(degenerate->problems.at(0), "mesh a?b: left out 1 degenerate triangle");
  const std::string version = error_of(with_asset(R"({"version":"1\n2)" + std::string(5000, 'x') + "\"}"));
  EXPECT_EQ(version.find('\n'), std::string::npos);
  EXPECT_LT(version.size(), 300u);
}

TEST(gltf_files, beside_the_model) {
  const Folder folder("beside");
  const Document d = triangle_model();
  std::filesystem::create_directories(folder.path / "sub dir");
  folder.write("a.bin", d.bin);
  folder.write("sub dir/long.bin", d.bin + "more");
  folder.write("short.bin", d.bin.substr(1));
  EXPECT_TRUE(read_in(folder.path, d.json("a.bin")));
  EXPECT_TRUE(read_in(folder.path, d.json("./sub%20dir/long.bin")));
  const auto cut = read_in(folder.path, d.json("short.bin"));
  ASSERT_FALSE(cut);
  EXPECT_TRUE(contains(cut.error().text(), "test.gltf: buffers[0]: its data has 41 bytes"))
      << cut.error().text();
  const auto missing = read_in(folder.path, d.json("none.bin"));
  ASSERT_FALSE(missing);
  EXPECT_TRUE(contains(missing.error().text(), "test.gltf: buffers[0].uri: ")) << missing.error().text();
  EXPECT_TRUE(contains(missing.error().text(), "none.bin")) << missing.error().text();
  const auto nowhere = read_in({}, d.json("a.bin"));
  ASSERT_FALSE(nowhere);
  EXPECT_TRUE(contains(nowhere.error().text(), "no folder is known")) << nowhere.error().text();
}

TEST(gltf_files, not_outside_its_folder) {
  const Folder folder("outside");
  const Document d = triangle_model();
  folder.write("a.bin", d.bin);
  std::filesystem::create_directories(folder.path / "inner");
  for (const char* uri :
       {"../a.bin", "%2e%2e/a.bin", "x/../../a.bin", "..\\\\a.bin", "file:///a.bin", "/a.bin"}) {
    const auto scene = read_in(folder.path / "inner", d.json(uri));
    ASSERT_FALSE(scene) << uri;
    EXPECT_TRUE(contains(scene.error().text(), "test.gltf: buffers[0].uri: the URI "))
        << scene.error().text();
  }
}

TEST(gltf_files, only_what_is_drawn_is_fetched) {
  Document d = triangle_model();
  std::string text = d.gltf();
  text.insert(text.find(R"(],"bufferViews")"), R"(,{"byteLength":100,"uri":"animation.bin"})");
  EXPECT_EQ(error_of(text), "read");
}

// Triangles as drawn, counted by another program; `bad` of them have coinciding corners and are left out.
struct Expected {
  const char* file;
  std::uint64_t drawn, bad;
};

TEST(gltf_models, triangle_counts) {
  const std::filesystem::path models = BLYSK_MODELS;
  if (models.empty()) GTEST_SKIP() << "configure with -DBLYSK_MODELS=FOLDER to read real models";
  const Expected all[] = {
      {"gltf/2CylinderEngine/2CylinderEngine.glb", 121496, 11160},
      {"gltf/AlphaBlendModeTest/AlphaBlendModeTest.glb", 61, 0},
      {"gltf/Box/Box.glb", 12, 0},
      {"gltf/Box/Box.gltf", 12, 0},
      {"gltf/BoxInterleaved/BoxInterleaved.gltf", 12, 0},
      {"gltf/BoxTextured/BoxTextured.gltf", 12, 0},
      {"gltf/BoxTexturedNonPowerOfTwo/BoxTexturedNonPowerOfTwo.gltf", 12, 0},
      {"gltf/BoxVertexColors/BoxVertexColors.gltf", 12, 0},
      {"gltf/Cameras/Cameras.gltf", 2, 0},
      {"gltf/CesiumMilkTruck/CesiumMilkTruck.glb", 3624, 0},
      {"gltf/DamagedHelmet/DamagedHelmet.glb", 15452, 0},
      {"gltf/Duck/Duck.glb", 4212, 0},
      {"gltf/Duck/Duck.gltf", 4212, 0},
      {"gltf/FlightHelmet/FlightHelmet.gltf", 94722, 0},
      {"gltf/MultiUVTest/MultiUVTest.gltf", 12, 0},
      {"gltf/NormalTangentMirrorTest/NormalTangentMirrorTest.glb", 5240, 0},
      {"gltf/NormalTangentTest/NormalTangentTest.glb", 7774, 0},
      {"gltf/OrientationTest/OrientationTest.glb", 524, 0},
      {"gltf/SimpleMeshes/SimpleMeshes.gltf", 2, 0},
      {"gltf/SimpleSparseAccessor/SimpleSparseAccessor.gltf", 12, 0},
      {"gltf/TextureCoordinateTest/TextureCoordinateTest.gltf", 10, 0},
      {"gltf/TextureSettingsTest/TextureSettingsTest.glb", 72, 0},
      {"gltf/TextureTransformTest/TextureTransformTest.gltf", 24, 0},
      {"gltf/Triangle/Triangle.gltf", 1, 0},
      {"gltf/TriangleWithoutIndices/TriangleWithoutIndices.gltf", 1, 0},
      {"gltf/TwoSidedPlane/TwoSidedPlane.gltf", 2, 0},
      {"gltf/UnlitTest/UnlitTest.gltf", 88, 0},
      {"gltf/VertexColorTest/VertexColorTest.glb", 36, 0},
      {"gltf/gltf_primitives/gltf_primitives.glb", 12, 0},
      {"gltf/magnum/camera.gltf", 0, 0},
      {"gltf/magnum/mesh-colors.gltf", 0, 0},
      {"gltf/magnum/mesh-primitives-types.gltf", 0, 0},
      {"gltf/magnum/mesh-sparse.gltf", 0, 0},
      {"gltf/magnum/scene-transformation.gltf", 0, 0},
      {"gltf/negative_scale/negative_scale.gltf", 3872, 0},
      {"mesh/craft_speederD.gltf", 322, 7},
      {"mesh/robot.glb", 3238, 4},
      {"xfighter/xfighter.glb", 1000, 0},
  };
  for (const Expected& expected : all) {
    const std::filesystem::path path = models / expected.file;
    const auto file = FileBytes::open(path.string(), std::uint64_t{1} << 30);
    ASSERT_TRUE(file) << file.error().text();
    const auto scene = read_gltf(Source{file->bytes(), expected.file, path.parent_path(), {}});
    ASSERT_TRUE(scene) << scene.error().text();
    EXPECT_EQ(scene->triangles(), expected.drawn - expected.bad) << expected.file;
    for (const Mesh& mesh : scene->meshes) {
      EXPECT_TRUE(mesh.normals.empty() || mesh.normals.size() == mesh.positions.size()) << expected.file;
      EXPECT_TRUE(mesh.texcoords.empty() || mesh.texcoords.size() == mesh.positions.size()) << expected.file;
    }
  }
}

TEST(gltf_models, broken_ones_say_what_is_wrong) {
  const std::filesystem::path models = BLYSK_MODELS;
  if (models.empty()) GTEST_SKIP() << "configure with -DBLYSK_MODELS=FOLDER to read real models";
  const std::map<std::string, std::string> all{
      {"RecursiveNodes.gltf", "nodes[0]: the node is among its own descendants"},
      {"integer-out-of-bounds.gltf", "bufferViews[0].byteLength: is 1e+300"},
      {"invalid-buffer-index.gltf", "bufferViews[1].buffer: buffer 1 does not exist; the file has 1"},
      {"invalid-buffer-view-index.gltf", "bufferViews[0].buffer: buffer 0 does not exist; the file has 0"},
      {"invalid-primitive-indices.gltf", "bufferViews[0].buffer: buffer 0 does not exist; the file has 0"},
  };
  for (const auto& [name, message] : all) {
    const auto file = FileBytes::open((models / "bad" / name).string(), std::uint64_t{1} << 30);
    ASSERT_TRUE(file) << file.error().text();
    const auto scene = read_gltf(Source{file->bytes(), name, models / "bad", {}});
    ASSERT_FALSE(scene) << name;
    EXPECT_TRUE(contains(scene.error().text(), name + ": " + message)) << scene.error().text();
  }
}

}  // namespace blysk::io::gltf_testing
