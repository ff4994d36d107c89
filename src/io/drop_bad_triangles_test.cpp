#include <limits>

#include "io/reader.h"
#include "io/testing.h"

namespace blysk::io {
namespace {

TEST(drop_bad_triangles, each_kind_and_the_vertices_nobody_uses) {
  Mesh mesh;
  mesh.name = "wing";
  mesh.positions = {{9, 9, 9}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {std::nanf(""), 0, 0}, {0, 0, 1}};
  for (std::size_t i = 0; i < 7; ++i) {
    const auto f = static_cast<float>(i);
    mesh.normals.push_back({f, 0, 0});
    mesh.colors.push_back({f, 0, 0, 1});
    mesh.texcoords.push_back({f, 0});
    mesh.texcoords1.push_back({0, f});
    mesh.tangents.push_back({f, 0, 0, -1});
  }
  mesh.indices = {1, 2, 3, 1, 1, 2, 1, 4, 2, 1, 5, 2, 1, 2, 7, 3, 2, 6, 0xffffffff, 1, 2};
  std::vector<std::string> problems;
  drop_bad_triangles(mesh, problems);
  EXPECT_EQ(problems, (std::vector<std::string>{
                          "mesh wing: left out 2 degenerate and 1 non-finite and 2 out-of-range triangles"}));
  EXPECT_EQ(mesh.positions, (Array<Vec3f>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}));
  EXPECT_EQ(mesh.indices, (Array<std::uint32_t>{0, 1, 2, 2, 1, 3}));
  EXPECT_EQ(mesh.normals[3].x, 6);
  EXPECT_EQ(mesh.colors[3].x, 6);
  EXPECT_EQ(mesh.texcoords[3].x, 6);
  EXPECT_EQ(mesh.texcoords1[3].y, 6);
  EXPECT_EQ(mesh.tangents[3].x, 6);
  drop_bad_triangles(mesh, problems);
  EXPECT_EQ(problems.size(), 1u);
}

TEST(drop_bad_triangles, nothing_at_all) {
  Mesh mesh;
  std::vector<std::string> problems;
  drop_bad_triangles(mesh, problems);
  EXPECT_TRUE(problems.empty());
}

}  // namespace
}  // namespace blysk::io
