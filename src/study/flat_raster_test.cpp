// The A-buffer against brute force: every sample, every layer, exact integers and doubles.
#include "study/flat_raster.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "antialias/carpenter.h"
#include "antialias/fragment_lists.h"
#include "core/random.h"

namespace {

using namespace blysk::study;
using namespace blysk::antialias;
using blysk::Random;
using blysk::ThreadPool;
using blysk::Vec3d;

constexpr int kSide = 8;
constexpr std::size_t kPixels = kSide * kSide;
const Vec3d kBackground = {32, 32, 64};

struct Scene {
  std::vector<FlatTriangle> triangles;
};

double whole(Random& random, int limit) {
  return static_cast<double>(random.next() % static_cast<unsigned>(limit));
}

// Planes whose depths are multiples of 2^-16 wherever they are asked for: every way to compute them is exact,
// and ties are frequent. z = z0 + zx * x + zy * y in pixels.
FlatTriangle random_triangle(Random& random, bool glass) {
  FlatTriangle t;
  const double z0 = (64 + whole(random, 128)) / 256, zx = (whole(random, 17) - 8) / 256,
               zy = (whole(random, 17) - 8) / 256;
  const bool coarse = random.next() % 2 == 0;  // corners on samples, for samples on edges
  for (Vec3d& c : t.corners) {
    c.x = coarse ? (whole(random, 48) - 8) / 4 + 0.125 : (whole(random, 3072) - 512) / 256;
    c.y = coarse ? (whole(random, 48) - 8) / 4 + 0.125 : (whole(random, 3072) - 512) / 256;
    c.z = z0 + zx * c.x + zy * c.y;
  }
  t.rgb = {static_cast<float>(random.next() % 256), static_cast<float>(random.next() % 256),
           static_cast<float>(random.next() % 256)};
  t.alpha = glass ? static_cast<float>(random.next() % 17) / 16 : 1;
  return t;
}

// Whether a triangle owns a point of the screen; the point is where a step right, or down, leads.
bool owns(const FlatTriangle& t, double x, double y) {
  const auto cross = [](const Vec3d& a, const Vec3d& b, double px, double py) {
    return (b.x - a.x) * (py - a.y) - (b.y - a.y) * (px - a.x);
  };
  const double area = cross(t.corners[0], t.corners[1], t.corners[2].x, t.corners[2].y);
  if (area == 0) return false;
  for (std::size_t k = 0; k < 3; ++k) {
    Vec3d a = t.corners[k], b = t.corners[(k + 1) % 3];
    if (area < 0) std::swap(a, b);
    const double side = cross(a, b, x, y);
    if (side < 0) return false;
    if (side == 0 && (b.y > a.y || (b.y == a.y && b.x < a.x))) return false;
  }
  return true;
}

double depth_at_point(const FlatTriangle& t, double x, double y) {
  const Vec3d u = t.corners[1] - t.corners[0], v = t.corners[2] - t.corners[0];
  const double area = u.x * v.y - u.y * v.x;
  const double dx = x - t.corners[0].x, dy = y - t.corners[0].y;
  return t.corners[0].z + ((dx * v.y - dy * v.x) * u.z + (u.x * dy - u.y * dx) * v.z) / area;
}

struct Truth {
  Vec3d rgb;
  std::vector<int> visible;  // of each sample the opaque triangle that is seen, -1: none
};

Truth brute_force(const std::vector<FlatTriangle>& triangles, const SamplePattern& pattern, int column,
                  int row) {
  Truth truth;
  for (std::size_t s = 0; s < pattern.count; ++s) {
    const double x = column + 0.5 + pattern.x[s] / 256.0, y = row + 0.5 + pattern.y[s] / 256.0;
    std::vector<std::pair<double, int>> layers;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      if (triangles[i].alpha > 0 && owns(triangles[i], x, y)) {
        layers.emplace_back(std::round(depth_at_point(triangles[i], x, y) * 0x1p24) * 0x1p-24,
                            static_cast<int>(i));
      }
    }
    std::sort(layers.begin(), layers.end());
    double through = 1;
    truth.visible.push_back(-1);
    for (const auto& [z, i] : layers) {
      const FlatTriangle& t = triangles[static_cast<std::size_t>(i)];
      truth.rgb = truth.rgb + blysk::to_double(t.rgb) * (through * double{t.alpha});
      through *= 1 - double{t.alpha};
      if (t.alpha < 1) continue;
      truth.visible.back() = i;
      break;
    }
    truth.rgb = truth.rgb + kBackground * through;
  }
  truth.rgb = truth.rgb * (1.0 / static_cast<double>(pattern.count));
  return truth;
}

