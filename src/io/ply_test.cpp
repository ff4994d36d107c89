#include "io/testing.h"
#include "math/srgb.h"

namespace blysk::io {
namespace {

constexpr std::string_view kXyz = "property float x\nproperty float y\nproperty float z\n";

std::string header(std::string_view format, std::string_view elements) {
  return "ply\nformat " + std::string(format) + " 1.0\n" + std::string(elements) + "end_header\n";
}
std::string vertices(int count, std::string_view properties) {
  return "element vertex " + std::to_string(count) + "\n" + std::string(properties);
}
std::string faces(int count, std::string_view list = "property list uchar int vertex_indices\n") {
  return "element face " + std::to_string(count) + "\n" + std::string(list);
}

const Array<Vec3f> kSquareCorners = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};

std::string ascii_square() {
  return header("ascii", vertices(4, kXyz) + faces(2)) + kSquareRows + "3 0 1 2\n3 0 2 3\n";
}

std::string binary_square(bool big) {
  std::string file = header(big ? "binary_big_endian" : "binary_little_endian", vertices(4, kXyz) + faces(2));
  for (const Vec3f& p : kSquareCorners) file += big ? packed_big(p.x, p.y, p.z) : packed(p.x, p.y, p.z);
  for (const int i : {1, 2}) {
    file += '\3';
    file += big ? packed_big(0, i, i + 1) : packed(0, i, i + 1);
  }
  return file;
}

TEST(ply, the_three_formats_give_the_same) {
  const std::string crlf = [] {
    std::string file = ascii_square();
    for (std::size_t at = 0; (at = file.find('\n', at)) != std::string::npos; at += 2)
      file.replace(at, 1, "\r\n");
    return file;
  }();
  std::string cr = ascii_square();
  for (char& c : cr) c = c == '\n' ? '\r' : c;
  for (const std::string& file : {ascii_square(), crlf, cr, binary_square(false), binary_square(true)}) {
    const Result<Scene> scene = load_text(file, "x.ply");
    ASSERT_TRUE(scene) << scene.error().text();
    const Mesh& mesh = scene->meshes.at(0);
    EXPECT_EQ(mesh.positions, kSquareCorners);
    EXPECT_EQ(mesh.indices, (Array<std::uint32_t>{0, 1, 2, 0, 2, 3}));
    EXPECT_EQ(mesh.normals, (Array<Vec3f>{{0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}}));
    EXPECT_TRUE(scene->problems.empty());
  }
}

// With CR alone as line end, a first data byte of LF belongs to the data.
TEST(ply, a_line_feed_may_be_the_first_byte_of_data) {
  std::string file = header("binary_little_endian",
                            vertices(3, "property char x\nproperty char y\nproperty char z\n") + faces(1));
  for (char& c : file) c = c == '\n' ? '\r' : c;
  file += packed(char{10}, char{0}, char{0}, char{1}, char{0}, char{0}, char{0}, char{1}, char{0}, char{3}, 0,
                 1, 2);
  const Result<Scene> scene = load_text(file, "x.ply");
  ASSERT_TRUE(scene) << scene.error().text();
  EXPECT_EQ(scene->meshes[0].positions[0], (Vec3f{10, 0, 0}));
}

TEST(ply, attributes_in_any_order_and_type) {
  const std::string file =
      header(
          "ascii",
          "comment TextureFile my picture.png\nobj_info none\n" +
              vertices(
                  3,
                  "property double t\nproperty uchar blue\nproperty short z\nproperty list uchar int extra\n"
                  "property float nz\nproperty float s\nproperty ushort red\nproperty int y\nproperty uchar "
                  "alpha\nproperty float nx\nproperty uint8 green\nproperty float32 x\nproperty float ny\n") +
              faces(1,
                    "property int material\nproperty list ushort uint vertex_index\nproperty list uchar "
                    "float texcoord\n") +
              "element edge 1\nproperty int a\n") +
      "0.25 255 3 2 7 7 2 0.5 65535 2 51 0 128 1.5 0\n"
      "0 0 0 0 1 0 0 0 255 0 0 1 0\n"
      "0 0 0 1 9 1 0 0 1 255 0 0 0 0\n"
      "5 3 0 1 2 2 0.5 0.5\n"
      "17\n";
  const Result<Scene> scene = load_text(file, "x.ply");
  ASSERT_TRUE(scene) << scene.error().text();
  const Mesh& mesh = scene->meshes.at(0);
  EXPECT_EQ(mesh.positions[0], (Vec3f{1.5f, 2, 3}));
  EXPECT_EQ(mesh.normals[0], (Vec3f{0, 0, 1}));
  EXPECT_EQ(mesh.texcoords[0], (Vec2f{0.5f, 0.25f}));
  EXPECT_EQ(mesh.colors[0], (Vec4f{1, srgb_to_linear(std::uint8_t{128}), 1, 0.2f}));
  EXPECT_EQ(scene->textures.at(0).uri, "my picture.png");
  EXPECT_EQ(scene->materials.at(0).color_texture, 0);
  EXPECT_EQ(scene->materials.at(0).color, (Vec3f{1, 1, 1}));
}

TEST(ply, colors_of_every_type_mean_the_same) {
  struct Case {
    std::string type, full, half;
  };
  for (const Case& c :
       {Case{"uchar", "255", "51"}, Case{"int", "255", "51"}, Case{"ushort", "65535", "13107"},
        Case{"float", "1", "0.2"}, Case{"double", "1", "0.2"}}) {
    const std::string file =
        header("ascii", vertices(3, std::string(kXyz) + "property " + c.type + " red\nproperty " + c.type +
                                        " green\nproperty " + c.type + " blue\n") +
                            faces(1)) +
        "0 0 0 " + c.full + " " + c.half + " 0\n1 0 0 0 0 0\n0 1 0 0 0 0\n3 0 1 2\n";
    const Result<Scene> scene = load_text(file, "x.ply");
    ASSERT_TRUE(scene) << scene.error().text();
    const Vec4f color = scene->meshes[0].colors.at(0);
    EXPECT_EQ(color.x, 1.0f) << c.type;
    EXPECT_NEAR(color.y, srgb_to_linear(std::uint8_t{51}), 1e-6f) << c.type;
    EXPECT_EQ(color.z, 0.0f);
    EXPECT_EQ(color.w, 1.0f);
  }
}

TEST(ply, half_a_colour_is_none) {
  const Result<Scene> scene = load_text(
      header("ascii", vertices(3, std::string(kXyz) + "property uchar red\nproperty float nx\n") + faces(1)) +
          "0 0 0 1 1\n1 0 0 1 1\n0 1 0 1 1\n3 0 1 2\n",
      "x.ply");
  ASSERT_TRUE(scene);
  EXPECT_TRUE(scene->meshes[0].colors.empty());
  EXPECT_EQ(scene->meshes[0].normals[0], (Vec3f{0, 0, 1}));
}

TEST(ply, binary_colors_and_doubles_in_both_orders) {
  const std::string properties =
      "property double x\nproperty double y\nproperty double z\nproperty uchar red\nproperty ushort green\n"
      "property float blue\nproperty uchar alpha\n";
  using u8 = std::uint8_t;
  using u16 = std::uint16_t;
  for (const bool big : {false, true}) {
    const auto file = [&](double z) {
      std::string bytes =
          header(big ? "binary_big_endian" : "binary_little_endian",
                 vertices(3, properties) + faces(1, "property list int ushort vertex_index\n"));
      const auto add = [&](auto... v) { bytes += big ? packed_big(v...) : packed(v...); };
      add(1.0, 0.0, 0.0, u8{255}, u16{65535}, 1.0f, u8{51});
      add(0.0, 1.0, 0.0, u8{0}, u16{0}, 0.0f, u8{255});
      add(0.0, 0.0, z, u8{0}, u16{0}, 0.0f, u8{255});
      add(3, u16{0}, u16{1}, u16{2});
      return bytes;
    };
    EXPECT_FALSE(load_text(file(1e300), "x.ply"));  // a corner beyond float: nothing is left to draw
    const Result<Scene> scene = load_text(file(2), "x.ply");
    ASSERT_TRUE(scene) << scene.error().text();
    EXPECT_EQ(scene->meshes[0].colors[0], (Vec4f{1, 1, 1, 0.2f}));
    EXPECT_EQ(scene->meshes[0].colors[2], (Vec4f{0, 0, 0, 1}));
    EXPECT_EQ(scene->meshes[0].positions[2], (Vec3f{0, 0, 2}));
  }
}

// Twenty thousand faces of two to five corners, their colour around the list: every way to read them and any
// number of threads give the same mesh.
TEST(ply, colored_polygons_in_every_format) {
  using u8 = std::uint8_t;
  using u16 = std::uint16_t;
  constexpr int kFaces = 20000;
  const std::string list =
      "property uchar red\nproperty float quality\nproperty list ushort uint vertex_indices\n"
      "property uchar green\nproperty uchar blue\n";
  const Vec2f ring[] = {{1, 0}, {0.5f, 1}, {-1, 0.5f}, {-0.75f, -0.5f}, {0, -1}};
  std::string files[3];
  for (int format = 0; format < 3; ++format) {
    std::string& file = files[format];
    constexpr const char* kNames[] = {"ascii", "binary_little_endian", "binary_big_endian"};
    file = header(kNames[format], vertices(5, kXyz) + faces(kFaces, list));
    const auto add = [&](auto... v) {
      if (format == 0) {
        ((file += std::to_string(v) + " "), ...);
      } else {
        file += format == 2 ? packed_big(v...) : packed(v...);
      }
    };
    for (const Vec2f& p : ring) add(p.x, p.y, 0.0f);
    for (int face = 0; face < kFaces; ++face) {
      const int corners = face % 11 == 0 ? 2 + face / 11 % 4 : 3;
      add(u8(face / 100), 0.5f, static_cast<u16>(corners));
      for (int k = 0; k < corners; ++k) add((face + k) % 5);
      add(u8(face % 2), u8{7});
    }
  }
  ModelOptions options;
  options.threads = 1;
  const Result<Scene> first = load_text(files[0], "x.ply", options);
  ASSERT_TRUE(first) << first.error().text();
  const Mesh& wanted = first->meshes.at(0);
  EXPECT_EQ(wanted.colors[wanted.indices[0]].z, srgb_to_linear(u8{7}));
  EXPECT_LT(wanted.positions.size(), 5u * 2 * kFaces / 100 * 2);
  for (int i = 1; i < 6; ++i) {
    options.threads = 1 + i / 3 * 2;
    const Result<Scene> scene = load_text(files[i % 3], "x.ply", options);
    ASSERT_TRUE(scene) << scene.error().text();
    EXPECT_EQ(scene->meshes.at(0).indices, wanted.indices);
    EXPECT_EQ(scene->meshes.at(0).positions, wanted.positions);
    EXPECT_EQ(scene->meshes.at(0).colors, wanted.colors);
    EXPECT_EQ(scene->problems, first->problems);
  }
}

TEST(ply, polygons_are_cut_and_scraps_left_out) {
  const Result<Scene> scene = load_text(
      header("ascii", vertices(4, kXyz) + faces(3)) + "0 0 0\n4 0 0\n4 4 0\n3 1 0\n4 0 1 2 3\n2 0 1\n0\n",
      "x.ply");
  ASSERT_TRUE(scene) << scene.error().text();
  EXPECT_EQ(scene->triangles(), 2u);
  EXPECT_NEAR(area(scene->meshes[0]), 4, 1e-6);
  EXPECT_EQ(scene->problems.at(0), "left out 2 faces of fewer than three corners");
}

TEST(ply, faces_may_come_first_and_have_colors) {
  const std::string file =
      header("ascii",
             faces(2,
                   "property list uchar int vertex_indices\nproperty uchar red\nproperty uchar green\n"
                   "property uchar blue\n") +
                 vertices(4, kXyz)) +
      "3 0 1 2 255 0 0\n3 0 2 3 0 255 0\n" + kSquareRows;
  const Result<Scene> scene = load_text(file, "x.ply");
  ASSERT_TRUE(scene) << scene.error().text();
  const Mesh& mesh = scene->meshes[0];
  expect_sound(mesh);
  ASSERT_EQ(mesh.positions.size(), 6u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(mesh.colors[mesh.indices[i]], (Vec4f{1, 0, 0, 1}));
    EXPECT_EQ(mesh.colors[mesh.indices[3 + i]], (Vec4f{0, 1, 0, 1}));
  }
}

TEST(ply, strips) {
  const std::string file =
      header("ascii", vertices(5, kXyz) + "element tristrips 1\nproperty list int int vertex_indices\n") +
      "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n9 0 1 2 3 -1 2 3 4 3\n";
  const Result<Scene> scene = load_text(file, "x.ply");
  ASSERT_TRUE(scene) << scene.error().text();
  EXPECT_EQ(scene->meshes[0].indices, (Array<std::uint32_t>{0, 1, 2, 2, 1, 3, 2, 3, 4}));
  EXPECT_EQ(scene->problems.at(0), "mesh: left out 1 degenerate triangle");
  // And behind faces, of the fast way too.
  std::string both =
      header("binary_little_endian",
             vertices(4, kXyz) + faces(1) + "element tristrips 1\nproperty list int int vertex_indices\n");
  for (const Vec3f& p : kSquareCorners) both += packed(p.x, p.y, p.z);
  both += '\3' + packed(0, 1, 2) + packed(3, 0, 2, 3);
  const Result<Scene> joined = load_text(both, "x.ply");
  ASSERT_TRUE(joined) << joined.error().text();
  EXPECT_EQ(joined->triangles(), 2u);
  EXPECT_NEAR(area(joined->meshes[0]), 1, 1e-6);
}

// In the row that is wrong, or the line of a text, in whatever way the rows are read.
TEST(ply, indices_out_of_range) {
  const std::string text = header("ascii", vertices(4, kXyz) + faces(4)) + kSquareRows + "3 0 1 2\n3 0 1 ";
  const auto message = [&](const std::string& index) {
    const Result<Scene> scene = load_text(text + index + "\n3 0 1 3\n3 0 2 3\n", "x.ply");
    return scene ? std::string() : scene.error().text();
  };
  constexpr const char* kRest = ", but they count from 0 to 3; save the model again";
  for (const std::string index : {"4", "-1", "4294967296", "1.5"}) {
    EXPECT_EQ(message(index), "x.ply:15: 'face' 2 of 4 uses vertex " + index + kRest);
  }
  std::string binary = header("binary_little_endian", vertices(4, kXyz) + faces(2));
  for (const Vec3f& p : kSquareCorners) binary += packed(p.x, p.y, p.z);
  binary += '\3' + packed(0, 1, 2) + '\3' + packed(0, -2, 2);
  const Result<Scene> scene = load_text(binary, "x.ply");
  ASSERT_FALSE(scene);
  EXPECT_EQ(scene.error().text(), std::string("x.ply: 'face' 2 of 2 uses vertex -2") + kRest);
}

// The first with positions counts, in the header's checks and in those of the faces.
TEST(ply, several_elements_of_vertices) {
  const std::string none = "element vertex 8\n", other = vertices(2, "property uchar weight\n");
  const std::string rest = vertices(3, kXyz) + faces(1);
  const std::string ascii = "0 0 0\n1 0 0\n0 1 0\n";
  for (const std::string& first : {none, other, none + other}) {
    const std::string values = first == none ? "" : "7 7\n";
    const Result<Scene> good =
        load_text(header("ascii", first + rest) + values + ascii + "3 0 1 2\n", "x.ply");
    ASSERT_TRUE(good) << good.error().text();
    EXPECT_EQ(good->meshes[0].positions, (Array<Vec3f>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    EXPECT_FALSE(load_text(header("ascii", first + rest) + values + ascii + "3 0 1 7\n", "x.ply"));
    std::string binary = header("binary_little_endian", first + rest) + (first == none ? "" : "77") +
                         packed(0.0f, 0.0f, 0.0f, 1.0f, 0.0f, 0.0f, 0.0f, 1.0f, 0.0f);
    EXPECT_TRUE(load_text(binary + '\3' + packed(0, 1, 2), "x.ply"));
    EXPECT_FALSE(load_text(binary + '\3' + packed(0, 1, 7), "x.ply"));
  }
}

TEST(ply, lengths_that_cannot_be) {
  const std::string start = header("ascii", vertices(4, kXyz) + faces(1)) + kSquareRows;
  for (const char* length : {"-3", "9999", "2.5"}) {
    const Result<Scene> scene = load_text(start + length + " 0 1 2\n", "x.ply");
    ASSERT_FALSE(scene);
    EXPECT_NE(scene.error().text().find("x.ply:14: 'face' 1 of 1 has "), std::string::npos)
        << scene.error().text();
  }
}

TEST(ply, unusable_normals_are_made) {
  const std::string file =
      header("ascii",
             vertices(4, std::string(kXyz) + "property float nx\nproperty float ny\nproperty float nz\n") +
                 faces(1)) +
      "0 0 0 0 0 0\n1 0 0 0 0 5\n1 1 0 nan 0 1\n0 1 0 1 0 0\n4 0 1 2 3\n";
  const Result<Scene> scene = load_text(file, "x.ply");
  ASSERT_TRUE(scene) << scene.error().text();
  EXPECT_EQ(scene->meshes[0].normals, (Array<Vec3f>{{0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {1, 0, 0}}));
}

TEST(ply, header_errors_have_lines) {
  const auto error = [](const std::string& text) {
    const Result<Scene> scene = load_text(text, "x.ply");
    return scene ? std::string("loaded") : less_remedy(scene.error().text());
  };
  EXPECT_EQ(error("ply\nformat ascii 2.0\n"), "x.ply:2: unknown PLY version '2.0'");
  EXPECT_EQ(error("ply\nformat ascii 1.0\nelement vertex -4\n"),
            "x.ply:3: element 'vertex' has '-4' for its count");
  EXPECT_EQ(error("ply\nformat ascii 1.0\nproperty float x\n"),
            "x.ply:3: a property comes before the first element");
  EXPECT_EQ(error("ply\nformat ascii 1.0\nelement vertex 4\nproperty half x\n"),
            "x.ply:4: unknown PLY type 'half'");
  EXPECT_EQ(error("ply\nformat ascii 1.0\nhello\n"), "x.ply:3: unknown word 'hello' in the PLY header");
  EXPECT_EQ(error("ply\nelement vertex 4\n"),
            "x.ply:2: the PLY header's format line must come before its elements");
  EXPECT_EQ(error(header("ascii", faces(0))), "x.ply: has no vertices with x, y and z");
  EXPECT_EQ(
      error(header("ascii", vertices(1, kXyz) + faces(0, "property list uchar float vertex_indices\n"))),
      "x.ply: gives the vertices of its faces as fractions: vertex_indices must be integers");
}

TEST(ply, data_errors_say_where) {
  const auto error = [](const std::string& text) {
    return less_remedy(load_text(text, "x.ply").error().text());
  };
  const std::string start = header("ascii", vertices(4, kXyz) + faces(1));
  EXPECT_EQ(error(start + "0 0 0\n1 0 0\n1 1 oh\n0 1 0\n3 0 1 2\n"),
            "x.ply:12: has something other than a number in 'vertex' 3 of 4");
  EXPECT_EQ(error(start + kSquareRows + "3 0 1"), "x.ply:14: is cut short: it ends in 'face' 1 of 1");
  std::string binary = binary_square(false);
  binary.resize(binary.size() - 1);
  EXPECT_EQ(error(binary), "x.ply: is cut short: it ends in 'face' 2 of 2");
}

TEST(ply, counts_that_lie_take_no_memory) {
  for (const char* format : {"ascii", "binary_little_endian", "binary_big_endian"}) {
    for (const char* elements : {"element vertex 4000000000\n", "element vertex 4294967294\n",
                                 "element vertex 9000000000000000000\n"}) {
      const Result<Scene> scene =
          load_text(header(format, elements + std::string(kXyz)) + "0 0 0\n", "x.ply");
      ASSERT_FALSE(scene);
      EXPECT_EQ(scene.error().code, ErrorCode::input);
    }
    // Rows of nothing take no time either.
    EXPECT_FALSE(
        load_text(header(format, "element vertex 1\n" + std::string(kXyz) + "element x 4000000000000\n") +
                      "0 0 0 0 0 0 0 0",
                  "x.ply"));
    EXPECT_FALSE(
        load_text(header(format, vertices(1, kXyz) + faces(2'000'000'000)) + "0 0 0 0 0 0 0 0", "x.ply"));
  }
  const std::string list =
      header("binary_little_endian", vertices(0, kXyz) + faces(1, "property list uint int vertex_indices\n"));
  EXPECT_FALSE(load_text(list + packed(0xffffffffu, 1, 2), "x.ply"));
  const std::string negative =
      header("binary_little_endian", vertices(0, kXyz) + faces(1, "property list int int vertex_indices\n"));
  EXPECT_FALSE(load_text(negative + packed(-1, 1, 2), "x.ply"));
}

TEST(ply, a_header_of_very_many_properties_does_not_take_long) {
  std::string properties(kXyz);
  for (int i = 0; i < 200'000; ++i) properties += "property char x\n";
  EXPECT_FALSE(load_text(header("binary_little_endian", vertices(1, properties) + faces(1)), "x.ply"));
}

TEST(ply, limits) {
  ModelOptions options;
  options.limits.max_triangles = 1;
  EXPECT_EQ(load_text(ascii_square(), "x.ply", options).error().code, ErrorCode::limit);
  EXPECT_EQ(load_text(binary_square(false), "x.ply", options).error().code, ErrorCode::limit);
  options.limits = {.max_memory = 40};
  EXPECT_EQ(load_text(ascii_square(), "x.ply", options).error().code, ErrorCode::limit);
}

TEST(ply, points_alone_are_told) {
  const Result<Scene> scene = load_text(header("ascii", vertices(4, kXyz)) + kSquareRows, "x.ply");
  ASSERT_FALSE(scene);
  EXPECT_EQ(scene.error().message,
            "has no triangles to draw: there are 4 vertices, but no faces; `blysk info` tells what is in it");
}

TEST(ply, every_prefix_survives) {
  expect_all_prefixes_survive(ascii_square(), "x.ply");
  expect_all_prefixes_survive(binary_square(false), "x.ply");
  expect_all_prefixes_survive(binary_square(true), "x.ply");
}

// The fast way and the slow one, many threads and one.
TEST(ply, large_files_do_not_depend_on_threads) {
  constexpr int kSide = 300;
  std::string head =
      header("binary_little_endian", vertices(kSide * kSide, kXyz) + faces(2 * (kSide - 1) * (kSide - 1)));
  std::string body;
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x)
      body += packed(float(x), float(y), float((x * 7 + y * y * 3) % 11) * 0.3f);
  }
  for (int y = 0; y + 1 < kSide; ++y) {
    for (int x = 0; x + 1 < kSide; ++x) {
      const int i = y * kSide + x;
      body += '\3' + packed(i, i + 1, i + kSide) + '\3' + packed(i + 1, i + kSide + 1, i + kSide);
    }
  }
  ModelOptions one, seven;
  one.threads = 1;
  seven.threads = 7;
  const Result<Scene> a = load_text(head + body, "x.ply", one), b = load_text(head + body, "x.ply", seven);
  ASSERT_TRUE(a && b);
  EXPECT_EQ(a->meshes[0].positions, b->meshes[0].positions);
  EXPECT_EQ(a->meshes[0].normals, b->meshes[0].normals);
  EXPECT_EQ(a->meshes[0].indices, b->meshes[0].indices);
  EXPECT_GT(a->meshes[0].positions.size(), std::size_t{kSide * kSide});
}

}  // namespace
}  // namespace blysk::io
