#include <limits>
#include <set>

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
  mesh.indices = {1, 2, 3, 1, 1, 2, 1, 4, 2, 1, 5, 2, 3, 2, 6};
  std::vector<std::string> problems;
  drop_bad_triangles(mesh, problems);
  EXPECT_EQ(problems,
            (std::vector<std::string>{"mesh wing: left out 2 degenerate and 1 non-finite triangles"}));
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

// Corners on a line, as exporters leave them where edges meet in a T; however large or small, and no sliver
// beside.
TEST(drop_bad_triangles, corners_on_a_line) {
  for (const float scale : {1.0f, 0x1p-100f, 0x1p-136f, 0x1p100f}) {
    const Vec3f a{1, 2, 3}, step{0.25f, -0.5f, 1};
    Mesh mesh;
    for (const float t : {0.0f, 1.0f, 3.0f}) mesh.positions.push_back((a + step * t) * scale);
    mesh.positions.push_back(mesh.positions[2]);
    float& x = mesh.positions[3].x;
    x = std::nextafter(x, 2 * x);
    mesh.indices = {0, 1, 2, 0, 1, 3};
    std::vector<std::string> problems;
    drop_bad_triangles(mesh, problems);
    EXPECT_EQ(problems, std::vector<std::string>{"mesh: left out 1 degenerate triangle"}) << scale;
    EXPECT_EQ(mesh.triangles(), 1u) << scale;
  }
}

// A grid of squares, every seventh triangle spoilt in its own way: the same remains with any number of
// threads.
TEST(drop_bad_triangles, threads_leave_no_trace) {
  constexpr std::uint32_t kSide = 200;
  Mesh grid;
  for (std::uint32_t i = 0; i < kSide * kSide; ++i) {
    grid.positions.push_back({static_cast<float>(i % kSide), static_cast<float>(i / kSide), 0});
  }
  Array<std::uint32_t> good;
  grid.positions.push_back({0, std::numeric_limits<float>::infinity(), 0});
  for (std::uint32_t i = 0; i + kSide + 1 < kSide * kSide; ++i) {
    std::uint32_t triangle[3] = {i, i + 1, i + kSide};
    if (i % 7 == 0) triangle[i % 3] = i % 2 == 0 ? kSide * kSide : triangle[(i + 1) % 3];
    grid.indices.insert(grid.indices.end(), triangle, triangle + 3);
    if (i % 7 != 0) good.insert(good.end(), triangle, triangle + 3);
  }
  for (const int threads : {1, 2, 7}) {
    Mesh mesh = grid;
    std::vector<std::string> problems;
    ThreadPool pool(threads);
    drop_bad_triangles(mesh, problems, pool);
    EXPECT_EQ(mesh.positions.size(), std::set(good.begin(), good.end()).size());
    ASSERT_EQ(mesh.indices.size(), good.size());
    for (std::size_t i = 0; i < good.size(); ++i) {
      ASSERT_EQ(mesh.positions[mesh.indices[i]], grid.positions[good[i]]);
    }
    EXPECT_EQ(problems.size(), 1u);
  }
}

TEST(drop_bad_triangles, nothing_at_all) {
  Mesh mesh;
  std::vector<std::string> problems;
  drop_bad_triangles(mesh, problems);
  EXPECT_TRUE(problems.empty());
}

}  // namespace
}  // namespace blysk::io
