// The worked cases of the specification (E-A), to the printed digits.
#include "antialias/fragment_lists.h"

#include "antialias/testing.h"

namespace {

using namespace blysk::antialias;
using blysk::Vec3d;
using examples::expect_colour;
using examples::fragment;
using examples::masks_of;
using examples::pixel_of;
using Masks = std::vector<Mask>;

constexpr Vec3d kBlack = {0, 0, 0};

FragmentLists limited(Overflow overflow, std::size_t most, std::initializer_list<Fragment> fragments) {
  return pixel_of({.overflow = overflow, .most = most}, fragments);
}

TEST(visibility, case_of_the_specification) {
  const Fragment a = fragment(0, 0, {}, 0.5f, 0.25f, 0.125f),
                 b = fragment(1, 0, {}, 0.53125f, -0.125f, 0.25f);
  EXPECT_EQ(visibility(a, b, kGrid16), 0x7733u);
  EXPECT_EQ(visibility(a, b, kGrid32), 0x3F1F0F0Fu);
}

TEST(fragment_lists, a1_intersecting_planes) {
  auto p = pixel_of(
      {}, {fragment(0, 0xFFFF, {200, 0, 0}, 0.5f, 0.4f), fragment(1, 0xFFFF, {0, 0, 200}, 0.5f, -0.4f)});
  EXPECT_EQ(masks_of(p), (Masks{0x3333, 0xCCCC}));
  EXPECT_EQ(p.resolve(0, kBlack), (Vec3d{100, 0, 100}));
}

TEST(fragment_lists, a2_tie_of_coplanar_ones) {
  auto p = pixel_of({}, {fragment(0, 0xFFFF, {10, 20, 30}, 0.5f, 0.125f, 0.25f),
                         fragment(1, 0x0FF0, {200, 200, 200}, 0.5f, 0.125f, 0.25f)});
  EXPECT_EQ(masks_of(p), (Masks{0xFFFF}));
  EXPECT_EQ(p.statistics().hidden_on_arrival, 1u);
  EXPECT_EQ(p.resolve(0, kBlack), (Vec3d{10, 20, 30}));
}

TEST(fragment_lists, a3_ties_on_a_diagonal) {
  auto p = pixel_of({}, {fragment(0, 0xFFFF, {100, 0, 0}, 0.5f, 0.25f, 0),
                         fragment(1, 0xFFFF, {0, 100, 0}, 0.5f, 0, 0.25f)});
  EXPECT_EQ(masks_of(p), (Masks{0xF731, 0x08CE}));
  EXPECT_EQ(p.resolve(0, kBlack), (Vec3d{62.5, 37.5, 0}));
}

TEST(fragment_lists, a4_part_of_a_pixel_over_the_background) {
  auto p = pixel_of({}, {fragment(0, 0x0033, {240, 120, 0}, 0.3f)});
  EXPECT_EQ(p.resolve(0, {16, 32, 64}), (Vec3d{72, 54, 48}));
}

TEST(fragment_lists, a5_early_removal) {
  auto p =
      pixel_of({}, {fragment(0, 0xFFFF, {255, 255, 255}, 0.25f), fragment(1, 0x7FFE, {1, 2, 3}, 0.5f, 0.125f),
                    fragment(2, 0xFFFF, {0, 0, 128}, 0.125f)});
  EXPECT_EQ(masks_of(p), (Masks{0xFFFF}));
  EXPECT_EQ(p.fragments(0)[0].id, 2u);
  EXPECT_EQ(p.statistics().hidden_on_arrival, 1u);
  EXPECT_EQ(p.statistics().removed_later, 1u);
  EXPECT_EQ(p.resolve(0, kBlack), (Vec3d{0, 0, 128}));
}

TEST(fragment_lists, a6_discards_the_farthest) {
  auto p = limited(Overflow::d1, 3,
                   {fragment(0, 0x000F, {200, 0, 0}, 0.2f), fragment(1, 0x0FFF, {0, 200, 0}, 0.4f),
                    fragment(2, 0x3FFF, {0, 0, 200}, 0.6f), fragment(3, 0xFFFF, {100, 100, 100}, 0.8f)});
  EXPECT_EQ(masks_of(p), (Masks{0x000F, 0x0FF0, 0x3000}));
  EXPECT_EQ(p.resolve(0, kBlack), (Vec3d{50, 100, 25}));
}

TEST(fragment_lists, a6b_discards_the_smallest) {
  auto p = limited(Overflow::d2, 3,
                   {fragment(0, 0x000F, {200, 0, 0}, 0.2f), fragment(1, 0x0FFF, {0, 200, 0}, 0.4f),
                    fragment(2, 0x1FFF, {0, 0, 200}, 0.6f), fragment(3, 0xFFFF, {100, 100, 100}, 0.8f)});
  EXPECT_EQ(masks_of(p), (Masks{0x000F, 0x0FF0, 0xE000}));
  EXPECT_EQ(p.resolve(0, kBlack), (Vec3d{68.75, 118.75, 18.75}));
}

// What a6 discards: d3 shows it once more, d5 stretches the rest over its place.
TEST(fragment_lists, other_readings_of_discarding) {
  const auto shown = [](Overflow overflow) {
    auto p = limited(overflow, 3,
                     {fragment(0, 0x000F, {200, 0, 0}, 0.2f), fragment(1, 0x0FFF, {0, 200, 0}, 0.4f),
                      fragment(2, 0x3FFF, {0, 0, 200}, 0.6f), fragment(3, 0xFFFF, {100, 100, 100}, 0.8f)});
    EXPECT_EQ(p.live(0), 3u);
    return p.resolve(0, {16, 16, 16});
  };
  expect_colour(shown(Overflow::d3), {62.5, 112.5, 37.5});
  expect_colour(shown(Overflow::d4), {62.5, 112.5, 37.5});
  expect_colour(shown(Overflow::d5), {800.0 / 14, 1600.0 / 14, 400.0 / 14});
}

std::initializer_list<Fragment> four_steps() {
  static const auto steps = {fragment(0, 0x000F, {200, 0, 0}, 0.2f, 0.1f, 0),
                             fragment(1, 0x0FFF, {0, 200, 0}, 0.4f, -0.05f, 0.2f),
                             fragment(2, 0x3FFF, {0, 0, 200}, 0.6f, 0.02f, -0.1f),
                             fragment(3, 0xFFFF, {100, 100, 100}, 0.8f, -0.3f, 0.05f)};
  return steps;
}

TEST(fragment_lists, a7_merges_the_two_farthest) {
  auto p = limited(Overflow::m1, 3, four_steps());
  EXPECT_EQ(masks_of(p), (Masks{0x000F, 0x0FF0, 0xF000}));
  const Fragment merged = p.fragments(0)[2];
  EXPECT_EQ(merged.rgb, (blysk::Vec3f{50, 50, 150}));
  EXPECT_FLOAT_EQ(merged.z, 0.7f);
  EXPECT_EQ(merged.zx, 0.02f);
  EXPECT_EQ(merged.zy, 0.05f);
  EXPECT_EQ(merged.id, 2u);
  EXPECT_EQ(p.resolve(0, kBlack), (Vec3d{62.5, 112.5, 37.5}));
}

TEST(fragment_lists, a7b_merges_as_printed) {
  auto p = limited(Overflow::m0, 3, four_steps());
  const Fragment merged = p.fragments(0)[2];
  EXPECT_EQ(merged.mask, 0xF000u);
  EXPECT_EQ(merged.rgb, (blysk::Vec3f{12.5f, 12.5f, 37.5f}));
  EXPECT_FLOAT_EQ(merged.z, 0.625f);
  EXPECT_EQ(merged.zx, 0.02f);
  EXPECT_EQ(merged.zy, 0.05f);
  EXPECT_EQ(p.resolve(0, kBlack), (Vec3d{53.125, 103.125, 9.375}));
}

TEST(fragment_lists, a7c_merges_the_pair_that_loses_least) {
  auto p = limited(Overflow::m5, 3, four_steps());
  EXPECT_EQ(masks_of(p), (Masks{0x000F, 0x3FF0, 0xC000}));
  const Fragment merged = p.fragments(0)[1];
  expect_colour(blysk::to_double(merged.rgb), {0, 160, 40});
  EXPECT_NEAR(merged.z, 0.404863829, 5e-8);
  EXPECT_NEAR(merged.zx, -0.061396208, 5e-8);
  EXPECT_NEAR(merged.zy, 0.314218145, 5e-8);
  expect_colour(p.resolve(0, kBlack), {62.5, 112.5, 37.5});
}

TEST(fragment_lists, a8_what_comes_between_merged_ones_is_lost) {
  const auto in = {fragment(0, 0x00FF, {200, 0, 0}, 0.4f), fragment(1, 0xFF00, {0, 200, 0}, 0.6f),
                   fragment(2, 0x0FF0, {0, 0, 200}, 0.5f)};
  auto p = limited(Overflow::m1, 1, in);
  EXPECT_EQ(masks_of(p), (Masks{0xFFFF}));
  EXPECT_EQ(p.fragments(0)[0].z, 0.5f);
  EXPECT_EQ(p.resolve(0, kBlack), (Vec3d{100, 100, 0}));
  auto exact = pixel_of({}, in);
  EXPECT_EQ(masks_of(exact), (Masks{0x00FF, 0x0F00, 0xF000}));
  EXPECT_EQ(exact.resolve(0, kBlack), (Vec3d{100, 50, 50}));
}

TEST(fragment_lists, a9_thirty_two_samples) {
  auto p = pixel_of({.pattern = &kGrid32}, {fragment(0, 0xFFFFFFFF, {128, 0, 0}, 0.5f, 1.0f / 3, 1.0f / 7),
                                            fragment(1, 0x00FFFF00, {0, 64, 0}, 0.5f, -1.0f / 3, 0)});
  EXPECT_EQ(masks_of(p), (Masks{0xFF0F0FFF, 0x00F0F000}));
  EXPECT_EQ(p.resolve(0, kBlack), (Vec3d{96, 16, 0}));
}

TEST(fragment_lists, a10_opacity) {
  auto p = pixel_of(
      {}, {fragment(0, 0xFFFF, {200, 0, 0}, 0.25f, 0, 0, 0.5f), fragment(1, 0xFFFF, {0, 0, 200}, 0.5f)});
  EXPECT_EQ(masks_of(p), (Masks{0xFFFF, 0xFFFF}));
  EXPECT_EQ(p.resolve(0, kBlack), (Vec3d{100, 0, 100}));
}

TEST(fragment_lists, a11_intersecting_glass) {
  auto p = pixel_of({}, {fragment(0, 0xFFFF, {200, 0, 0}, 0.5f, 0.4f, 0, 0.5f),
                         fragment(1, 0xFFFF, {0, 0, 200}, 0.5f, -0.4f, 0, 0.25f)});
  EXPECT_EQ(masks_of(p), (Masks{0xFFFF, 0xFFFF}));
  EXPECT_EQ(p.resolve(0, {40, 40, 40}), (Vec3d{102.5, 15, 52.5}));
}

TEST(fragment_lists, a12_glass_before_and_behind) {
  auto p = pixel_of(
      {}, {fragment(0, 0x00FF, {255, 255, 255}, 0.1f, 0, 0, 0.75f), fragment(1, 0x0FF0, {0, 160, 0}, 0.2f),
           fragment(2, 0xFFFF, {80, 0, 0}, 0.3f, 0, 0, 0.5f)});
  EXPECT_EQ(masks_of(p), (Masks{0x00FF, 0x0FF0, 0xF00F}));
  EXPECT_EQ(p.resolve(0, {100, 100, 100}), (Vec3d{123.75, 161.25, 111.25}));
}

TEST(fragment_lists, ties_by_rule) {
  const Fragment early = fragment(0, 0xFFFF, {1, 0, 0}, 0.5f), late = fragment(1, 0xFFFF, {0, 1, 0}, 0.5f);
  const auto shown = [](Tie tie, const Fragment& first, const Fragment& second) {
    auto p = pixel_of({.tie = tie}, {first, second});
    return p.resolve(0, kBlack);
  };
  EXPECT_EQ(shown(Tie::existing, late, early), (Vec3d{0, 1, 0}));
  EXPECT_EQ(shown(Tie::newer, late, early), (Vec3d{1, 0, 0}));
  EXPECT_EQ(shown(Tie::lower_id, late, early), (Vec3d{1, 0, 0}));
  EXPECT_EQ(shown(Tie::lower_id, early, late), (Vec3d{1, 0, 0}));
}

// Colours by number, and how often they were asked for.
class CountedColours final : public Colours {
 public:
  blysk::Vec3f colour(std::size_t, const Fragment& f) override {
    ++asked;
    return {static_cast<float>(10 * f.id), 0, 0};
  }
  int asked = 0;
};

TEST(fragment_lists, late_colours_are_asked_for_what_is_seen_only) {
  CountedColours colours;
  FragmentLists lists({.overflow = Overflow::m1, .most = 1});
  lists.set_colours(&colours);
  lists.clear(1);
  const auto insert = [&](std::uint32_t id, Mask mask, float z) {
    Fragment f = fragment(id, mask, {}, z);
    f.lit = false;
    lists.insert(0, f);
  };
  insert(1, 0xFFFF, 0.5f);
  insert(2, 0xFFFF, 0.4f);
  insert(3, 0xFFFF, 0.6f);
  EXPECT_EQ(colours.asked, 0);
  insert(4, 0x00FF, 0.1f);
  EXPECT_EQ(colours.asked, 2);
  EXPECT_EQ(lists.resolve(0, kBlack), (Vec3d{30, 0, 0}));
  EXPECT_EQ(colours.asked, 2);
}

}  // namespace