std::vector<FlatTriangle> random_scene(Random& random, int number) {
  std::vector<FlatTriangle> triangles;
  const std::size_t layers = 1 + random.next() % 60;
  for (std::size_t i = 0; i < layers; ++i)
    triangles.push_back(random_triangle(random, number % 2 == 1 && i % 3 != 0));
  return triangles;
}

TEST(abuffer, unlimited_is_brute_force_on_a_thousand_scenes) {
  Random random(11);
  const SamplePattern* const patterns[] = {&kGrid16, &kGrid32, &kRooks16};
  for (int number = 0; number < 1000; ++number) {
    const SamplePattern& pattern = *patterns[number % 3];
    const std::vector<FlatTriangle> triangles = random_scene(random, number);
    FragmentStream stream;
    std::vector<std::uint32_t> order(triangles.size());
    std::iota(order.begin(), order.end(), 0u);
    rasterise(triangles, order, {0, 0, kSide, kSide}, pattern, stream);
    FragmentLists lists({.pattern = &pattern});
    lists.clear(kPixels);
    stream.insert_into(lists);
    // A few pixels of each: brute force is slow.
    for (std::size_t p = static_cast<std::size_t>(number) % 7; p < kPixels; p += 7) {
      const Truth truth =
          brute_force(triangles, pattern, static_cast<int>(p) % kSide, static_cast<int>(p) / kSide);
      for (const Fragment& f : lists.fragments(p)) {
        for (std::size_t s = 0; s < pattern.count && f.opaque(); ++s) {
          if ((f.mask >> s & 1) != 0) {
            ASSERT_EQ(truth.visible[s], static_cast<int>(f.id)) << number << " " << p;
          }
        }
      }
      Mask seen = 0, opaque = 0;
      for (std::size_t s = 0; s < pattern.count; ++s) seen |= static_cast<Mask>(truth.visible[s] >= 0) << s;
      for (const Fragment& f : lists.fragments(p)) opaque |= f.opaque() ? f.mask : 0;
      ASSERT_EQ(opaque, seen) << number << " " << p;
      const Vec3d rgb = lists.resolve(p, kBackground);
      ASSERT_NEAR(rgb.x, truth.rgb.x, 1e-6);
      ASSERT_NEAR(rgb.y, truth.rgb.y, 1e-6);
      ASSERT_NEAR(rgb.z, truth.rgb.z, 1e-6);
    }
  }
}

TEST(abuffer, opaque_masks_are_disjoint_and_keep_all_that_was_covered) {
  Random random(12);
  for (int number = 0; number < 100; ++number) {
    std::vector<FlatTriangle> triangles = random_scene(random, 0);
    FragmentStream stream;
    rasterise(triangles, submission_order(triangles, Order::given, 0), {0, 0, kSide, kSide}, kGrid16, stream);
    FragmentLists lists({});
    lists.clear(kPixels);
    std::vector<Mask> generated(kPixels);
    for (std::size_t i = 0; i < stream.pixels.size(); ++i) {
      generated[stream.pixels[i]] |= stream.fragments[i].mask;
      lists.insert(stream.pixels[i], stream.fragments[i]);
    }
    for (std::size_t p = 0; p < kPixels; ++p) {
      Mask all = 0;
      float last = -1e30f;
      for (const Fragment& f : lists.fragments(p)) {
        EXPECT_EQ(all & f.mask, 0u);
        EXPECT_NE(f.mask, 0u);
        EXPECT_GE(f.z, last);
        last = f.z;
        all |= f.mask;
      }
      EXPECT_EQ(all, generated[p]);
    }
    const ListStatistics& s = lists.statistics();
    EXPECT_EQ(s.generated, stream.pixels.size());
    EXPECT_EQ(s.generated, s.live + s.hidden_on_arrival + s.removed_later);
    EXPECT_LE(s.most_live, 16u);
  }
}

