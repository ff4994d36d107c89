// Fragments and coverage of pixels, and their statistics: the worked cases, brute force, and every method.
#include <gtest/gtest.h>

#include <cstring>
#include <numeric>
#include <set>

#include "antialias/memory_bits.h"
#include "blysk/shapes.h"
#include "render/sample_testing.h"

namespace blysk {
namespace {

constexpr const char* kMethods[] = {"none",
                                    "abuffer",
                                    "abuffer-unlimited",
                                    "abuffer-discard:n=2,policy=d4",
                                    "abuffer-merge:n=1",
                                    "abuffer-pool:main=1,extra=2,pool=300",
                                    "abuffer-carpenter"};

bool has_lists(std::string_view method) { return method.starts_with("abuffer-"); }

RenderOptions counting(const std::string& method) {
  RenderOptions o;
  o.width = 150;
  o.height = 100;
  o.antialias = method;
  o.want_fragments = o.want_coverage = o.want_complexity = true;
  return o;
}

Scene made(const char* shape, float opacity = 1) {
  Scene scene = *make_shape(shape);
  for (Material& m : scene.materials) {
    m.alpha_mode = opacity < 1 ? AlphaMode::blend : AlphaMode::opaque;
    m.opacity = opacity;
  }
  return scene;
}

std::uint64_t sum(const Array<std::uint32_t>& counts) {
  return std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
}

// One pixel of the specification's cases E-A: the one at (4, 4) of a picture of 9 by 9. Places count from its
// corner, depths are 0 near to 1 far.
struct Corner {
  double x, y, depth;
};

void add(Scene& scene, const std::vector<Corner>& corners, float opacity = 1) {
  std::vector<Vec3f> positions;
  for (const Corner& c : corners) {
    positions.push_back(
        {static_cast<float>(c.x - 0.5), static_cast<float>(0.5 - c.y), static_cast<float>(1 - 2 * c.depth)});
  }
  const std::vector<std::uint32_t> one = {0, 1, 2}, two = {0, 1, 2, 0, 2, 3};
  Material material;
  material.opacity = opacity;
  material.alpha_mode = opacity < 1 ? AlphaMode::blend : AlphaMode::opaque;
  scene.add(mesh_of(positions, corners.size() == 3 ? one : two), material);
}

// Over the whole pixel, of a depth there and a slope to the right.
void add_whole(Scene& scene, double depth, double slope = 0, float opacity = 1) {
  add(scene, {{0, 0, depth - slope / 2}, {2, 0, depth + slope * 1.5}, {0, 2, depth - slope / 2}}, opacity);
}

// Rows of samples from `first` to before `end`. In this pixel they are all of the first triangle: the strip's
// diagonal runs below them.
void add_rows(Scene& scene, int first, int end, double depth, float opacity = 1) {
  const double top = first / 4.0, bottom = end / 4.0;
  add(scene, {{-3.5, top, depth}, {1, top, depth}, {1, bottom, depth}, {-3.5, bottom, depth}}, opacity);
}

struct Pixel {
  std::uint32_t live;
  float coverage;
  FrameStatistics statistics;
};

Pixel pixel_of(const Scene& scene, const std::string& method) {
  RenderOptions o = counting(method);
  o.width = o.height = 9;
  o.camera = pixel_camera(9);
  o.cull = Cull::none;
  const Frame frame = render_frame(scene, o);
  return {frame.fragments[4 * 9 + 4], frame.coverage.values[4 * 9 + 4], frame.statistics};
}

void expect_pixel(const Scene& scene, std::uint32_t live, float coverage) {
  for (const char* method : {"abuffer", "abuffer-unlimited"}) {
    const Pixel p = pixel_of(scene, method);
    EXPECT_EQ(p.live, live) << method;
    EXPECT_EQ(p.coverage, coverage) << method;
  }
}

TEST(planes, worked_cases_of_opaque_surfaces) {
  Scene a1, a2, a4, a5, a6;
  add_whole(a1, 0.5, 0.25);  // planes that cross
  add_whole(a1, 0.5, -0.25);
  expect_pixel(a1, 2, 1);
  add_whole(a2, 0.5);  // coplanar ones
  add_whole(a2, 0.5);
  expect_pixel(a2, 1, 1);
  EXPECT_EQ(pixel_of(a2, "abuffer-unlimited").statistics.fragments_removed_later, 0u);
  add(a4, {{0, 0, 0.3}, {0.5, 0, 0.3}, {0.5, 0.5, 0.3}, {0, 0.5, 0.3}});  // of two triangles
  expect_pixel(a4, 2, 0.25f);
  add_whole(a5, 0.25);  // one in front of it comes later
  add_whole(a5, 0.5);
  add_whole(a5, 0.125);
  expect_pixel(a5, 1, 1);
  const FrameStatistics s = pixel_of(a5, "abuffer-unlimited").statistics;
  EXPECT_GT(s.fragments_hidden_on_arrival, 0u);
  EXPECT_EQ(s.fragments_hidden_on_arrival, s.fragments_removed_later);
  EXPECT_EQ(s.complexity.hidden, s.fragments_hidden_on_arrival + s.fragments_removed_later);
  add_whole(a6, 0.9);
  expect_pixel(a6, 1, 1);
  EXPECT_EQ(pixel_of(a6, "none").live, 1u);
  EXPECT_EQ(pixel_of(a6, "none").coverage, 1.0f);
}

// E-A8: of two half pixels and one between them three fragments are left, or one where there is room for one.
TEST(planes, worked_case_of_merging) {
  Scene a8;
  add_rows(a8, 0, 2, 0.4);
  add_rows(a8, 2, 4, 0.6);
  add_rows(a8, 1, 3, 0.5);
  const Pixel all = pixel_of(a8, "abuffer-unlimited"), one = pixel_of(a8, "abuffer-merge:n=1,policy=m1");
  expect_pixel(a8, 3, 1);
  EXPECT_EQ(one.live, 1u);
  EXPECT_EQ(one.coverage, 1.0f);
  EXPECT_EQ(one.statistics.fragments_most_live, 1u);
  EXPECT_GT(one.statistics.fragments_lost, 0u);
  EXPECT_EQ(all.statistics.complexity.most_live.most(), all.statistics.fragments_most_live);
}

TEST(planes, worked_cases_of_transparent_surfaces) {
  Scene a10, a12, behind, clear;
  add_whole(a10, 0.25, 0, 0.5f);
  add_whole(a10, 0.5);
  expect_pixel(a10, 2, 1);
  add_rows(a12, 0, 2, 0.1, 0.75f);
  add_rows(a12, 1, 3, 0.2);
  add_whole(a12, 0.3, 0, 0.5f);
  expect_pixel(a12, 3, 1);
  add_rows(behind, 0, 1, 0.5);
  add_rows(behind, 0, 2, 0.6, 0.5f);
  expect_pixel(behind, 2, 0.5f);
  add_whole(clear, 0.25, 0, 0.0f);
  expect_pixel(clear, 0, 0);
}

// Samples of the picture are pixel centres of one four times as large.
TEST(planes, agree_with_one_sample_of_sixteen_times_the_pixels) {
  Random random(77);
  std::size_t pixels = 0, different = 0;
  for (int round = 0; round < 6; ++round) {
    const Crowd crowd = random_crowd(random, 60, 9, 15);
    RenderOptions o = sample_options(), fine = sample_options(4);
    o.want_fragments = o.want_coverage = o.want_complexity = true;
    const Frame frame = render_frame(crowd.scene, o), samples = render_frame(crowd.scene, fine);
    std::vector<std::set<std::uint32_t>> generated(std::size_t{kCrowdWidth} * kCrowdHeight),
        live(generated.size());
    std::vector<int> covered(generated.size());
    const auto pixel = [](int x, int y) { return static_cast<std::size_t>(y / 4 * kCrowdWidth + x / 4); };
    for (std::uint32_t i = 0; i < crowd.triangles.size(); ++i) {
      reference::for_each_covered(crowd.triangles[i], 4 * kCrowdWidth, 4 * kCrowdHeight,
                                  [&](int x, int y) { generated[pixel(x, y)].insert(i); });
    }
    for (int y = 0; y < 4 * kCrowdHeight; ++y) {
      for (int x = 0; x < 4 * kCrowdWidth; ++x) {
        const std::uint32_t id = samples.id[static_cast<std::size_t>(y * 4 * kCrowdWidth + x)];
        if (id == 0) continue;
        live[pixel(x, y)].insert(id);
        ++covered[pixel(x, y)];
      }
    }
    std::uint64_t all = 0;
    std::size_t most = 0;
    for (std::size_t p = 0; p < generated.size(); ++p) {
      ASSERT_EQ(frame.coverage.values[p], static_cast<float>(covered[p]) / 16) << p;
      different += frame.fragments[p] != live[p].size() ? 1 : 0;
      all += generated[p].size();
      most = std::max(most, generated[p].size());
    }
    pixels += generated.size();
    EXPECT_EQ(frame.statistics.complexity.generated.total(), all);
    EXPECT_EQ(frame.statistics.complexity.generated.most(), most);
  }
  EXPECT_LE(different, pixels / 1000);  // depths that rounding makes equal
}

TEST(planes, statistics_are_those_of_the_pixels) {
  for (const float opacity : {1.0f, 0.5f}) {
    const Scene scene = made("triangles?count=800&size=0.5", opacity);
    for (const char* method : kMethods) {
      const Frame frame = render_frame(scene, counting(method));
      const FrameStatistics& s = frame.statistics;
      const DepthComplexity& c = s.complexity;
      EXPECT_EQ(c.live.total(), sum(frame.fragments)) << method;
      EXPECT_EQ(c.live.pixels(), frame.fragments.size()) << method;
      EXPECT_EQ(c.generated.pixels(), frame.fragments.size()) << method;
      const std::uint64_t gone = c.generated.total() - c.live.total();
      EXPECT_EQ(gone, c.hidden + s.layers_merged + s.fragments_lost) << method;
      std::uint64_t covered = 0;
      for (const float share : frame.coverage.values) covered += share > 0 ? 1 : 0;
      if (!has_lists(method)) {
        EXPECT_TRUE(c.most_live.bins.empty()) << method;
        EXPECT_EQ(covered, s.pixels_covered) << method;
        continue;
      }
      EXPECT_EQ(c.hidden, s.fragments_hidden_on_arrival + s.fragments_removed_later) << method;
      EXPECT_EQ(c.most_live.most(), s.fragments_most_live) << method;
      EXPECT_GE(c.most_live.total(), c.live.total()) << method;
      EXPECT_EQ(c.generated.total(), s.fragments_shaded) << method;
    }
  }
}

// A.11 of the specification; its scenes come of other random numbers.
TEST(planes, soups_have_the_depth_complexity_of_the_specification) {
  const struct {
    const char* shape;
    double generated, live;
  } rows[] = {{"soup?layers=5", 7.4, 1.94}, {"soup?layers=20", 29.3, 2.16}, {"grass", 9.8, 3.57}};
  for (const auto& row : rows) {
    const Scene scene = made(row.shape);
    for (const char* method : {"abuffer", "abuffer-unlimited"}) {
      RenderOptions o = counting(method);
      o.width = o.height = 128;
      o.camera = scene.cameras.at(0);
      const DepthComplexity c = render_frame(scene, o).statistics.complexity;
      EXPECT_NEAR(c.generated.mean(), row.generated, 0.03 * row.generated) << row.shape << method;
      EXPECT_NEAR(c.live.mean(), row.live, 0.05 * row.live) << row.shape << method;
    }
  }
}

TEST(planes, the_picture_does_not_depend_on_them) {
  for (const float opacity : {1.0f, 0.5f}) {
    const Scene scene = made("torus", opacity);
    for (const char* method : kMethods) {
      RenderOptions o = counting(method);
      const Frame with = render_frame(scene, o);
      o.want_complexity = false;
      const Frame planes = render_frame(scene, o);
      o.want_fragments = o.want_coverage = false;
      const Frame without = render_frame(scene, o);
      EXPECT_TRUE(same_bytes(with.image.pixels, without.image.pixels)) << method;
      EXPECT_TRUE(same_bytes(with.fragments, planes.fragments)) << method;
      EXPECT_TRUE(same_bytes(with.coverage.values, planes.coverage.values)) << method;
      EXPECT_TRUE(planes.statistics.complexity.generated.bins.empty()) << method;
      EXPECT_TRUE(without.fragments.empty()) << method;
      EXPECT_TRUE(without.coverage.values.empty()) << method;
      EXPECT_EQ(with.statistics.fragments_shaded, without.statistics.fragments_shaded) << method;
    }
  }
}

TEST(planes, threads_and_instruction_sets_do_not_show) {
  Scene scene = made("triangles?count=600&size=0.5", 0.5f);
  scene.append(made("torus"));
  for (const char* method : kMethods) {
    const Frame one = render_frame(scene, counting(method));
    const auto expect_same = [&](const Frame& frame) {
      EXPECT_TRUE(same_bytes(one.fragments, frame.fragments)) << method;
      EXPECT_TRUE(same_bytes(one.coverage.values, frame.coverage.values)) << method;
      const FrameStatistics &a = one.statistics, &b = frame.statistics;
      EXPECT_EQ(a.complexity.generated, b.complexity.generated) << method;
      EXPECT_EQ(a.complexity.live, b.complexity.live) << method;
      EXPECT_EQ(a.complexity.most_live, b.complexity.most_live) << method;
      EXPECT_EQ(a.fragments_hidden_on_arrival, b.fragments_hidden_on_arrival) << method;
      EXPECT_EQ(a.fragment_memory.pool_peak, b.fragment_memory.pool_peak) << method;
      EXPECT_EQ(a.fragment_memory.fullest_pool_peak, b.fragment_memory.fullest_pool_peak) << method;
    };
    for (const int threads : {2, 7}) expect_same(render_frame(scene, counting(method), Isa::best, threads));
    for (const Isa isa : available_isas()) expect_same(render_frame(scene, counting(method), isa));
  }
}

TEST(planes, memory_of_the_buffers_is_that_of_the_formulas) {
  const Scene scene = made("torus");
  const auto memory = [&](const char* method) {
    RenderOptions o = counting(method);
    o.width = 128;
    o.height = 64;
    return render_frame(scene, o).statistics.fragment_memory;
  };
  EXPECT_EQ(memory("abuffer").main_bytes, 0u);
  EXPECT_EQ(memory("abuffer-merge:n=3").paper_main_bits, 128u * 64 * 3 * 112);
  EXPECT_EQ(memory("abuffer-merge:n=3").paper_common_bits, 0u);
  const FragmentMemory pool = memory("abuffer-pool:main=2,extra=6,pool=1000");
  EXPECT_EQ(pool.paper_main_bits, 128u * 64 * (2 * 112 + 6 * 10));  // 10 bits address 1000 slots
  EXPECT_EQ(pool.paper_common_bits, 2u * 1000 * 112);
  EXPECT_EQ(pool.pools, 2u);
  EXPECT_EQ(pool.pool_slots, 1000u);
  EXPECT_LE(pool.fullest_pool_peak, pool.pool_slots);
  EXPECT_LE(pool.pool_peak, 2 * pool.fullest_pool_peak);
  EXPECT_GT(pool.pool_peak, 0u);
  EXPECT_EQ(memory("abuffer-carpenter").paper_main_bits, 0u);
  EXPECT_GT(memory("abuffer-carpenter").main_bytes, 0u);
}

// Slots that hold as many as the fullest pool asked for never fill.
TEST(planes, the_fullest_pool_tells_how_many_slots_are_enough) {
  const Scene scene = made("triangles?count=800&size=0.5");
  const auto shown = [&](const std::string& pool) {
    return render_frame(scene, counting("abuffer-pool:main=1,extra=2,policy=m1,pool=" + pool));
  };
  const Frame roomy = shown("65536");
  const std::uint64_t fullest = roomy.statistics.fragment_memory.fullest_pool_peak;
  EXPECT_TRUE(same_bytes(roomy.image.pixels, shown(std::to_string(fullest)).image.pixels));
  EXPECT_FALSE(same_bytes(roomy.image.pixels, shown(std::to_string(fullest / 2)).image.pixels));
}

}  // namespace
}  // namespace blysk
