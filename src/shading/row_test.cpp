// Rows of a triangle against the pixels that exact arithmetic gives it. The kernels' header is compiled here
// for the plain processor.
#define BLYSK_ISA isa_test
#include "shading/row.h"

#include <gtest/gtest.h>

#include "raster/coverage_reference.h"
#include "render/testing.h"

namespace blysk {
namespace {

using isa_test::F32;
using isa_test::I32;
using isa_test::kLanes;

struct Outline {
  std::int32_t x[3], y[3];

  [[nodiscard]] reference::Triangle triangle() const {
    return {{{{x[0], y[0], 0}, {x[1], y[1], 0}, {x[2], y[2], 0}}}};
  }
};

isa_test::RowFrame<float> frame_of(const Outline& o) {
  isa_test::Corners<float> c{};
  for (int k = 0; k < 3; ++k) {
    c.x[k] = static_cast<float>(o.x[k]);
    c.y[k] = static_cast<float>(o.y[k]);
  }
  isa_test::sort_corners(c);
  return isa_test::row_frame(c);
}

// The columns of a row that the triangle covers, by trying them; last < first: none. Only near a first guess,
// as rows of large triangles are long.
struct Ends {
  int first, last;
};

Ends exact_ends(const Outline& o, int row) {
  const reference::Triangle t = o.triangle();
  const std::int64_t y = row * std::int64_t{256} + 128;
  double low = 1e30, high = -1e30;
  for (int k = 0; k < 3; ++k) {
    const int a = k, b = (k + 1) % 3;
    if (o.y[a] == o.y[b] || (y < o.y[a] && y < o.y[b]) || (y > o.y[a] && y > o.y[b])) continue;
    const double x = o.x[a] + double(o.x[b] - o.x[a]) * double(y - o.y[a]) / double(o.y[b] - o.y[a]);
    low = std::min(low, x);
    high = std::max(high, x);
  }
  if (low > high) return {0, -1};
  int first = static_cast<int>(std::floor(low / 256)) - 2,
      last = static_cast<int>(std::floor(high / 256)) + 2;
  while (first <= last && !reference::covers(t, first, row)) ++first;
  while (first <= last && !reference::covers(t, last, row)) --last;
  return {first, last};
}

Outline random_outline(Random& random) {
  Outline o{};
  const std::int64_t reach = std::int64_t{1} << whole(random, 6, 22);
  const std::int64_t grid = std::int64_t{1} << whole(random, 0, 8);  // through centres and corners of pixels
  for (int k = 0; k < 3; ++k) {
    const auto on_grid = [&](std::int64_t v) {
      return static_cast<std::int32_t>(
          std::clamp<std::int64_t>(v / grid * grid + (grid == 256 ? 128 : 0), -kGuardBand, kGuardBand));
    };
    o.x[k] = on_grid(whole(random, -reach, reach));
    o.y[k] = on_grid(whole(random, -reach, reach));
  }
  if (whole(random, 0, 3) == 0) {  // a sliver
    const double t = uniform(random, 0, 1);
    o.x[2] = static_cast<std::int32_t>(o.x[0] + t * (o.x[1] - o.x[0])) +
             static_cast<std::int32_t>(whole(random, -2, 2));
    o.y[2] = static_cast<std::int32_t>(o.y[0] + t * (o.y[1] - o.y[0])) +
             static_cast<std::int32_t>(whole(random, -2, 2));
  }
  return o;
}

TEST(row, ends_are_exact) {
  Random random(5);
  std::int64_t rows = 0, levels = 0, slivers = 0;
  for (int i = 0; i < 60000; ++i) {
    const Outline o = random_outline(random);
    const isa_test::RowFrame<float> frame = frame_of(o);
    const std::int64_t area = o.triangle().area();
    if (area == 0) continue;
    const auto [top, bottom] = std::minmax({o.y[0], o.y[1], o.y[2]});
    for (int trial = 0; trial < 8; ++trial) {
      const int row = static_cast<int>(whole(random, top, bottom) >> 8);
      const Ends expected = exact_ends(o, row);
      if (expected.last < expected.first) continue;
      ++rows;
      levels += frame.y[0] == frame.y[2] || frame.y[1] == frame.y[2] ? 1 : 0;
      const bool sliver = std::abs(area) < 128 * std::int64_t{bottom - top} && bottom - top > 4096;
      slivers += sliver ? 1 : 0;
      const auto ends = isa_test::row_ends(frame, static_cast<float>(row * 256 + 128));
      ASSERT_EQ(ends.first, expected.first) << i << ", row " << row;
      ASSERT_EQ(ends.last, expected.last) << i << ", row " << row;
    }
  }
  EXPECT_GT(rows, 100000);
  EXPECT_GT(levels, 500);
  EXPECT_GT(slivers, 100);
}

TEST(row, lanes_are_floats) {
  Random random(6);
  for (int i = 0; i < 500; ++i) {
    float x[3][kLanes], y[3][kLanes], row[kLanes];
    isa_test::RowFrame<float> alone[kLanes];
    for (int lane = 0; lane < kLanes; ++lane) {
      Outline o = random_outline(random);
      while (o.triangle().area() == 0) o = random_outline(random);
      for (int k = 0; k < 3; ++k) {
        x[k][lane] = static_cast<float>(o.x[k]);
        y[k][lane] = static_cast<float>(o.y[k]);
      }
      alone[lane] = frame_of(o);
      const auto [top, bottom] = std::minmax({o.y[0], o.y[1], o.y[2]});
      row[lane] = static_cast<float>((whole(random, top, bottom) >> 8) * 256 + 128);
    }
    isa_test::Corners<F32> c{};
    for (int k = 0; k < 3; ++k) {
      c.x[k] = isa_test::load(x[k]);
      c.y[k] = isa_test::load(y[k]);
      c.w[k] = c.q[k] = c.nearness[k] = F32(1.0f);
      c.vertex[k] = I32(k);
    }
    c.unplaced = F32(0.0f) > F32(1.0f);
    isa_test::sort_corners(c);
    const auto frame = isa_test::row_frame(c);
    const auto ends = isa_test::row_ends(frame, isa_test::load(row));
    std::int32_t first[kLanes], last[kLanes];
    float over[kLanes], bend[kLanes];
    isa_test::store(ends.first, first);
    isa_test::store(ends.last, last);
    isa_test::store(frame.over, over);
    isa_test::store(frame.bend, bend);
    for (int lane = 0; lane < kLanes; ++lane) {
      const float low = alone[lane].y[0], high = alone[lane].y[1];
      EXPECT_EQ(over[lane], alone[lane].over);
      EXPECT_EQ(bend[lane], alone[lane].bend);
      if (row[lane] < low || row[lane] > high) continue;
      const auto one = isa_test::row_ends(alone[lane], row[lane]);
      EXPECT_EQ(first[lane], one.first);
      EXPECT_EQ(last[lane], one.last);
    }
  }
}

// s and v of points well inside the triangle, whatever its shape.
TEST(row, coordinates_are_those_of_the_corners) {
  Random random(7);
  double worst = 0;
  for (int i = 0; i < 20000; ++i) {
    const Outline o = random_outline(random);
    if (o.triangle().area() == 0) continue;
    const isa_test::RowFrame<float> f = frame_of(o);
    constexpr float kLongest = 1 << 16;  // 256 pixels: the area of larger slivers is rounded
    if (f.y[1] - f.y[0] > kLongest || std::abs(f.x[1] - f.x[0]) > kLongest) continue;
    for (int k = 0; k < 3; ++k) {
      const auto start = isa_test::row_start(f, f.y[k]);
      const double v = double(isa_test::right_of(f, start, f.x[k]) * f.over);
      // The corner is met up to a rounding of the edge's length in x.
      const double room = 4e-7 * double(std::abs(f.x[1] - f.x[0])) * double(std::abs(f.over)) + 4e-7;
      EXPECT_NEAR(v, k == 2 ? 1 : 0, room);
      EXPECT_NEAR(double(start.s), k == 0 ? 0 : k == 1 ? 1 : double(f.bend), 3e-7);
      worst = std::max(worst, room);
    }
  }
  EXPECT_GT(worst, 0);
}

}  // namespace
}  // namespace blysk