TEST(abuffer, the_lower_id_makes_any_order_show_the_same) {
  Random random(13);
  for (int number = 0; number < 100; ++number) {
    const std::vector<FlatTriangle> triangles = random_scene(random, number);
    FragmentStream stream;
    rasterise(triangles, submission_order(triangles, Order::given, 0), {0, 0, kSide, kSide}, kGrid16, stream);
    FragmentLists one({.tie = Tie::lower_id}), other({.tie = Tie::lower_id});
    one.clear(kPixels);
    other.clear(kPixels);
    stream.insert_into(one);
    for (std::size_t i = stream.pixels.size(); i-- > 0;) other.insert(stream.pixels[i], stream.fragments[i]);
    for (std::size_t p = 0; p < kPixels; ++p) {
      const Vec3d a = one.resolve(p, kBackground), b = other.resolve(p, kBackground);
      ASSERT_NEAR(a.x, b.x, 1e-9) << number << " " << p;
      ASSERT_EQ(one.live(p), other.live(p));
    }
  }
}

std::vector<FlatTriangle> crowd(std::size_t count, int side) {
  Random random(14);
  std::vector<FlatTriangle> triangles(count);
  for (FlatTriangle& t : triangles) {
    const double x = side * double{random.unit()}, y = side * double{random.unit()},
                 z = double{random.unit()};
    for (Vec3d& c : t.corners) {
      c.x = x + 12 * double{random.signed_unit()};
      c.y = y + 12 * double{random.signed_unit()};
      c.z = z + 0.1 * double{random.signed_unit()};
    }
    t.rgb = {255 * random.unit(), 0, 255 * random.unit()};
    t.alpha = random.next() % 4 == 0 ? 0.5f : 1;
  }
  return triangles;
}

TEST(abuffer, bytes_do_not_depend_on_threads) {
  const std::vector<FlatTriangle> triangles = crowd(2000, 100);
  const Variant variants[] = {{},
                              {.overflow = Overflow::m5, .most = 3},
                              {.overflow = Overflow::d4, .most = 2},
                              {.kind = Variant::Kind::carpenter},
                              {.kind = Variant::Kind::pool, .overflow = Overflow::m1, .pool = 2500}};
  ThreadPool one(1), two(2), seven(7);
  for (const Variant& variant : variants) {
    const DrawOptions options = {
        .width = 100, .height = 90, .tile = 16, .variant = variant, .order = Order::random};
    const Drawing a = draw(triangles, options, one), b = draw(triangles, options, two),
                  c = draw(triangles, options, seven);
    EXPECT_TRUE(a.pixels == b.pixels);
    EXPECT_TRUE(a.pixels == c.pixels);
    EXPECT_EQ(a.statistics.overflowed, c.statistics.overflowed);
    EXPECT_EQ(a.statistics.pool_peak, c.statistics.pool_peak);
  }
}

TEST(abuffer, tiles_do_not_show_but_in_a_full_pool) {
  const std::vector<FlatTriangle> triangles = crowd(500, 64);
  ThreadPool threads(1);
  for (const Variant& variant : {Variant{}, Variant{.overflow = Overflow::m5, .most = 2}}) {
    const Drawing whole_picture =
        draw(triangles, {.width = 64, .height = 64, .tile = 64, .variant = variant}, threads);
    const Drawing tiles =
        draw(triangles, {.width = 64, .height = 64, .tile = 13, .variant = variant}, threads);
    EXPECT_TRUE(whole_picture.pixels == tiles.pixels);
    EXPECT_TRUE(whole_picture.live == tiles.live);
  }
}

TEST(submission_order, is_what_its_name_says) {
  const std::vector<FlatTriangle> triangles = crowd(200, 50);
  const auto depth = [&](std::uint32_t i) {
    const auto& c = triangles[i].corners;
    return c[0].z + c[1].z + c[2].z;
  };
  const auto near_first = submission_order(triangles, Order::front_to_back, 0);
  const auto far_first = submission_order(triangles, Order::back_to_front, 0);
  for (std::size_t i = 1; i < 200; ++i) {
    EXPECT_LE(depth(near_first[i - 1]), depth(near_first[i]));
    EXPECT_GE(depth(far_first[i - 1]), depth(far_first[i]));
  }
  auto shuffled = submission_order(triangles, Order::random, 1);
  EXPECT_NE(shuffled, submission_order(triangles, Order::random, 2));
  EXPECT_EQ(shuffled, submission_order(triangles, Order::random, 1));
  std::sort(shuffled.begin(), shuffled.end());
  EXPECT_EQ(shuffled, submission_order(triangles, Order::given, 0));
}

}  // namespace
