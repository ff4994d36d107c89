// The classic A-buffer: the specification's values, and packing against the sum over samples.
#include "antialias/carpenter.h"

#include "antialias/testing.h"
#include "core/random.h"

namespace {

using namespace blysk::antialias;
using blysk::Vec3d;
using blysk::Vec3f;
using examples::expect_colour;
using examples::fragment;

CarpenterFragment slab(Mask mask, Vec3f rgb, float opacity, float nearest, float farthest) {
  return {.mask = mask, .rgb = rgb, .opacity = opacity, .nearest = nearest, .farthest = farthest};
}

TEST(carpenter, visible_share_of_the_specification) {
  const CarpenterFragment front = slab(0xFFFF, {200, 200, 200}, 1, 0.2f, 0.7f),
                          next = slab(0xFFFF, {100, 100, 100}, 1, 0.3f, 0.6f);
  EXPECT_NEAR(visible_share(front, next), 0.5, 1e-6);
  const CarpenterFragment both[] = {front, next};
  expect_colour(pack(both, kGrid16).over({}), {150, 150, 150}, 1e-4);

  const CarpenterFragment half[] = {slab(0xFFFF, {200, 200, 200}, 0.5f, 0.2f, 0.7f), next};
  const FrontWeights w = front_weights(half[0], next);
  EXPECT_NEAR(w.front, 0.25, 1e-6);
  EXPECT_NEAR(w.next, 0.75, 1e-6);
  EXPECT_EQ(w.behind, 0);
  expect_colour(pack(half, kGrid16).over({}), {125, 125, 125}, 1e-4);

  const CarpenterFragment a = slab(0xFFFF, {}, 0.6f, 0.2f, 0.4f), b = slab(0xFFFF, {}, 0.4f, 0.35f, 0.45f);
  EXPECT_NEAR(visible_share(a, b), 0.833333, 1e-6);
  const FrontWeights three = front_weights(a, b);
  EXPECT_NEAR(three.front, 0.56, 1e-6);
  EXPECT_NEAR(three.next, 0.2, 1e-6);
  EXPECT_NEAR(three.behind, 0.24, 1e-6);
}

TEST(carpenter, extents_that_only_touch_in_a_point_are_no_overlap) {
  EXPECT_EQ(visible_share(slab(1, {}, 1, 0.5f, 0.5f), slab(1, {}, 1, 0.5f, 0.5f)), 1);
}

// Extents that are apart: packing is plain composing, sample by sample.
TEST(carpenter, packs_apart_layers_exactly) {
  blysk::Random random(6);
  for (int i = 0; i < 500; ++i) {
    std::vector<CarpenterFragment> list;
    for (int k = 0; k < 8; ++k) {
      const float red = 255 * random.unit(), opacity = k % 3 == 0 ? 1 : random.unit(),
                  z = 0.1f * static_cast<float>(k);
      const Mask mask = static_cast<Mask>(random.next() >> 48) | 1u;
      list.push_back(slab(mask, {red, 0, 0}, opacity, z, z + 0.05f));
    }
    const Vec3d background = {50, 0, 0};
    double sum = 0;
    for (std::size_t s = 0; s < 16; ++s) {
      double through = 1;
      for (const CarpenterFragment& f : list) {
        if ((f.mask >> s & 1) == 0) continue;
        sum += through * double{f.opacity} * double{f.rgb.x};
        through *= 1 - double{f.opacity};
      }
      sum += through * background.x;
    }
    EXPECT_NEAR(pack(list, kGrid16).over(background).x, sum / 16, 1e-9);
  }
}

TEST(carpenter, whole_pixels_delete_what_is_behind) {
  CarpenterLists lists(kGrid16);
  lists.clear(1);
  lists.insert(0, fragment(0, 0x00FF, {9, 0, 0}, 0.8f));
  lists.insert(0, fragment(1, 0x0FF0, {0, 9, 0}, 0.2f));
  lists.insert(0, fragment(2, 0xFFFF, {0, 0, 9}, 0.5f));
  lists.insert(0, fragment(3, 0xFFFF, {9, 9, 9}, 0.9f));
  ASSERT_EQ(lists.live(0), 2u);
  EXPECT_EQ(lists.statistics().removed_later, 1u);
  EXPECT_EQ(lists.statistics().hidden_on_arrival, 1u);
  expect_colour(lists.resolve(0, {}), {0, 4.5, 4.5});
}

TEST(carpenter, fragments_of_an_object_grow_together) {
  CarpenterLists lists(kGrid16);
  lists.clear(1);
  const auto insert = [&](Mask mask, Vec3f rgb, float z, std::uint32_t object) {
    Fragment f = fragment(0, mask, rgb, z, 0.1f);
    f.object = object;
    lists.insert(0, f);
  };
  insert(0x000F, {100, 0, 0}, 0.5f, 7);
  insert(0x0FF0, {0, 100, 0}, 0.5f, 7);
  EXPECT_EQ(lists.live(0), 1u);
  EXPECT_EQ(lists.fragments(0)[0].mask, 0x0FFFu);
  insert(0xF000, {0, 0, 100}, 0.5f, 8);  // another object
  insert(0x000F, {0, 0, 100}, 0.5f, 7);  // a fold
  insert(0xF000, {0, 0, 100}, 0.9f, 7);  // too far behind
  EXPECT_EQ(lists.live(0), 4u);
}

// The weakness that visibility masks remove: crossing planes whose steepness differs.
TEST(carpenter, cannot_see_where_surfaces_cross) {
  const Fragment a = fragment(0, 0xFFFF, {160, 0, 0}, 0.4f, 0.2f),
                 b = fragment(1, 0xFFFF, {0, 0, 160}, 0.45f, 0.4f);
  CarpenterLists lists(kGrid16);
  lists.clear(1);
  lists.insert(0, a);
  lists.insert(0, b);
  auto exact = examples::pixel_of({}, {a, b});
  EXPECT_EQ(exact.resolve(0, {}).x, 120);
  EXPECT_GT(std::abs(lists.resolve(0, {}).x - 120), 10);
}

}  // namespace
