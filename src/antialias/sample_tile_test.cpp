// The exact A-buffer against a brute-force reference: every sample, every triangle, exact integers and
// doubles.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "blysk/methods.h"
#include "blysk/shapes.h"
#include "render/sample_testing.h"

namespace blysk {
namespace {

// What one sample shows.
struct Seen {
  double nearness = -1;
  int triangle = -1;
  double second = -1;  ///< the next depth behind it, as near as rounding may bring it
};

// Samples are pixels of the reference.
std::vector<Seen> look(const Crowd& crowd) {
  constexpr int kAcross = kCrowdWidth * 4, kDown = kCrowdHeight * 4;
  std::vector<Seen> seen(std::size_t{kAcross} * kDown);
  for (std::size_t i = 0; i < crowd.triangles.size(); ++i) {
    const reference::Triangle& t = crowd.triangles[i];
    const double error = depth_error(t);
    reference::for_each_covered(t, kAcross, kDown, [&](int x, int y) {
      Seen& s = seen[static_cast<std::size_t>(y * kAcross + x)];
      const double near = reference::nearness_at(t, x, y);
      if (near > s.nearness) {
        const double known =
            s.triangle < 0 ? -1
                           : s.nearness + depth_error(crowd.triangles[static_cast<std::size_t>(s.triangle)]);
        s = {near, static_cast<int>(i), std::max(s.second, known)};
      } else {
        s.second = std::max(s.second, near + error);
      }
    });
  }
  return seen;
}

struct ExpectedPixel {
  Vec3d color;
  bool doubtful = false;  ///< rounding may decide
  bool whole = true;      ///< one surface, or none
  int first = -1;
};

ExpectedPixel expect_pixel(const Crowd& crowd, const std::vector<Seen>& seen, Vec4f background, int x,
                           int y) {
  ExpectedPixel e;
  for (int s = 0; s < 16; ++s) {
    const Seen& at = seen[static_cast<std::size_t>((4 * y + s / 4) * kCrowdWidth * 4 + 4 * x + s % 4)];
    Vec3f c = {background.x, background.y, background.z};
    if (at.triangle >= 0) {
      const auto i = static_cast<std::size_t>(at.triangle);
      c = crowd.colors[i];
      e.doubtful = e.doubtful || at.nearness - depth_error(crowd.triangles[i]) <= at.second;
    }
    if (s == 0) e.first = at.triangle;
    e.whole = e.whole && at.triangle == e.first;
    e.color = e.color + to_double(c) * (1.0 / 16);
  }
  return e;
}

class Exact : public testing::TestWithParam<std::tuple<double, double, int>> {};

TEST_P(Exact, agrees_with_brute_force_at_every_sample) {
  const auto& [least, most, count] = GetParam();
  Random random(31 + static_cast<std::uint64_t>(count));
  long pixels = 0, clear = 0;
  for (int round = 0; round < 12; ++round) {
    const Crowd crowd = random_crowd(random, count, least, most);
    const std::vector<Seen> seen = look(crowd);
    const RenderOptions o = sample_options();
    for (const Isa isa : available_isas()) {
      const Frame frame = render_frame(crowd.scene, o, isa, 1 + round % 3);
      for (int y = 0; y < kCrowdHeight; ++y) {
        for (int x = 0; x < kCrowdWidth; ++x) {
          const ExpectedPixel e = expect_pixel(crowd, seen, o.background, x, y);
          ++pixels;
          if (e.doubtful) continue;
          ++clear;
          const auto p = static_cast<std::size_t>(y * kCrowdWidth + x);
          const std::uint32_t pixel = frame.image.pixels[p];
          ASSERT_NEAR(channel(pixel, 0), e.color.x, 0.6 / 255) << isa_name(isa) << " " << x << "," << y;
          ASSERT_NEAR(channel(pixel, 1), e.color.y, 0.6 / 255) << isa_name(isa) << " " << x << "," << y;
          ASSERT_NEAR(channel(pixel, 2), e.color.z, 0.6 / 255) << isa_name(isa) << " " << x << "," << y;
          ASSERT_EQ(pixel >> 24, 255u);
          if (!e.whole) continue;
          ASSERT_EQ(frame.id[p], static_cast<std::uint32_t>(e.first + 1));
        }
      }
    }
  }
  EXPECT_GT(static_cast<double>(clear), 0.85 * static_cast<double>(pixels));
}

// Sizes in binary orders of 1/1024 pixel: parts of a pixel, patches, rows, whole tiles, and all of them.
INSTANTIATE_TEST_SUITE_P(sizes, Exact,
                         testing::Values(std::tuple{7.0, 10.0, 20000}, std::tuple{10.0, 12.5, 3000},
                                         std::tuple{13.0, 15.0, 400}, std::tuple{15.0, 19.0, 60},
                                         std::tuple{7.0, 19.0, 1000}));

// Where one surface covers a pixel, antialiasing changes nothing, whatever the method, the lamp, the size.
TEST(abuffer, whole_pixels_are_those_of_no_antialiasing) {
  Random random(41);
  long compared = 0;
  for (int round = 0; round < 4; ++round) {
    Crowd crowd = random_crowd(random, 500, 11, 17);
    Mesh& mesh = crowd.scene.meshes[0];
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
      const Vec3f tilt = {static_cast<float>(uniform(random, -0.3, 0.3)),
                          static_cast<float>(uniform(random, -0.3, 0.3)), 1};
      mesh.normals.push_back(to_float(normalize(to_double(tilt))));
    }
    crowd.scene.materials[0].unlit = false;
    const std::vector<Seen> seen = look(crowd);
    for (const Method& method : methods()) {
      if (method.kind != MethodKind::shading) continue;
      RenderOptions o = sample_options();
      o.shading = method.name;
      Light lamp;
      lamp.kind = Light::Kind::point;
      lamp.vector = {20, 30, 40};
      o.lights = {lamp};
      const Frame sampled = render_frame(crowd.scene, o);
      o.antialias = "none";
      const Frame plain = render_frame(crowd.scene, o);
      for (int y = 0; y < kCrowdHeight; ++y) {
        for (int x = 0; x < kCrowdWidth; ++x) {
          const ExpectedPixel e = expect_pixel(crowd, seen, o.background, x, y);
          const auto p = static_cast<std::size_t>(y * kCrowdWidth + x);
          // A sliver may pass through the centre between all samples.
          if (!e.whole || e.doubtful || plain.id[p] != static_cast<std::uint32_t>(e.first + 1)) continue;
          ASSERT_EQ(sampled.image.pixels[p], plain.image.pixels[p]) << method.name << " " << x << "," << y;
          ASSERT_EQ(sampled.id[p], plain.id[p]);
          ASSERT_EQ(sampled.depth.values[p], plain.depth.values[p]) << method.name << " " << x << "," << y;
          compared += e.first >= 0 ? 1 : 0;
        }
      }
    }
  }
  EXPECT_GT(compared, 10000);
}

// Exact copies, of either winding, never show: of equals the lower id wins, at every sample.
TEST(abuffer, copies_stay_behind_their_originals) {
  Random random(43);
  for (int round = 0; round < 8; ++round) {
    Crowd crowd;
    Mesh mesh;
    std::vector<reference::Triangle> all;
    for (int i = 0; i < 200; ++i) all.push_back(random_triangle(random, 9, 18));
    for (const auto& t : all) add_triangle(crowd, mesh, t, {0, 0.5f, 0});
    for (auto t : all) {
      std::swap(t.corner[1], t.corner[2]);
      add_triangle(crowd, mesh, t, {1, 0.5f, 0});
    }
    crowd.scene.add(std::move(mesh));
    crowd.scene.materials[0].unlit = true;
    crowd.scene.materials[0].color = {1, 1, 1};
    RenderOptions o = sample_options();
    o.background = {0, 0, 0, 1};
    for (const Isa isa : available_isas()) {
      const Frame frame = render_frame(crowd.scene, o, isa, 2);
      long red = 0;
      for (const std::uint32_t p : frame.image.pixels) red += (p & 255) > 16 ? 1 : 0;
      EXPECT_EQ(red, 0) << isa_name(isa);
    }
  }
}

// Half a pixel of an opaque surface over nothing is half opaque, in the surface's own colour.
TEST(abuffer, alpha_is_coverage_over_a_transparent_background) {
  Crowd crowd;
  Mesh mesh;
  const auto at = [](double x, double y) {
    return reference::Place{std::llrint(x * 1024), std::llrint(y * 1024), 0.5f};
  };
  add_triangle(crowd, mesh, {{at(10.5, -500), at(10.5, 500), at(900, 0)}}, {0.75f, 0.25f, 0.5f});
  crowd.scene.add(std::move(mesh));
  crowd.scene.materials[0].unlit = true;
  crowd.scene.materials[0].color = {1, 1, 1};
  RenderOptions o = sample_options();
  for (const Transfer transfer : {Transfer::none, Transfer::srgb}) {
    o.transfer = transfer;
    o.background = {0, 0, 0, 0};
    const Frame frame = render_frame(crowd.scene, o);
    const std::uint32_t* row = frame.image.pixels.data() + 30 * kCrowdWidth;
    EXPECT_EQ(row[9], 0u);
    EXPECT_EQ(row[10] >> 24, 128u);
    EXPECT_EQ(row[10] & 0xffffff, row[11] & 0xffffff);
    EXPECT_EQ(row[11] >> 24, 255u);
    // Half opaque background below the other half: alpha 3/4, colours in proportion 2 : 1.
    o.background = {0, 0, 0, 0.5f};
    const Frame over = render_frame(crowd.scene, o);
    row = over.image.pixels.data() + 30 * kCrowdWidth;
    EXPECT_EQ(row[10] >> 24, 191u);
    if (transfer == Transfer::none) {
      EXPECT_EQ(row[10] & 255, 128u);  // 0.75 * 2 / 3
    }
  }
}

}  // namespace
}  // namespace blysk
