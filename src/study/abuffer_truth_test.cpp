// The default antialiasing against 256 samples a pixel, and against common multisampling.
#include "study/abuffer_truth.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "blysk/metrics.h"
#include "study/multisampled.h"

namespace {

using namespace blysk::study;

TruthScene scene_of(const std::string& name) {
  auto scene = truth_scene(name, {});
  EXPECT_TRUE(scene) << scene.error().text();
  return std::move(*scene);
}

// With one sample at the centre it is the renderer's picture without antialiasing, but for float rounding.
TEST(multisampled, one_sample_is_no_antialiasing) {
  TruthScene s = scene_of("xfighter");
  const auto image = multisampled(s.scene, s.options, {.pattern = &blysk::antialias::kCentre});
  ASSERT_TRUE(image);
  s.options.antialias = "none";
  const auto frame = blysk::Renderer({.threads = 2}).render(s.scene, s.options);
  ASSERT_TRUE(frame);
  const auto difference = blysk::compare(frame->image, *image);
  EXPECT_LT(difference->nmse, 1e-5);
  EXPECT_LT(difference->different_pixels, 320u * 240 / 50);
}

void expect_claims(const std::string& name) {
  const auto result = measure_truth(scene_of(name), "supersample:n=4", 2);
  ASSERT_TRUE(result) << result.error().text();
  const double own = result->nmse("abuffer");
  // Both see the same samples: what is left are the places of shading, and rounding to bytes.
  EXPECT_LE(own, 1.001 * result->nmse("16x")) << name;
  EXPECT_LE(3 * own, result->nmse("4x")) << name;
  EXPECT_LT(result->nmse("abuffer:samples=32"), own) << name;
}

TEST(abuffer_truth, default_is_no_farther_than_sixteen_and_three_times_nearer_than_four) {
  for (const char* name : {"xfighter", "slivers"}) expect_claims(name);
}

TEST(abuffer_truth, the_same_of_the_bunny) {
  const std::filesystem::path models = BLYSK_MODELS;
  if (models.empty()) GTEST_SKIP() << "configure with -DBLYSK_MODELS=FOLDER to read real models";
  expect_claims((models / "mesh/bunny.stl").string());
}

}  // namespace
