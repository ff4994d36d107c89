// The A-buffer's variants in the renderer: against the default, against each other, and whatever the threads.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "blysk/metrics.h"
#include "blysk/render.h"
#include "blysk/shapes.h"

namespace {

using blysk::Frame;
using blysk::Renderer;
using blysk::RenderOptions;
using blysk::Scene;

Frame drawn(const Scene& scene, const std::string& antialias, int threads = 2) {
  Renderer renderer({.threads = threads});
  RenderOptions options;
  options.width = 150;
  options.height = 100;
  options.antialias = antialias;
  options.background = {0.125f, 0.25f, 0.5f, 0.5f};
  if (!scene.cameras.empty()) options.camera = scene.cameras[0];
  auto frame = renderer.render(scene, options);
  EXPECT_TRUE(frame) << antialias << ": " << frame.error().text();
  return frame ? std::move(*frame) : Frame{};
}

double nmse(const Frame& reference, const Frame& candidate) {
  return blysk::compare(reference.image, candidate.image)->nmse;
}

constexpr const char* kVariants[] = {
    "abuffer-unlimited", "abuffer-discard",       "abuffer-discard:n=1,policy=d5",
    "abuffer-merge",     "abuffer-pool:pool=700", "abuffer-carpenter"};

// Colours without light: where they are taken does not matter.
TEST(list_tile, unlimited_lists_show_what_the_default_shows) {
  for (const char* shape : {"soup?layers=4", "grass?count=500", "fans", "xfighter"}) {
    Scene scene = *blysk::make_shape(shape);
    for (blysk::Material& m : scene.materials) m.unlit = true;
    const Frame lists = drawn(scene, "abuffer-unlimited"), samples = drawn(scene, "abuffer");
    const auto difference = blysk::compare(samples.image, lists.image);
    EXPECT_LT(difference->nmse, 1e-5) << shape;
    EXPECT_LT(difference->different_pixels, 150u * 100 / 100) << shape;
  }
}

TEST(list_tile, whole_pixels_have_the_bytes_of_one_sample) {
  Scene scene = *blysk::make_shape("cube");
  const Frame none = drawn(scene, "none");
  for (const char* variant : kVariants) {
    const Frame frame = drawn(scene, variant);
    const auto difference = blysk::compare(none.image, frame.image);
    EXPECT_LT(difference->different_pixels, 600u) << variant;  // edges
    EXPECT_GT(difference->different_pixels, 50u) << variant;
  }
}

TEST(list_tile, threads_do_not_show) {
  const Scene scene = *blysk::make_shape("triangles?count=800&size=0.5");
  for (const char* variant : kVariants) {
    const Frame one = drawn(scene, variant, 1);
    for (const int threads : {2, 7}) {
      EXPECT_TRUE(one.image.pixels == drawn(scene, variant, threads).image.pixels) << variant << threads;
    }
  }
}

TEST(list_tile, a_pool_that_never_fills_shows_what_fixed_lists_show) {
  const Scene scene = *blysk::make_shape("triangles?count=800&size=0.5");
  const Frame merged = drawn(scene, "abuffer-merge:n=3,policy=m1"),
              pooled = drawn(scene, "abuffer-pool:main=1,extra=2,pool=65536,policy=m1");
  EXPECT_TRUE(merged.image.pixels == pooled.image.pixels);
  EXPECT_EQ(merged.statistics.fragments_lost, pooled.statistics.fragments_lost);
  EXPECT_GT(merged.statistics.fragments_lost, 0u);
}

TEST(list_tile, more_fragments_are_nearer_to_no_limit) {
  const Scene scene = *blysk::make_shape("micro?layers=8");
  const Frame exact = drawn(scene, "abuffer-unlimited");
  const double one = nmse(exact, drawn(scene, "abuffer-merge:n=1")),
               three = nmse(exact, drawn(scene, "abuffer-merge:n=3")),
               dropped = nmse(exact, drawn(scene, "abuffer-discard:n=3,policy=d1"));
  EXPECT_LT(three, one);
  EXPECT_LT(three, dropped);
  EXPECT_EQ(nmse(exact, drawn(scene, "abuffer-merge:n=16")), 0);
}

TEST(list_tile, glass_beyond_the_limit_of_memory_is_an_error) {
  Scene scene = *blysk::make_shape("triangles?count=3000&size=2");
  scene.materials[0].alpha_mode = blysk::AlphaMode::blend;
  scene.materials[0].opacity = 0.5f;
  Renderer renderer({.threads = 1});
  RenderOptions options;
  options.width = options.height = 64;
  options.antialias = "abuffer-unlimited";
  options.limits.max_memory = 20 << 20;
  const auto frame = renderer.render(scene, options);
  ASSERT_FALSE(frame);
  EXPECT_EQ(frame.error().code, blysk::ErrorCode::limit);
}

}  // namespace
