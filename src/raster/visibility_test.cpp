// Visibility: the nearest triangle owns a pixel, of equally near ones the one with the lower id.
#include <gtest/gtest.h>

#include "raster/coverage_reference.h"
#include "render/testing.h"

namespace blysk {
namespace {

constexpr int kWidth = 110, kHeight = 85;

RenderOptions visibility_options() {
  RenderOptions o;
  o.antialias = "none";
  o.width = kWidth;
  o.height = kHeight;
  o.camera = pixel_camera(kHeight);
  o.shading = "flat";
  o.cull = Cull::none;
  o.want_id = o.want_depth = true;
  return o;
}

struct Crowd {
  Scene scene;
  std::vector<reference::Triangle> triangles;  // in the order of ids
};

// A corner of pixel_camera() in subpixels; nearness is a multiple of 2^-20, so that nothing is rounded on the
// way.
reference::Place random_place(Random& random, Vec2<double> around, double reach) {
  const auto move = [&] { return uniform(random, -reach, reach); };
  return {std::llrint(around.x + move()), std::llrint(around.y + move()),
          static_cast<float>(whole(random, 1, 1 << 20)) * 0x1p-20f};
}

Vec3f position_of(const reference::Place& p) {
  return {static_cast<float>(p.x - kWidth * 128) / 256, static_cast<float>(kHeight * 128 - p.y) / 256,
          p.nearness * 2 - 1};
}

void add_mesh(Crowd& crowd, const std::vector<reference::Triangle>& triangles) {
  Mesh mesh;
  for (const reference::Triangle& t : triangles) {
    for (const reference::Place& p : t.corner) {
      mesh.indices.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
      mesh.positions.push_back(position_of(p));
    }
    crowd.triangles.push_back(t);
  }
  crowd.scene.add(std::move(mesh));
}

reference::Triangle random_triangle(Random& random) {
  const Vec2<double> c = {uniform(random, 0, kWidth * 256), uniform(random, 0, kHeight * 256)};
  const double reach = std::pow(2.0, uniform(random, 7, 16));  // half a pixel to 256
  return {{random_place(random, c, reach), random_place(random, c, reach), random_place(random, c, reach)}};
}

// Bound on the error of nearness in float: rounding, and the cancellation in the slopes of slender triangles.
double nearness_error(const reference::Triangle& t) {
  const auto& [a, b, c] = t.corner;
  const auto [low, high] = std::minmax({a.nearness, b.nearness, c.nearness});
  const auto square = [](const reference::Place& p, const reference::Place& q) {
    const auto dx = static_cast<double>(p.x - q.x), dy = static_cast<double>(p.y - q.y);
    return dx * dx + dy * dy;
  };
  const double longest = std::max({square(a, b), square(b, c), square(c, a)});
  const double range = double{high} - double{low};
  return 1.5e-7 + range * std::min(1.0, 0x1p-21 * longest / std::abs(static_cast<double>(t.area())));
}

// Per pixel, the triangles that cover it.
std::vector<std::vector<std::uint32_t>> layers_of(const Crowd& crowd) {
  std::vector<std::vector<std::uint32_t>> layers(std::size_t{kWidth} * kHeight);
  for (std::uint32_t i = 0; i < crowd.triangles.size(); ++i) {
    reference::for_each_covered(crowd.triangles[i], kWidth, kHeight, [&](int x, int y) {
      layers[static_cast<std::size_t>(y * kWidth + x)].push_back(i);
    });
  }
  return layers;
}

TEST(visibility, the_nearest_wins) {
  Random random(11);
  long pixels = 0, clear = 0;
  for (int round = 0; round < 60; ++round) {
    Crowd crowd;
    for (int mesh = 0; mesh < 3; ++mesh) {
      std::vector<reference::Triangle> triangles;
      for (int i = 0; i < 40; ++i) triangles.push_back(random_triangle(random));
      add_mesh(crowd, triangles);
    }
    const auto layers = layers_of(crowd);
    for (const Isa isa : available_isas()) {
      const Frame frame = render_frame(crowd.scene, visibility_options(), isa, 1 + round % 3);
      for (std::size_t p = 0; p < layers.size(); ++p) {
        const int x = static_cast<int>(p) % kWidth, y = static_cast<int>(p) / kWidth;
        ASSERT_EQ(frame.id[p] == 0, layers[p].empty()) << isa_name(isa) << " " << x << "," << y;
        if (layers[p].empty()) {
          ASSERT_EQ(frame.depth.values[p], 1.0f);
          continue;
        }
        const std::uint32_t drawn = frame.id[p] - 1;
        ASSERT_NE(std::count(layers[p].begin(), layers[p].end(), drawn), 0)
            << isa_name(isa) << " " << x << "," << y;
        const double near = reference::nearness_at(crowd.triangles[drawn], x, y),
                     error = nearness_error(crowd.triangles[drawn]);
        ASSERT_NEAR(1.0 - double{frame.depth.values[p]}, near, error)
            << isa_name(isa) << " triangle " << drawn;
        bool doubtful = false;
        for (const std::uint32_t other : layers[p]) {
          const double behind = near - reference::nearness_at(crowd.triangles[other], x, y);
          const double unsure = error + nearness_error(crowd.triangles[other]);
          ASSERT_GE(behind, -unsure) << isa_name(isa) << ", pixel " << x << "," << y << " shows " << drawn
                                     << ", not " << other;
          doubtful = doubtful || (other != drawn && behind < unsure);
        }
        ++pixels;
        clear += doubtful ? 0 : 1;
      }
    }
  }
  EXPECT_GT(pixels, 500000);
  EXPECT_GT(static_cast<double>(clear), 0.99 * static_cast<double>(pixels));
}

// Level triangles of one depth: every one ties with all others, whatever its size.
TEST(visibility, equal_depths_go_to_the_lower_id) {
  Random random(12);
  for (int round = 0; round < 20; ++round) {
    Crowd crowd;
    for (int mesh = 0; mesh < 2; ++mesh) {
      std::vector<reference::Triangle> triangles;
      for (int i = 0; i < 150; ++i) {
        triangles.push_back(random_triangle(random));
        for (reference::Place& p : triangles.back().corner)
          p.nearness = round == 0 ? 0.0f : 0.375f;  // 0: the far plane
      }
      std::sort(triangles.begin(), triangles.end(), [](const auto& a, const auto& b) {
        return std::abs(a.area()) < std::abs(b.area());  // else the large ones hide the rest
      });
      add_mesh(crowd, triangles);
    }
    const auto layers = layers_of(crowd);
    for (const Isa isa : available_isas()) {
      const Frame frame = render_frame(crowd.scene, visibility_options(), isa, 1 + round % 3);
      for (std::size_t p = 0; p < layers.size(); ++p) {
        ASSERT_EQ(frame.id[p], layers[p].empty() ? 0u : layers[p].front() + 1)
            << isa_name(isa) << ", pixel " << p;
      }
    }
  }
}

// Exact copies, of either winding, never show.
TEST(visibility, copies_stay_behind_their_originals) {
  Random random(13);
  for (int round = 0; round < 20; ++round) {
    Crowd crowd;
    std::vector<reference::Triangle> originals, copies;
    for (int i = 0; i < 120; ++i) {
      originals.push_back(random_triangle(random));
      copies.push_back(originals.back());
      if (i % 2 == 1) std::swap(copies.back().corner[1], copies.back().corner[2]);
    }
    add_mesh(crowd, originals);
    add_mesh(crowd, copies);
    for (const Isa isa : available_isas()) {
      const Frame frame = render_frame(crowd.scene, visibility_options(), isa, 1 + round % 3);
      for (const std::uint32_t id : frame.id) ASSERT_LE(id, originals.size()) << isa_name(isa);
    }
  }
}

// Rounding must not carry a triangle's pixels beyond the planes of the view, where nothing is drawn.
TEST(visibility, triangles_that_touch_the_planes_are_whole) {
  Random random(14);
  for (int round = 0; round < 1500; ++round) {
    Crowd crowd;
    reference::Triangle t;
    const double reach = std::pow(2.0, uniform(random, 9, 15));
    const Vec2<double> c = {uniform(random, 0, kWidth) * 256, uniform(random, 0, kHeight) * 256};
    for (reference::Place& p : t.corner) {
      p = random_place(random, c, reach);
      p.x = (p.x & ~std::int64_t{255}) + 128;  // centres lie on edges, where nearness is that of the corners
      p.y = (p.y & ~std::int64_t{255}) + 128;
    }
    const auto odd = static_cast<std::size_t>(round % 3);
    const float plane = round % 2 == 0 ? 0.0f : 1.0f;
    for (std::size_t k = 0; k < 3; ++k) {
      if (k != odd) t.corner[k].nearness = plane;
    }
    add_mesh(crowd, {t});
    const auto layers = layers_of(crowd);
    for (const Isa isa : available_isas()) {
      const Frame frame = render_frame(crowd.scene, visibility_options(), isa);
      for (std::size_t p = 0; p < layers.size(); ++p) {
        ASSERT_EQ(frame.id[p], layers[p].empty() ? 0u : 1u)
            << isa_name(isa) << ", triangle " << round << ", pixel " << p;
        ASSERT_GE(frame.depth.values[p], 0.0f);
        ASSERT_LE(frame.depth.values[p], 1.0f);
      }
    }
  }
}

}  // namespace
}  // namespace blysk
