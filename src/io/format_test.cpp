#include "io/format.h"

#include "io/testing.h"

namespace blysk::io {
namespace {

void expect_format(std::string_view text, std::string_view name, Format format) {
  const Result<Format> found = find_format(as_bytes(text), name);
  ASSERT_TRUE(found) << found.error().text();
  EXPECT_EQ(*found, format) << text << " as " << name;
}

std::string stl_header(std::string_view start, std::uint32_t count) {
  std::string header(start);
  header.resize(80, ' ');
  return header + packed(count);
}

TEST(find_format, content_comes_before_extension) {
  expect_format("ply\nformat ascii 1.0\n", "x.obj", Format::ply);
  expect_format("ply\r\nformat ascii 1.0\r\n", "x.stl", Format::ply);
  expect_format("glTF\2\0\0\0", "x.ply", Format::gltf);
  expect_format("\n { \"asset\": {} }", "x.obj", Format::gltf);
  expect_format("# made by hand\nCOFF\n3 1 0\n", "x.ply", Format::off);
  expect_format("STCNOFF 1 1 1", "x", Format::off);
  expect_format("solid a\nfacet normal 0 0 1\n", "x.obj", Format::stl);
  expect_format("# cube\n\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "x.stl", Format::obj);
  expect_format("SOLID a\nFACET NORMAL 0 0 1\n", "x.obj", Format::stl);
  std::string comments;
  for (int i = 0; i < 1000; ++i) comments += "# made by hand\n";
  expect_format(comments + "v 0 0 0\n", "x", Format::obj);
  expect_format("mtllib a.mtl\no name\n  v 0 0 0\n", "", Format::obj);
}

TEST(find_format, binary_stl_may_begin_with_solid_or_anything) {
  expect_format(stl_header("solid but binary", 1) + std::string(50, '\0'), "x", Format::stl);
  expect_format(stl_header("ply\n", 0), "x", Format::ply);
  expect_format(stl_header("v 0 0 0", 1) + std::string(50, '\0'), "x.obj", Format::stl);
}

TEST(find_format, extension_where_content_says_nothing) {
  expect_format(stl_header("x", 7), "a.b/MODEL.STL", Format::stl);
  expect_format("8 6 12\n0 0 0", "cube.off", Format::off);
  expect_format("curv 1 2", "x.obj", Format::obj);
}

TEST(find_format, refusals_say_what_to_do) {
  const auto message = [](std::string_view text, std::string_view name) {
    const Result<Format> found = find_format(as_bytes(text), name);
    return found ? std::string() : found.error().message;
  };
  EXPECT_NE(
      message("version https://git-lfs.github.com/spec/v1\noid sha256:00\n", "x.glb").find("git lfs pull"),
      std::string::npos);
  EXPECT_NE(message("PK\3\4", "x.3mf").find("ZIP"), std::string::npos);
  EXPECT_NE(message("hello", "x.txt").find("OBJ, STL, PLY, OFF, glTF"), std::string::npos);
  EXPECT_NE(message("hello", "folder.obj/x").find("OBJ, STL, PLY, OFF, glTF"), std::string::npos);
  EXPECT_EQ(message("", "x.obj"), "is empty; save or fetch it again");
}

}  // namespace
}  // namespace blysk::io
