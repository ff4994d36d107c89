// The study of the A-buffer: earlier figures hold within the spread of seeds, and its findings with them.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "blysk/study.h"
#include "study/abuffer_results.h"
#include "study/cells.h"
#include "study/log_plot.h"

namespace {

using namespace blysk::study;
using blysk::ThreadPool;
using blysk::antialias::Overflow;

const SceneRow& row_of(std::string_view name) {
  return *std::ranges::find(scene_rows(), name, &SceneRow::name);
}

std::vector<Variant> expected_variants() {
  std::vector<Variant> variants = {{.kind = Variant::Kind::zbuffer}};
  for (const Overflow policy : kExpectedPolicies) variants.push_back({.overflow = policy, .most = 3});
  return variants;
}

class AbufferScenes : public testing::TestWithParam<std::string_view> {};

TEST_P(AbufferScenes, agree_with_earlier_figures) {
  const SceneRow& row = row_of(GetParam());
  const Expected& expected = row.expected;
  const auto scene = make_scene(row);
  ASSERT_TRUE(scene);
  ThreadPool threads(2);
  const Submission run = {Order::random, 1, expected_variants()};
  const Measured m = measure(*scene, {&run, 1}, threads)[0];
  const auto near = [&](double is, double wanted, double factor) {
    EXPECT_LE(is, wanted * factor) << row.name;
    EXPECT_GE(is, wanted / factor) << row.name;
  };
  near(m.complexity.generated.mean, expected.generated, 1.1);
  near(m.complexity.live.mean, expected.live, 1.2);
  near(m.quality[0].nmse, expected.zbuffer, 2.5);
  for (std::size_t i = 0; i < expected.policies.size(); ++i) {
    SCOPED_TRACE(overflow_name(kExpectedPolicies[i]));
    if (expected.policies[i] > 1e-5) {
      near(m.quality[i + 1].nmse, expected.policies[i], expected.factor);
    } else {  // a few pixels of the picture
      EXPECT_LE(m.quality[i + 1].nmse, 1e-4);
    }
  }
  EXPECT_LE(m.complexity.most_live, 16u);
}

INSTANTIATE_TEST_SUITE_P(cheap, AbufferScenes,
                         testing::Values("soup-5", "soup-20", "mesh-2k", "mesh-36k", "grass", "fans"),
                         [](const auto& p) {
                           std::string name(p.param);
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });

TEST(abuffer_memory, agrees_with_earlier_figures_and_pools_show_no_difference) {
  ThreadPool threads(2);
  for (const std::string_view name : {"soup-5", "grass"}) {
    const auto scene = make_scene(row_of(name));
    ASSERT_TRUE(scene);
    const std::vector<MemoryRow> rows = measure_memory(*scene, Order::random, 1, threads);
    ASSERT_EQ(rows.size(), row_of(name).expected.ratios.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      EXPECT_NEAR(rows[i].ratio, row_of(name).expected.ratios[i], 0.05) << name << " " << i;
      EXPECT_TRUE(rows[i].same_picture) << name << " " << i;
      EXPECT_GE(rows[i].quarter, rows[i].half) << name << " " << i;
      EXPECT_GE(rows[i].half, rows[i].nmse) << name << " " << i;
    }
  }
}

// Findings of the specification that hold in every scene.
TEST(abuffer_study, merging_as_printed_is_the_worst_and_wards_pair_the_best) {
  ThreadPool threads(2);
  const auto scene = make_scene(row_of("soup-5"));
  ASSERT_TRUE(scene);
  const SceneResult result = measure_all(*scene, &row_of("soup-5"), threads);
  for (std::size_t n = 2; n <= 4; ++n) {
    EXPECT_LT(result.at(Overflow::m5, n).nmse, result.at(Overflow::m3, n).nmse);
    EXPECT_LT(result.at(Overflow::m3, n).nmse, result.at(Overflow::m1, n).nmse);
    EXPECT_LT(result.at(Overflow::m1, n).nmse, result.at(Overflow::m0, n).nmse);
    EXPECT_LT(result.at(Overflow::d4, n).nmse, result.at(Overflow::m0, n).nmse);
  }
  EXPECT_EQ(result.least(Overflow::m1, 1e-3), 3u);
  EXPECT_EQ(result.least(Overflow::m5, 1e-3), 2u);
  EXPECT_EQ(result.least(Overflow::d1, -1), std::nullopt);
  const auto claims = abuffer_claims(result);
  ASSERT_EQ(claims.size(), 6u);
  EXPECT_EQ(claims[0].verdict, blysk::Verdict::fails);
  EXPECT_EQ(claims[2].verdict, blysk::Verdict::holds);
}

TEST(abuffer_study, reports_do_not_depend_on_threads) {
  const auto one = blysk::study_abuffer({.threads = 1, .scenes = {"mesh-2k"}});
  const auto three = blysk::study_abuffer({.threads = 3, .scenes = {"mesh-2k"}});
  ASSERT_TRUE(one);
  ASSERT_TRUE(three);
  ASSERT_EQ(one->sections.size(), three->sections.size());
  for (std::size_t i = 0; i < one->sections.size(); ++i) {
    const auto &a = one->sections[i], &b = three->sections[i];
    ASSERT_EQ(a.tables.size(), b.tables.size());
    for (std::size_t t = 0; t < a.tables.size(); ++t) {
      for (std::size_t r = 0; r < a.tables[t].rows.size(); ++r) {
        ASSERT_EQ(a.tables[t].rows[r].size(), a.tables[t].columns.size()) << a.tables[t].title;
        for (std::size_t c = 0; c < a.tables[t].columns.size(); ++c) {
          EXPECT_EQ(a.tables[t].rows[r][c].text, b.tables[t].rows[r][c].text);
        }
      }
    }
    for (std::size_t p = 0; p < a.plots.size(); ++p) EXPECT_EQ(a.plots[p].bytes, b.plots[p].bytes);
  }
}

TEST(abuffer_turning, errors_are_those_of_its_frames) {
  ThreadPool threads(2);
  const auto result = measure_turning("xfighter", threads);
  ASSERT_TRUE(result);
  EXPECT_GT(result->moving, 0);
  for (const TurningRow& row : result->rows) {
    EXPECT_GT(row.mean, 0);
    EXPECT_GE(row.worst, row.mean);
    EXPECT_LT(row.worst, 0.01);
    EXPECT_LT(row.flicker, 2 * row.worst);
  }
}

TEST(abuffer_study, unknown_scenes_and_models_are_refused) {
  const auto scene = blysk::study_abuffer({.scenes = {"soup-7"}});
  ASSERT_FALSE(scene);
  EXPECT_EQ(scene.error().code, blysk::ErrorCode::usage);
  EXPECT_EQ(scene.error().source, "soup-7");
  EXPECT_FALSE(blysk::study_abuffer({.scenes = {"mesh-2k"}, .models = {"/nowhere.obj"}}));
}

TEST(cells, numbers_as_people_write_them) {
  EXPECT_EQ(scientific_text(0.00029), "2.9e-4");
  EXPECT_EQ(scientific_text(1.5e-12), "1.5e-12");
  EXPECT_EQ(scientific_text(12), "1.2e+1");
  EXPECT_EQ(scientific_text(0), "0");
  EXPECT_EQ(fixed_text(40.875, 1), "40.9");
  EXPECT_EQ(fixed_text(1 / 0.0, 1), "exact");
  EXPECT_EQ(percent(0.125).text, "12.5 %");
}

TEST(spread_of, counts) {
  std::vector<std::uint32_t> counts(200, 1);
  counts[7] = 9;
  counts[8] = 3;
  counts[9] = 2;
  const Spread s = spread_of(counts);
  EXPECT_EQ(s.most, 9u);
  EXPECT_EQ(s.p99, 2u);
  EXPECT_DOUBLE_EQ(s.mean, 211.0 / 200);
  EXPECT_EQ(spread_of({}).most, 0u);
}

TEST(log_plot, draws_every_curve) {
  const std::string svg =
      log_plot({{"one", {{"a<b", {{1, 1e-2}, {2, 0}}}, {"c", {{1, 1}}}}}}, {.x_label = "N", .y_label = "E"});
  EXPECT_TRUE(svg.starts_with("<svg "));
  EXPECT_TRUE(svg.ends_with("</svg>\n"));
  EXPECT_NE(svg.find("a&lt;b"), std::string::npos);
  std::size_t curves = 0;
  for (std::size_t at = 0; (at = svg.find("<polyline", at)) != std::string::npos; ++at) ++curves;
  EXPECT_EQ(curves, 2u);
}

}  // namespace
