// Static-dynamic memory: the specification's walk-through, its rules, and its table of sizes.
#include "antialias/fragment_pool.h"

#include "antialias/memory_bits.h"
#include "antialias/testing.h"
#include "core/random.h"

namespace {

using namespace blysk::antialias;
using examples::expect_colour;
using examples::fragment;

constexpr std::size_t kP = 0, kQ = 1;

TEST(fragment_pool, walk_through_of_the_specification) {
  FragmentPool pool({.main = 1, .extra = 2, .pool = 2});
  pool.clear(2);
  std::uint32_t id = 0;
  const auto arrives = [&](std::size_t pixel, Mask mask, float z, std::size_t live, std::size_t used) {
    pool.insert(pixel, fragment(id++, mask, {1, 1, 1}, z));
    EXPECT_EQ(pool.live(pixel), live) << id;
    EXPECT_EQ(2 - pool.slots_free(), used) << id;
    EXPECT_TRUE(pool.sound()) << id;
  };
  arrives(kP, 0x000F, 0.5f, 1, 0);
  arrives(kP, 0x00F0, 0.5f, 2, 1);
  arrives(kQ, 0x000F, 0.5f, 1, 1);
  arrives(kP, 0x0F00, 0.5f, 3, 2);
  EXPECT_EQ(pool.statistics().overflowed, 0u);
  arrives(kQ, 0x00F0, 0.5f, 1, 2);  // the pool is full
  EXPECT_EQ(pool.statistics().overflowed, 1u);
  arrives(kP, 0xF000, 0.5f, 3, 2);  // there are no more addresses
  EXPECT_EQ(pool.statistics().overflowed, 2u);
  arrives(kP, 0xFFFF, 0.1f, 1, 0);
  arrives(kQ, 0xFF00, 0.5f, 2, 1);
  EXPECT_EQ(pool.statistics().pool_peak, 2u);
}

Fragment any_fragment(blysk::Random& random, std::uint32_t id, bool glass) {
  const Mask mask = static_cast<Mask>(random.next() >> 48) | 1u;
  const float z = random.unit(), zx = 0.2f * random.signed_unit(), zy = 0.2f * random.signed_unit();
  const float red = 255 * random.unit(), green = 255 * random.unit(), blue = 255 * random.unit();
  return fragment(id, mask, {red, green, blue}, z, zx, zy, glass && random.unit() < 0.5f ? 0.5f : 1);
}

TEST(fragment_pool, rules_hold_whatever_arrives) {
  blysk::Random random(3);
  for (const bool glass : {false, true}) {
    for (const std::size_t slots : {0, 1, 7, 40}) {
      FragmentPool pool({.main = 2, .extra = 3, .pool = slots, .overflow = Overflow::m5});
      pool.clear(20);
      for (std::uint32_t id = 0; id < 2000; ++id) {
        const std::size_t pixel = random.next() % 20;
        pool.insert(pixel, any_fragment(random, id, glass));
        ASSERT_TRUE(pool.sound()) << slots << " " << id;
        ASSERT_LE(pool.live(pixel), 5u);
        std::size_t live = 0, owned = 0;
        for (std::size_t p = 0; p < 20; ++p) {
          live += pool.live(p);
          owned += pool.slots_owned(p);
          ASSERT_EQ(pool.slots_owned(p), pool.live(p) > 2 ? pool.live(p) - 2 : 0);
        }
        ASSERT_EQ(live, pool.statistics().live);
        ASSERT_EQ(owned, pool.statistics().pool_used);
      }
    }
  }
}

TEST(fragment_pool, one_that_never_fills_shows_what_fixed_lists_show) {
  blysk::Random random(4);
  for (const Overflow overflow :
       {Overflow::m0, Overflow::m1, Overflow::m2, Overflow::m3, Overflow::m4, Overflow::m5}) {
    FragmentPool pool({.main = 1, .extra = 2, .pool = 20, .overflow = overflow});
    FragmentLists fixed({.overflow = overflow, .most = 3});
    pool.clear(10);
    fixed.clear(10);
    for (std::uint32_t id = 0; id < 500; ++id) {
      const std::size_t pixel = random.next() % 10;
      const Fragment f = any_fragment(random, id, false);
      pool.insert(pixel, f);
      fixed.insert(pixel, f);
    }
    for (std::size_t p = 0; p < 10; ++p) {
      EXPECT_EQ(pool.resolve(p, {7, 8, 9}), fixed.resolve(p, {7, 8, 9}));
      const auto list = pool.fragments(p);
      ASSERT_EQ(list.size(), fixed.fragments(p).size());
      for (std::size_t i = 0; i < list.size(); ++i) EXPECT_EQ(list[i].mask, fixed.fragments(p)[i].mask);
    }
    EXPECT_EQ(pool.statistics().overflowed, fixed.statistics().overflowed);
  }
}

TEST(memory_bits, table_of_the_specification) {
  EXPECT_EQ(fragment_bits(16), 112u);
  EXPECT_EQ(fragment_bits(32), 128u);
  const struct {
    BufferShape shape;
    std::uint64_t address, pooled, fixed;
    double ratio;
  } rows[] = {
      {{640 * 480, 1, 2, 100'000, 16}, 17, 56'051'200, 103'219'200, 1.841516},
      {{640 * 480, 1, 7, 100'000, 16}, 17, 82'163'200, 275'251'200, 3.350055},
      {{1024 * 768, 2, 6, 131'072, 16}, 17, 271'056'896, 704'643'072, 2.599613},
      {{1024 * 768, 1, 5, 98'304, 16}, 17, 165'937'152, 528'482'304, 3.184834},
      {{1920 * 1080, 1, 3, 500'000, 32}, 19, 447'616'000, 1'061'683'200, 2.371862},
  };
  for (const auto& row : rows) {
    EXPECT_EQ(address_bits(row.shape.pool), row.address);
    EXPECT_EQ(pooled_bits(row.shape), row.pooled);
    EXPECT_EQ(fixed_bits(row.shape), row.fixed);
    EXPECT_NEAR(memory_ratio(row.shape), row.ratio, 5e-7);
  }
  EXPECT_EQ(address_bits(0), 0u);
  EXPECT_EQ(address_bits(2), 1u);
  EXPECT_EQ(address_bits(3), 2u);
  EXPECT_NEAR(static_cast<double>(multisample_bits(1, 16)) / 112, 6.86, 0.005);
}

}  // namespace
