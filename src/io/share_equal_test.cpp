#include "io/share_equal.h"

#include <gtest/gtest.h>

#include <random>

namespace blysk::io {
namespace {

struct Number {
  std::uint32_t value;
  [[nodiscard]] std::uint64_t hash() const { return value * 0x9e3779b97f4a7c15u; }
  friend bool operator==(const Number&, const Number&) = default;
};

SharedKeys<Number> share(const std::vector<std::uint32_t>& things, int threads) {
  ThreadPool pool(threads);
  return share_equal<Number>(
      things.size(),
      [&](std::size_t begin, std::size_t end, const auto& take) {
        for (std::size_t i = begin; i < end; ++i) take(Number{things[i]});
      },
      pool);
}

Array<Number> keys(const SharedKeys<Number>& shared) {
  Array<Number> all;
  for (const Array<Number>& run : shared.runs) all.insert(all.end(), run.begin(), run.end());
  EXPECT_EQ(all.size(), shared.count());
  return all;
}

TEST(share_equal, counts_first_appearances) {
  const SharedKeys<Number> s = share({7, 5, 7, 0, 5, 0}, 1);
  EXPECT_EQ(s.ids, (Array<std::uint32_t>{0, 1, 0, 2, 1, 2}));
  EXPECT_EQ(keys(s), (Array<Number>{{7}, {5}, {0}}));
}

TEST(share_equal, nothing) {
  const SharedKeys<Number> s = share({}, 2);
  EXPECT_TRUE(s.ids.empty() && s.count() == 0);
}

// The corners of a grid's squares: those of one row come again in the next.
TEST(share_equal, meshes_share_nearly_all_on_any_number_of_threads) {
  constexpr std::uint32_t kSide = 300;
  std::vector<std::uint32_t> things;
  for (std::uint32_t i = 0; i < kSide * kSide; ++i) {
    const std::uint32_t corner = i / kSide * (kSide + 1) + i % kSide;
    things.insert(things.end(),
                  {corner, corner + 1, corner + kSide + 2, corner, corner + kSide + 2, corner + kSide + 1});
  }
  const SharedKeys<Number> one = share(things, 1);
  for (const int threads : {2, 3, 7}) {
    const SharedKeys<Number> many = share(things, threads);
    EXPECT_EQ(one.ids, many.ids);
    EXPECT_EQ(keys(one), keys(many));
  }
  const Array<Number> all = keys(one);
  for (std::size_t i = 0; i < things.size(); ++i) ASSERT_EQ(all[one.ids[i]].value, things[i]);
  EXPECT_LE(all.size(), (kSide + 1) * (kSide + 1) * 102 / 100);
}

// Many more things than are remembered, and equal ones far from each other.
TEST(share_equal, what_is_far_may_stay_alone) {
  std::mt19937 random(5);
  std::vector<std::uint32_t> things(500'000);
  for (std::uint32_t& t : things) t = static_cast<std::uint32_t>(random() % 100'000);
  const SharedKeys<Number> s = share(things, 2);
  const Array<Number> all = keys(s);
  std::size_t known = 0;
  for (std::size_t i = 0; i < things.size(); ++i) {
    ASSERT_EQ(all[s.ids[i]].value, things[i]);
    ASSERT_LE(s.ids[i], known);
    known += s.ids[i] == known;
  }
  EXPECT_EQ(known, all.size());
  EXPECT_GT(known, 100'000u);
}

}  // namespace
}  // namespace blysk::io
