// Transparent surfaces against a brute-force reference: every sample, every layer, in doubles.
#include "antialias/glass.h"

#include <gtest/gtest.h>

#include <cstring>
#include <numeric>

#include "blysk/shapes.h"
#include "render/sample_testing.h"

namespace blysk {
namespace {

constexpr float kOpacities[] = {1.0f, 0.25f, 0.5f, 0.8f};

Material glass(float opacity) {
  Material m;
  m.color = {1, 1, 1};
  m.unlit = true;
  m.opacity = opacity;
  m.alpha_mode = opacity < 1 ? AlphaMode::blend : AlphaMode::opaque;
  return m;
}

struct GlassCrowd : Crowd {
  std::vector<float> opacity;  // of triangles
};

struct Sizes {
  int count;  // of each opacity
  double least, most;
};

GlassCrowd glass_crowd(Random& random, const Sizes& sizes) {
  GlassCrowd crowd;
  for (const float opacity : kOpacities) {
    Mesh mesh;
    for (int i = 0; i < sizes.count; ++i) {
      const auto part = [&] { return static_cast<float>(uniform(random, 0, 1)); };
      const float r = part(), g = part(), b = part();
      add_triangle(crowd, mesh, random_triangle(random, sizes.least, sizes.most), {r, g, b});
      crowd.opacity.push_back(opacity);
    }
    crowd.scene.add(std::move(mesh), glass(opacity));
  }
  return crowd;
}

struct Layer {
  double nearness;
  std::size_t triangle;
};

std::vector<std::vector<Layer>> layers_of(const Crowd& crowd) {
  constexpr int kAcross = kCrowdWidth * 4, kDown = kCrowdHeight * 4;
  std::vector<std::vector<Layer>> layers(std::size_t{kAcross} * kDown);
  for (std::size_t i = 0; i < crowd.triangles.size(); ++i) {
    reference::for_each_covered(crowd.triangles[i], kAcross, kDown, [&](int x, int y) {
      layers[static_cast<std::size_t>(y * kAcross + x)].push_back(
          {reference::nearness_at(crowd.triangles[i], x, y), i});
    });
  }
  for (auto& l : layers) {
    std::stable_sort(l.begin(), l.end(),
                     [](const Layer& a, const Layer& b) { return a.nearness > b.nearness; });
  }
  return layers;
}

struct ThroughGlass {
  Vec3d color;
  bool doubtful = false;
};

void add_sample(const GlassCrowd& crowd, const std::vector<Layer>& layers, Vec3d background,
                ThroughGlass& e) {
  double through = 1;
  Vec3d color;
  for (std::size_t k = 0; k < layers.size() && through > 0; ++k) {
    const std::size_t i = layers[k].triangle;
    const double opacity = double{crowd.opacity[i]};
    color = color + to_double(crowd.colors[i]) * (through * opacity);
    through *= 1 - opacity;
    if (k + 1 == layers.size()) break;
    const double unsure =
        depth_error(crowd.triangles[i]) + depth_error(crowd.triangles[layers[k + 1].triangle]);
    e.doubtful = e.doubtful || layers[k].nearness - layers[k + 1].nearness <= unsure;
  }
  e.color = e.color + (color + background * through) * (1.0 / 16);
}

TEST(glass, agrees_with_brute_force_at_every_sample) {
  Random random(51);
  long pixels = 0, clear = 0;
  const Sizes all[] = {{4000, 8, 11}, {300, 11, 14}, {40, 14, 17}, {12, 15, 19}};
  for (const Sizes& sizes : all) {
    const GlassCrowd crowd = glass_crowd(random, sizes);
    const auto layers = layers_of(crowd);
    const RenderOptions o = sample_options();
    const Vec3d background = {double{o.background.x}, double{o.background.y}, double{o.background.z}};
    for (const Isa isa : available_isas()) {
      const Frame frame = render_frame(crowd.scene, o, isa, 2);
      EXPECT_EQ(frame.statistics.layers_merged, 0u);
      for (int y = 0; y < kCrowdHeight; ++y) {
        for (int x = 0; x < kCrowdWidth; ++x) {
          ThroughGlass e;
          for (int s = 0; s < 16; ++s) {
            add_sample(crowd,
                       layers[static_cast<std::size_t>((4 * y + s / 4) * kCrowdWidth * 4 + 4 * x + s % 4)],
                       background, e);
          }
          ++pixels;
          if (e.doubtful) continue;
          ++clear;
          const std::uint32_t pixel = frame.image.pixels[static_cast<std::size_t>(y * kCrowdWidth + x)];
          ASSERT_NEAR(channel(pixel, 0), e.color.x, 0.6 / 255) << isa_name(isa) << " " << x << "," << y;
          ASSERT_NEAR(channel(pixel, 1), e.color.y, 0.6 / 255) << isa_name(isa) << " " << x << "," << y;
          ASSERT_NEAR(channel(pixel, 2), e.color.z, 0.6 / 255) << isa_name(isa) << " " << x << "," << y;
        }
      }
    }
  }
  EXPECT_GT(static_cast<double>(clear), 0.7 * static_cast<double>(pixels));
}

void expect_same_picture(const Frame& a, const Frame& b) {
  EXPECT_EQ(std::memcmp(a.image.pixels.data(), b.image.pixels.data(),
                        a.image.pixels.size() * sizeof(std::uint32_t)),
            0);
}

TEST(glass, order_of_triangles_does_not_show) {
  Random random(52);
  for (const char* text : {"trefoil?detail=300", "xfighter", "triangles?count=900&size=0.4"}) {
    Scene scene = std::move(*make_shape(text));
    for (Material& m : scene.materials) {
      m.opacity = 0.35f;
      m.alpha_mode = AlphaMode::blend;
    }
    Scene other = scene;
    for (Mesh& mesh : other.meshes) {
      for (std::size_t i = mesh.triangles(); i > 1; --i) {
        const std::size_t k = random.next() % i;
        for (std::size_t c = 0; c < 3; ++c) std::swap(mesh.indices[3 * (i - 1) + c], mesh.indices[3 * k + c]);
      }
    }
    RenderOptions o;
    o.width = 230;
    o.height = 170;
    o.antialias = "abuffer";
    const Frame expected = render_frame(scene, o);
    for (const Isa isa : available_isas()) {
      for (const int threads : {1, 2, 7}) {
        SCOPED_TRACE(std::string(text) + ", " + std::string(isa_name(isa)));
        expect_same_picture(render_frame(scene, o, isa, threads), expected);
        expect_same_picture(render_frame(other, o, isa, threads), expected);
      }
    }
  }
}

// Leaves of one plane over a background, of which each lets a part through.
GlassCrowd leaves(int count, float opacity) {
  GlassCrowd crowd;
  Mesh mesh;
  const auto at = [](double x, double y) {
    return reference::Place{std::llrint(x * 1024), std::llrint(y * 1024), 0.5f};
  };
  for (int i = 0; i < count; ++i) {
    add_triangle(crowd, mesh, {{at(10.5, -500), at(10.5, 500), at(900, 0)}}, {0.5f, 0.75f, 0.25f});
  }
  crowd.scene.add(std::move(mesh), glass(opacity));
  return crowd;
}

TEST(glass, coincident_leaves_are_exact_up_to_the_bound_and_told_beyond_it) {
  RenderOptions o = sample_options();
  for (const int count : {1, 7, kMostLayers, kMostLayers + 1, 100, 1000}) {
    SCOPED_TRACE(count);
    const GlassCrowd crowd = leaves(count, 0.02f);
    Frame first;
    for (const int threads : {1, 2, 7}) {
      const Frame frame = render_frame(crowd.scene, o, Isa::best, threads);
      const FrameStatistics& s = frame.statistics;
      EXPECT_EQ(s.layers_merged > 0, count > kMostLayers);
      EXPECT_EQ(s.layers_merged,
                s.pixels_merged * static_cast<std::uint64_t>(std::max(0, count - kMostLayers)));
      EXPECT_EQ(s.layers_generated, s.pixels_shared * static_cast<std::uint64_t>(count));
      // Leaves of one plane and colour merge without loss.
      const double through = std::pow(1 - double{0.02f}, count);
      const std::uint32_t pixel = frame.image.pixels[30 * kCrowdWidth + 30];
      EXPECT_NEAR(channel(pixel, 0), 0.5 + (0.25 - 0.5) * through, 0.7 / 255);
      EXPECT_NEAR(channel(pixel, 1), 0.75 + (0.5 - 0.75) * through, 0.7 / 255);
      const std::uint32_t edge = frame.image.pixels[30 * kCrowdWidth + 10];
      EXPECT_NEAR(channel(edge, 1), 0.5 + 0.5 * (0.75 - 0.5) * (1 - through), 0.7 / 255);
      if (threads == 1) first = frame;
      expect_same_picture(frame, first);
    }
  }
}

TEST(glass, alpha_is_what_is_not_seen_through) {
  RenderOptions o = sample_options();
  o.background = {0, 0, 0, 0};
  const Frame frame = render_frame(leaves(2, 0.5f).scene, o);
  const std::uint32_t* row = frame.image.pixels.data() + 30 * kCrowdWidth;
  EXPECT_EQ(row[9], 0u);
  EXPECT_EQ(row[10] >> 24, 96u);  // half of 3/4
  EXPECT_EQ(row[11] >> 24, 191u);
  EXPECT_EQ(row[10] & 0xffffff, row[11] & 0xffffff);
  EXPECT_NEAR(channel(row[11], 0), 0.5, 0.6 / 255);
}

TEST(glass, masks_are_all_or_nothing) {
  RenderOptions o = sample_options();
  GlassCrowd crowd = leaves(1, 0.5f);
  Material& m = crowd.scene.materials[0];
  m.alpha_mode = AlphaMode::mask;
  m.alpha_cutoff = 0.4f;
  EXPECT_EQ(render_frame(crowd.scene, o).image.pixels[30 * kCrowdWidth + 30], 0xff40bf80u);
  m.alpha_cutoff = 0.6f;
  const Frame clear = render_frame(crowd.scene, o);
  EXPECT_EQ(clear.statistics.pixels_covered, 0u);
  m.alpha_mode = AlphaMode::opaque;  // then opacity means nothing
  EXPECT_EQ(render_frame(crowd.scene, o).image.pixels[30 * kCrowdWidth + 30], 0xff40bf80u);
}

}  // namespace
}  // namespace blysk
