// Two fragments made one: the specification's numbers, and that a merge keeps the pixel.
#include "antialias/merge.h"

#include "antialias/testing.h"
#include "core/random.h"

namespace {

using namespace blysk::antialias;
using examples::expect_colour;
using examples::fragment;

TEST(merge, single_merge_of_the_specification) {
  const Fragment a = fragment(0, 0x000F, {200, 0, 0}, 0.2f, 0.1f, 0),
                 b = fragment(1, 0x0FF0, {0, 200, 0}, 0.4f, -0.05f, 0.2f);
  const Fragment corrected = merge(a, b, MergedPlane::corrected, kGrid16);
  expect_colour(blysk::to_double(corrected.rgb), {66.666667, 133.333333, 0});
  EXPECT_NEAR(corrected.z, 0.333333333, 3e-8);
  EXPECT_EQ(corrected.zx, -0.05f);
  EXPECT_EQ(corrected.zy, 0.0f);
  const Fragment printed = merge(a, b, MergedPlane::printed, kGrid16);
  expect_colour(blysk::to_double(printed.rgb), {50, 100, 0});
  EXPECT_NEAR(printed.z, 0.3, 3e-8);
  const Fragment larger = merge(a, b, MergedPlane::larger, kGrid16);
  EXPECT_EQ(larger.zx, -0.05f);
  EXPECT_EQ(larger.zy, 0.2f);
  const PixelPlane fitted = least_squares_plane(a, b, kGrid16);
  EXPECT_NEAR(fitted.z, 0.389471058, 2e-8);
  EXPECT_NEAR(fitted.zx, 0, 2e-8);
  EXPECT_NEAR(fitted.zy, 0.449101796, 2e-8);
  EXPECT_NEAR(ward_cost(a, b, kGrid16), 0.090798611, 2e-8);
}

TEST(merge, costs_of_the_specification) {
  const Fragment f[] = {fragment(0, 0x000F, {}, 0.2f, 0.1f, 0), fragment(1, 0x0FF0, {}, 0.4f, -0.05f, 0.2f),
                        fragment(2, 0x3000, {}, 0.6f, 0.02f, -0.1f),
                        fragment(3, 0xC000, {}, 0.8f, -0.3f, 0.05f)};
  const struct {
    int i, j;
    double cost;
  } costs[] = {{0, 1, .090798611}, {0, 2, .235652778}, {0, 3, .432135417},
               {1, 2, .0550825},   {1, 3, .237125},    {2, 3, .073664063}};
  for (const auto& c : costs) EXPECT_NEAR(ward_cost(f[c.i], f[c.j], kGrid16), c.cost, 1e-7) << c.i << c.j;
}

TEST(merge, weight_of_depth_leans_to_the_larger) {
  for (int ka = 1; ka < 16; ++ka) {
    for (int kb = 1; ka + kb <= 16; ++kb) {
      const Mask a = (Mask{1} << ka) - 1, b = ((Mask{1} << kb) - 1) << ka;
      const float z = merge(fragment(0, a, {}, 0), fragment(1, b, {}, 1), MergedPlane::corrected, kGrid16).z;
      EXPECT_TRUE(ka == kb ? z == 0.5f : (kb > ka) == (z > 0.5f)) << ka << " " << kb;
    }
  }
}

// Whatever stands evenly in front and behind, two fragments and their merged one show the same.
TEST(merge, keeps_the_pixel) {
  blysk::Random random(5);
  Resolver resolver(kGrid16);
  for (int i = 0; i < 2000; ++i) {
    const auto any = [&](std::uint32_t id, float z) {
      const Mask mask = static_cast<Mask>(random.next() >> 48) | 1u << (random.next() >> 60);
      const float alpha = i % 3 == 0 ? 1.0f : random.unit();
      const float red = 255 * random.unit(), green = 255 * random.unit(), blue = 255 * random.unit();
      const float zx = random.signed_unit() * 0.1f, zy = random.signed_unit() * 0.1f;
      return fragment(id, mask, {red, green, blue}, z, zx, zy, alpha);
    };
    Fragment a = any(1, 0.5f), b = any(2, 0.5f + 0.05f * random.unit());
    if (a.opaque() && b.opaque()) b.mask &= ~a.mask;
    if (b.mask == 0) continue;
    const Fragment merged = merge(a, b, MergedPlane::least_squares, kGrid16);
    EXPECT_EQ(merged.opaque(), a.opaque() && b.opaque());
    const Fragment front = fragment(0, 0xFFFF, {9, 99, 199}, 0, 0, 0, 0.25f);
    const std::vector<Fragment> two = {front, a, b}, one = {front, merged};
    const blysk::Vec3d back = {16, 128, 240};
    expect_colour(resolver.compose(one).over(back), resolver.compose(two).over(back), 1e-4);
  }
}

}  // namespace
