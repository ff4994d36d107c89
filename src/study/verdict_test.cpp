#include "study/verdict.h"

#include <gtest/gtest.h>

#include "study/cells.h"

namespace blysk::study {
namespace {

std::vector<StudyMeasurement> gains(const std::vector<double>& values) {
  std::vector<StudyMeasurement> measured;
  for (const double v : values) measured.push_back({"place " + std::to_string(measured.size()), factor(v)});
  return measured;
}

TEST(verdict, a_gain_holds_where_all_reach_it) {
  EXPECT_EQ(judge_gain(2, 0, gains({2.1, 1.8})), Verdict::holds);  // nine tenths will do
  EXPECT_EQ(judge_gain(2, 0, gains({2.1, 1.79})), Verdict::in_part);
  EXPECT_EQ(judge_gain(2, 9, gains({1.1, 1.79})), Verdict::fails);
  EXPECT_EQ(tell_gain(2, 0, gains({2.1, 2.2})), "Reached.");
  EXPECT_EQ(tell_gain(2, 0, gains({2.1, 1, 1})), "Reached by place 0, not by place 1 and place 2.");
  EXPECT_EQ(tell_gain(2, 0, gains({1, 1})), "Reached nowhere.");
}

TEST(verdict, witnesses_are_not_judged_by) {
  std::vector<StudyMeasurement> measured = gains({2.1, 0.5});
  measured[1].witness = true;
  EXPECT_EQ(judge_gain(2, 0, measured), Verdict::holds);
  EXPECT_EQ(tell_gain(2, 0, measured), "Reached.");
}

TEST(verdict, without_measurements_the_model_is_judged) {
  EXPECT_EQ(judge_gain(2, 3, {}), Verdict::in_part);
  EXPECT_EQ(judge_gain(2, 1, {}), Verdict::fails);
  EXPECT_EQ(tell_gain(2, 3, {}), "Not measured; by its operations alone the gain is 3.00x.");
}

TEST(verdict, a_bound_holds_to_its_last_digit) {
  EXPECT_EQ(judge_bound(0.0498, 0.0498253, 0.0001), Verdict::holds);
  EXPECT_EQ(judge_bound(0.00357, 0.0035814, 0.00001), Verdict::in_part);
  EXPECT_EQ(judge_bound(0.0051, 0.0056311, 0.0001), Verdict::fails);
}

TEST(cells, texts) {
  EXPECT_EQ(count(0).text, "0");
  EXPECT_EQ(count(999).text, "999");
  EXPECT_EQ(count(1234567).text, "1,234,567");
  EXPECT_EQ(percent(0.00357, 3).text, "0.357 %");
  EXPECT_EQ(significant(0.000123456, 2).text, "0.00012");
  EXPECT_EQ(factor(1.826).text, "1.83x");
  EXPECT_FALSE(word("x").value);
}

}  // namespace
}  // namespace blysk::study
