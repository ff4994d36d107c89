// Cells of lighting textures beside their triangle, and the points that two triangles share. The kernels'
// headers are compiled here for the plain processor.
#define BLYSK_ISA isa_test
#include "shading/texture_cell.h"

#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <memory>

#include "render/testing.h"
#include "shading/lighting_texture_reference.h"
#include "shading/texture_cache.h"

namespace blysk {
namespace {

using isa_test::I32;
using isa_test::kLanes;
using isa_test::kTextureRow;

struct Placed {
  isa_test::Corners<float> corner{};
  isa_test::RowFrame<float> frame;
};

Placed random_placed(Random& random) {
  Placed o;
  const std::int64_t reach = std::int64_t{256} << whole(random, 0, 9);
  for (int k = 0; k < 3; ++k) {
    o.corner.x[k] = static_cast<float>(whole(random, -reach, reach));
    o.corner.y[k] = static_cast<float>(whole(random, -reach, reach));
  }
  isa_test::sort_corners(o.corner);
  o.frame = isa_test::row_frame(o.corner);
  return o;
}

// A million lanes in and around triangles: what they read lies in the texture, and weighs between 0 and 1.
TEST(texture_cell, lanes_beside_the_triangle_stay_in_the_texture) {
  Random random(71);
  long inside = 0, beside = 0;
  for (int round = 0; round < 70000; ++round) {
    const Placed o = random_placed(random);
    if (std::abs(o.frame.area) < 65536) continue;
    const float steps = static_cast<float>(1 << whole(random, 0, 4));
    const auto base = static_cast<std::int32_t>(whole(random, 0, 5000));
    const auto y = static_cast<float>(
        whole(random, static_cast<std::int64_t>(o.corner.y[0]), static_cast<std::int64_t>(o.corner.y[1])));
    const auto start = isa_test::row_start(o.frame, y);
    const std::int64_t from = whole(random, -200000, 200000);
    const auto x = isa_test::to_float(isa_test::iota(0) * I32(512) +
                                      I32(static_cast<std::int32_t>(round % 2 == 0 ? from / 100 : from)));
    const auto c = isa_test::texture_cell(o.frame, start, steps, base, x);
    float wx[kLanes], wy[kLanes], over[kLanes];
    isa_test::store(c.x, wx);
    isa_test::store(c.y, wy);
    isa_test::store(isa_test::right_of(o.frame, start, x) * isa_test::F32(o.frame.over), over);
    for (const I32& words : c.at) {
      std::uint32_t at[kLanes];
      isa_test::store_all(words, at);
      for (const std::uint32_t word : at) {
        const int place = static_cast<int>(word) - base, n = static_cast<int>(steps);
        ASSERT_GE(place, 0);
        ASSERT_LE(place / kTextureRow + place % kTextureRow, n) << "steps " << n << ", word " << place;
      }
    }
    for (int i = 0; i < kLanes; ++i) {
      ASSERT_TRUE(wx[i] >= 0 && wx[i] <= 1 && wy[i] >= 0 && wy[i] <= 1) << wx[i] << " " << wy[i];
      const float down = start.s - o.frame.bend * over[i];
      ++(over[i] >= 0 && down >= 0 && over[i] + down <= 1 ? inside : beside);
    }
  }
  EXPECT_GT(inside, 10000);
  EXPECT_GT(beside, 500000);
}

// As the reference form does beside the triangle: the value of the nearest place along the row's direction.
TEST(texture_cell, reference_is_clamped_beside_the_triangle) {
  const auto point = [](int i, int j) { return 1.0 + i * i - 3.0 * j + 0.5 * i * j; };
  const auto fetch = [&](double u, double v) { return reference::fetch_texture(8, point, u, v); };
  EXPECT_EQ(fetch(-0.2, 0.5), fetch(0, 0.5));
  EXPECT_EQ(fetch(0.3, -0.1), fetch(0.3, 0));
  EXPECT_EQ(fetch(0.4, 7), fetch(0, 1));
  EXPECT_EQ(fetch(0.9, 0.25), fetch(0.75, 0.25));
  EXPECT_EQ(fetch(-5, -5), point(0, 0));
}

// C.6: the normals of an edge are the same bits from either of its triangles, whichever way it runs.
TEST(texture_cell, shared_edges_have_equal_bits) {
  Random random(72);
  for (int round = 0; round < 100000; ++round) {
    const Vec3f a = to_float(random_direction(random));
    const Vec3f b = to_float(normalize(to_double(a) + random_direction(random) * uniform(random, 0, 1)));
    const int steps = 1 << whole(random, 0, 4);
    isa_test::NormalRun<kTextureRow + kLanes> there, back;
    isa_test::halve_edge({a.x, a.y, a.z}, {b.x, b.y, b.z}, steps, there);
    isa_test::halve_edge({b.x, b.y, b.z}, {a.x, a.y, a.z}, steps, back);
    for (int i = 0; i <= steps; ++i) {
      const auto p = there.at(i), q = back.at(steps - i);
      ASSERT_EQ(std::memcmp(&p, &q, sizeof p), 0) << "point " << i << " of " << steps;
    }
  }
}

// Two triangles on either side of the edge from vertex 0 to vertex 1, seen in perspective.
struct Neighbours {
  std::array<ScreenVertex, 5> vertices{};
  std::array<Vec3f, 5> normals{}, positions{};  // with room to be read past the last
  std::array<std::uint32_t, 7> indices{};
  ViewRays rays{};
  Draw draw{};
  ShadeJob job{};

