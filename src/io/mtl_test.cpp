#include "io/mtl.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "math/srgb.h"

namespace blysk::io {
namespace {

struct ReadLibrary {
  MtlLibrary library;
  std::vector<std::string> problems;
};

ReadLibrary read_library(std::string_view text) {
  ReadLibrary r;
  r.library.read(text, "m.mtl", r.problems);
  return r;
}

MtlMaterial material(std::string_view statements) {
  const ReadLibrary r = read_library("newmtl m\n" + std::string(statements));
  const MtlMaterial* m = r.library.find("m");
  EXPECT_NE(m, nullptr);
  return m == nullptr ? MtlMaterial{} : *m;
}

Vec3f decoded(float r, float g, float b) { return {srgb_to_linear(r), srgb_to_linear(g), srgb_to_linear(b)}; }

TEST(mtl, colours_are_decoded) {
  const Material m = material("Kd .5 .25 1\nKs 1 0 .1\nKe 2 -1 .5\nKa 20 20 20\n").material;
  EXPECT_EQ(m.color, decoded(.5f, .25f, 1));
  EXPECT_EQ(m.specular, decoded(1, 0, .1f));
  EXPECT_EQ(m.emission, decoded(1, 0, .5f));
  EXPECT_EQ(material("Kd .5\n").material.color, decoded(.5f, .5f, .5f));
}

TEST(mtl, what_a_file_does_not_say_is_the_default) {
  const Material m = material("").material;
  EXPECT_EQ(m.color, Material{}.color);
  EXPECT_EQ(m.specular, Material{}.specular);
  EXPECT_EQ(m.shininess, Material{}.shininess);
  EXPECT_EQ(m.opacity, 1);
}

TEST(mtl, shininess_is_clamped) {
  EXPECT_EQ(material("Ns 40.5\n").material.shininess, 40.5f);
  EXPECT_EQ(material("Ns 0\n").material.shininess, 1);
  EXPECT_EQ(material("Ns 1e9\n").material.shininess, 1000);
  EXPECT_EQ(material("Ns nan\n").material.shininess, Material{}.shininess);
}

TEST(mtl, opacity_in_two_ways) {
  EXPECT_EQ(material("d .25\n").material.opacity, .25f);
  EXPECT_EQ(material("d -halo .25\n").material.opacity, .25f);
  EXPECT_EQ(material("Tr .25\n").material.opacity, .75f);
  EXPECT_EQ(material("d .75\nTr .5\n").material.opacity, .75f);
  EXPECT_EQ(material("Tr .5\nd .75\n").material.opacity, .75f);
  EXPECT_EQ(material("d 7\n").material.opacity, 1);
  EXPECT_EQ(material("d .25\n").material.alpha_mode, AlphaMode::blend);
  EXPECT_EQ(material("d 1\n").material.alpha_mode, AlphaMode::opaque);
}

TEST(mtl, illumination_without_highlight) {
  EXPECT_EQ(material("illum 0\nKs 1 1 1\n").material.specular, (Vec3f{0, 0, 0}));
  EXPECT_EQ(material("Ks 1 1 1\nillum 1\n").material.specular, (Vec3f{0, 0, 0}));
  EXPECT_EQ(material("Ks 1 1 1\nillum 2\n").material.specular, (Vec3f{1, 1, 1}));
}

TEST(mtl, maps_without_their_options) {
  for (const char* statement : {"map_Kd a b.png", "map_Kd -clamp on a b.png", "map_Kd -o 0.1 a b.png",
                                "map_Kd -s 1 2 3 a b.png", "map_kd -t 1 2 -mm 0 1 -bm 2 a b.png ",
                                "map_Kd a b.png -bm 1.5", "map_Kd -type sphere -imfchan r a b.png -cc on",
                                "map_Kd -texres 512 a b.png\r", "map_Kd\t-colorspace sRGB\t\"a b.png\"",
                                "map_Kd -blendu off -blendv on a b.png", "map_Kd -boost 3 a b.png"}) {
    EXPECT_EQ(material(statement).color_map, "a b.png") << statement;
  }
  EXPECT_EQ(material("map_Kd -o 1 2 3 4.png").color_map, "4.png");
  EXPECT_EQ(material("map_Kd -a.png").color_map, "-a.png");
  EXPECT_EQ(material("map_Kd -o").color_map, "");
  EXPECT_EQ(material("map_Kd").color_map, "");
}

TEST(mtl, a_normal_map_goes_before_a_bump_map) {
  EXPECT_EQ(material("map_Bump -bm 3 b.png\n").normal_map, "b.png");
  EXPECT_EQ(material("bump b.png\n").normal_map, "b.png");
  EXPECT_EQ(material("norm n.png\nmap_bump b.png\n").normal_map, "n.png");
  EXPECT_EQ(material("map_bump b.png\nnorm n.png\n").normal_map, "n.png");
}

TEST(mtl, names_blanks_and_line_ends) {
  const ReadLibrary r =
      read_library("\xef\xbb\xbf# x\r\nKd 0 0 0\r\n \tnewmtl  a b \r\n  Kd 1 0 0\r\nNEWMTL c\rkd 0 1 0");
  ASSERT_NE(r.library.find("a b"), nullptr);
  EXPECT_EQ(r.library.find("a b")->material.color, (Vec3f{1, 0, 0}));
  ASSERT_NE(r.library.find("c"), nullptr);
  EXPECT_EQ(r.library.find("c")->material.color, (Vec3f{0, 1, 0}));
  EXPECT_EQ(r.library.find("A B"), nullptr);
  EXPECT_TRUE(r.problems.empty());
}

TEST(mtl, the_first_of_a_name_counts) {
  ReadLibrary r = read_library("newmtl a\nKd 1 0 0\nd .5\nnewmtl a\nKd 0 1 0\nnewmtl b\n");
  r.library.read("newmtl a\nKd 0 0 1\n", "n.mtl", r.problems);
  EXPECT_EQ(r.library.find("a")->material.color, (Vec3f{1, 0, 0}));
  EXPECT_EQ(r.library.find("b")->material.opacity, 1);
}

TEST(mtl, what_is_left_out_is_told) {
  const ReadLibrary r =
      read_library("newmtl a\nmap_Ks x\nNi 1\nrefl x\nKd\nKd spectral x\nKs x 0 0\nmap_Ks y\n");
  ASSERT_EQ(r.problems.size(), 2u);
  EXPECT_EQ(r.problems[0],
            "'m.mtl': left out 3 statements without the numbers they need, the first in line 5");
  EXPECT_EQ(r.problems[1], "'m.mtl': left out 'map_ks', 'refl', which no material here has");
  std::string text = "newmtl a\n";
  for (int i = 0; i < 1000; ++i) text += std::string("x").append(std::to_string(i)) + "\n";
  EXPECT_LT(read_library(text).problems[0].size(), 150u);
}

TEST(mtl, library_names) {
  using Names = std::vector<std::string>;
  EXPECT_EQ(library_names(""), Names{});
  EXPECT_EQ(library_names(" a.mtl "), Names{"a.mtl"});
  EXPECT_EQ(library_names("a.mtl  b.MTL"), (Names{"a.mtl", "b.MTL"}));
  EXPECT_EQ(library_names("a b.mtl c.mtl"), (Names{"a b.mtl", "c.mtl"}));
  EXPECT_EQ(library_names("\"a b.mtl\"c.mtl"), (Names{"a b.mtl", "c.mtl"}));
  EXPECT_EQ(library_names("a\\ b.mtl sub\\c.mtl"), (Names{"a b.mtl", "sub/c.mtl"}));
  EXPECT_EQ(library_names("a.lib b.lib"), (Names{"a.lib", "b.lib"}));
  EXPECT_EQ(library_names("\"a b.mtl"), Names{"a b.mtl"});
  EXPECT_EQ(library_names("\\"), Names{"/"});
  EXPECT_EQ(library_names("\""), Names{""});
}

TEST(mtl, every_prefix) {
  const std::string text =
      "newmtl a\nKd .5 .5 .5\nd -halo .5\nmap_Kd -o 1 2 -s \"x y\" -bm 2\nillum 2\nnorm -bm\nTr\nnewmtl\nKs "
      "1";
  for (std::size_t size = 0; size <= text.size(); ++size) {
    const std::vector<char> prefix(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(size));
    EXPECT_LE(read_library({prefix.data(), prefix.size()}).problems.size(), 2u);
  }
}

}  // namespace
}  // namespace blysk::io
