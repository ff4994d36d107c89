// Coverage masks: the specification's cases, the XOR form, and that meshes have no gaps.
#include "antialias/coverage_mask.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "core/random.h"

namespace {

using namespace blysk::antialias;

using Corners = std::array<Subpixel, 3>;

Mask mask_of(const Corners& corners, const SamplePattern& pattern, int column = 0, int row = 0) {
  return TriangleCoverage(corners, pattern).mask(column, row);
}

// Carpenter's form: the masks of what lies right of each edge, combined by exclusive or.
Mask xor_mask(const Corners& corners, const SamplePattern& pattern, int column, int row) {
  Mask all = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    Subpixel a = corners[k], b = corners[(k + 1) % 3];
    if (a.y == b.y) continue;
    if (a.y > b.y) std::swap(a, b);
    Mask edge = 0;
    for (std::size_t s = 0; s < pattern.count; ++s) {
      const std::int64_t x = 256 * column + 128 + pattern.x[s], y = 256 * row + 128 + pattern.y[s];
      const bool right = a.y <= y && y < b.y && (x - a.x) * (b.y - a.y) >= (b.x - a.x) * (y - a.y);
      edge |= static_cast<Mask>(right) << s;
    }
    all ^= edge;
  }
  return all;
}

std::int64_t below(blysk::Random& random, std::int64_t limit) {
  return static_cast<std::int64_t>(random.next() >> 33) % limit;
}

TEST(sample_patterns, are_those_of_the_specification) {
  EXPECT_EQ(kGrid16.count, 16u);
  EXPECT_EQ(kGrid32.count, 32u);
  EXPECT_EQ(kRooks16.count, 16u);
  EXPECT_EQ(kGrid16.full(), 0xFFFFu);
  EXPECT_EQ(kGrid32.full(), 0xFFFFFFFFu);
  const int grid16[] = {-96, -32, 32, 96}, grid32[] = {-112, -80, -48, -16, 16, 48, 80, 112};
  for (std::size_t s = 0; s < 16; ++s) {
    EXPECT_EQ(kGrid16.x[s], grid16[s % 4]);
    EXPECT_EQ(kGrid16.y[s], grid16[s / 4]);
  }
  for (std::size_t s = 0; s < 32; ++s) {
    EXPECT_EQ(kGrid32.x[s], grid32[s % 8]);
    EXPECT_EQ(kGrid32.y[s], grid16[s / 8]);
  }
  EXPECT_EQ(kGrid16.a[0], -0.375f);
  EXPECT_EQ(kGrid16.reach_a, 0.375f);
  EXPECT_EQ(kGrid32.reach_a, 0.4375f);
}

TEST(sample_patterns, rooks_share_no_row_or_column_and_are_centred) {
  int sum_x = 0, sum_y = 0;
  for (std::size_t s = 0; s < 16; ++s) {
    sum_x += kRooks16.x[s];
    sum_y += kRooks16.y[s];
    for (std::size_t t = 0; t < s; ++t) {
      EXPECT_NE(kRooks16.x[s], kRooks16.x[t]);
      EXPECT_NE(kRooks16.y[s], kRooks16.y[t]);
    }
  }
  EXPECT_EQ(sum_x, 0);
  EXPECT_EQ(sum_y, 0);
}

TEST(coverage_mask, cases_of_the_specification) {
  const struct {
    Corners corners;
    Mask grid16, grid32;
  } cases[] = {
      {{{{0, 0}, {256, 0}, {0, 256}}}, 0x0137, 0x01071F7F},
      {{{{256, 0}, {256, 256}, {0, 256}}}, 0xFEC8, 0xFEF8E080},
      {{{{-100, 20}, {300, 130}, {40, 400}}}, 0x7F70, 0x7FFF3F00},
      {{{{128, 128}, {512, 128}, {128, 512}}}, 0xCC00, 0xF0F00000},
      {{{{0, 0}, {512, 96}, {0, 96}}}, 0x0007, 0x0000001F},
      {{{{37, 11}, {211, 93}, {90, 240}}}, 0x2260, 0x001C7C06},
  };
  for (const auto& c : cases) {
    EXPECT_EQ(mask_of(c.corners, kGrid16), c.grid16);
    EXPECT_EQ(mask_of(c.corners, kGrid32), c.grid32);
    EXPECT_EQ(mask_of({c.corners[0], c.corners[2], c.corners[1]}, kGrid16), c.grid16);
  }
}

TEST(coverage_mask, flat_triangles_cover_nothing) {
  EXPECT_TRUE(TriangleCoverage({{{0, 0}, {256, 256}, {512, 512}}}, kGrid16).empty());
  EXPECT_EQ(mask_of({{{0, 0}, {256, 256}, {512, 512}}}, kGrid16, 0, 0), 0u);
}

TEST(coverage_mask, equals_the_xor_form) {
  blysk::Random random(1);
  for (int i = 0; i < 12000; ++i) {
    Corners c;
    const std::int64_t reach = i % 3 == 0 ? 128 : 1 << (9 + i % 12);
    for (Subpixel& p : c) p = {below(random, 2 * reach) - reach, below(random, 2 * reach) - reach};
    if (i % 2 == 0) c[1].x = c[0].x / 32 * 32;  // samples on edges and corners
    const int column = static_cast<int>(below(random, 3)) - 1, row = static_cast<int>(below(random, 3)) - 1;
    for (const SamplePattern* pattern : {&kGrid16, &kGrid32, &kRooks16}) {
      ASSERT_EQ(mask_of(c, *pattern, column, row), xor_mask(c, *pattern, column, row)) << i;
    }
  }
}

TEST(coverage_mask, a_fan_covers_every_sample_once) {
  blysk::Random random(2);
  constexpr int kPixels = 4;
  for (int round = 0; round < 1000; ++round) {
    // Around a centre that often is a sample, corners that often are ones too, all beyond the pixels.
    const Subpixel centre = {32 * (below(random, 16) + 8), 32 * (below(random, 16) + 8)};
    const Subpixel frame[] = {{-64, -96},   {32 * below(random, 32), -96},  {1120, -32},
                              {1120, 1120}, {32 * below(random, 32), 1120}, {-64, 1056}};
    for (int row = 0; row < kPixels; ++row) {
      for (int column = 0; column < kPixels; ++column) {
        Mask once = 0, twice = 0;
        for (std::size_t k = 0; k < 6; ++k) {
          const Mask m = mask_of({centre, frame[k], frame[(k + 1) % 6]}, kGrid16, column, row);
          twice |= once & m;
          once |= m;
        }
        ASSERT_EQ(twice, 0u) << round;
        ASSERT_EQ(once, kGrid16.full()) << round;
      }
    }
  }
}

TEST(depth_plane, goes_through_the_corners) {
  const Corners c = {{{128, 128}, {128 + 512, 128}, {128, 128 + 1024}}};
  const DepthPlane plane = depth_plane(c, {0.5, 0.75, 0.25});
  EXPECT_EQ(plane.at(0, 0), 0.5);
  EXPECT_EQ(plane.at(2, 0), 0.75);
  EXPECT_EQ(plane.at(0, 4), 0.25);
  EXPECT_EQ(plane.zx, 0.125);
  EXPECT_EQ(plane.zy, -0.0625);
}

}  // namespace