  explicit Neighbours(Random& random) {
    draw.normals = normals.data();
    draw.positions = positions.data();
    draw.indices = indices.data();
    job.vertices = vertices.data();
    job.draw = &draw;
    job.rays = &rays;
    rays.direction[0] = rays.direction[1] = -0.5f;
    rays.direction[2] = -1;
    rays.direction_x[0] = rays.direction_y[1] = 1.0f / (256 * 512);
    const Vec3d axis = {uniform(random, -0.3, 0.3), uniform(random, -0.3, 0.3), 1};
    for (std::size_t i = 0; i < 4; ++i) {
      const auto x = static_cast<std::int32_t>(whole(random, 0, 256 * 512)),
                 y = static_cast<std::int32_t>(whole(random, 0, 256 * 512));
      vertices[i] = {.x = x, .y = y, .nearness = 0.1f + 0.8f * random.unit(), .q = 0.5f + random.unit()};
      positions[i] = {static_cast<float>(x) / 131072 - 0.5f, static_cast<float>(y) / 131072 - 0.5f, -1};
      normals[i] = to_float(normalize(axis + random_direction(random) * 0.2));
    }
    const std::uint32_t corners[6] = {0, 1, 2, 1, 0, 3};
    const auto turn_first = static_cast<std::uint32_t>(whole(random, 0, 2)),
               turn_second = static_cast<std::uint32_t>(whole(random, 0, 2));
    for (std::uint32_t k = 0; k < 3; ++k) {
      indices[k] = corners[(k + turn_first) % 3];
      indices[3 + k] = corners[3 + (k + turn_second) % 3];
    }
    Surface& s = draw.surface;
    s.model = LightingModel::blinn;
    s.shininess = 2;
    s.whole_shininess = 2;
    s.lamps = 2;
    s.lamp[1].point = true;
    for (int l = 0; l < 2; ++l) {
      const Vec3f to = to_float(normalize(random_direction(random) + Vec3d{0, 0, 1.5}));
      const float distance = l == 1 ? 40.0f : 1.0f;
      for (int i = 0; i < 3; ++i) s.lamp[l].vector[i] = distance * (i == 0 ? to.x : i == 1 ? to.y : to.z);
    }
  }

  // What a triangle's texture holds of a lamp at `step` of `steps` from vertex 0 to vertex 1.
  [[nodiscard]] std::uint32_t word(isa_test::TextureCache& cache, int triangle, int steps, int lamp,
                                   int step) const {
    const auto t = isa_test::fetch_lit_triangle<float>(job, triangle);
    const auto share = [&](int corner) {
      return t.corners.vertex[corner] == 0 ? steps - step : t.corners.vertex[corner] == 1 ? step : 0;
    };
    const int slot = cache.find(job, triangle, steps);
    return cache.words()[slot * isa_test::TextureCache::kSlotStride + lamp * isa_test::kTextureWords +
                         share(2) * kTextureRow + share(1)];
  }
};

// The same of what their textures hold: near and far lamps, in perspective, corners in any order.
TEST(texture_cell, textures_agree_along_shared_edges) {
  Random random(73);
  long words = 0, bright = 0;
  for (int round = 0; round < 4000; ++round) {
    const Neighbours n(random);
    const auto cache = std::make_unique<isa_test::TextureCache>();
    cache->start();
    const int steps = 1 << whole(random, 1, 4);
    bool both = true;
    for (int triangle = 0; triangle < 2; ++triangle) {
      both = both && cache->steps(cache->find(n.job, triangle, steps)) == steps;
    }
    if (!both) continue;  // one of them has no texture: normals and directions turn too much
    for (int lamp = 0; lamp < 2; ++lamp) {
      for (int i = 0; i <= steps; ++i) {
        const std::uint32_t first = n.word(*cache, 0, steps, lamp, i);
        ASSERT_EQ(first, n.word(*cache, 1, steps, lamp, i)) << "point " << i << " of " << steps;
        ++words;
        bright += first != 0 ? 1 : 0;
      }
    }
  }
  EXPECT_GT(words, 20000);
  EXPECT_GT(bright, words / 2);
}

}  // namespace
}  // namespace blysk
