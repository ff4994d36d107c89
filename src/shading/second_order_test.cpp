// The formulas of a row of a second-order surface: the reference forms against the specification's numbers,
// the kernels' header, compiled here for the plain processor, against exact arithmetic.
#define BLYSK_ISA isa_test
#include "shading/second_order.h"

#include <gtest/gtest.h>

#include "render/testing.h"
#include "shading/quadratic_reference.h"

namespace blysk {
namespace {

using isa_test::F32;
using isa_test::I32;
using isa_test::kLanes;
using isa_test::RowForm;
using reference::QuadraticForm;
using reference::SecondOrderSurface;

constexpr RowForm kForms[] = {RowForm::horner, RowForm::direct, RowForm::step,        RowForm::pair,
                              RowForm::triple, RowForm::values, RowForm::values_shift};

// Specification of the shading thesis, R3 and R4. A row of R4 holds I(x), the first difference, I(x+1),
// I(x+2), I(x+3), 2A, I(x+4), I(x+8) and the k = 2 segment's value at x+2.
struct SpecifiedRow {
  Vec2<double> p2, p3;
  reference::SixSamples samples;
  double x, y, value, difference, at1, at2, at3, twice_a, at4, at8, straight2;
};

constexpr SpecifiedRow kRows[] = {{{-7, 8},
                                   {9, 12},
                                   {0.2, 0.9, 0.5, 0.7, 0.45, 0.8},
                                   -4,
                                   6,
                                   0.811571335,
                                   -0.0257725181,
                                   0.785798817,
                                   0.755555556,
                                   0.720841552,
                                   -0.00447074293,
                                   0.681656805,
                                   0.480210388,
                                   0.74661407},
                                  {{-7, 8},
                                   {9, 12},
                                   {0.2, 0.9, 0.5, 0.7, 0.45, 0.8},
                                   0,
                                   9,
                                   0.804881657,
                                   -0.0323142669,
                                   0.77256739,
                                   0.73578238,
                                   0.694526627,
                                   -0.00447074293,
                                   0.648800131,
                                   0.421186719,
                                   0.726840894},
                                  {{16, 0},
                                   {0, 16},
                                   {0.1, 0.2, 0.3, 0.6, 0.5, 0.4},
                                   3,
                                   5,
                                   0.57265625,
                                   0.02265625,
                                   0.5953125,
                                   0.60390625,
                                   0.5984375,
                                   -0.0140625,
                                   0.57890625,
                                   0.36015625,
                                   0.57578125},
                                  {{20, 3},
                                   {5, 17},
                                   {1, 0.2, 0.1, 0.9, 0.4, 0.3},
                                   8,
                                   7,
                                   0.549466509,
                                   -0.0114300592,
                                   0.53803645,
                                   0.520142012,
                                   0.495783195,
                                   -0.0064643787,
                                   0.46496,
                                   0.277023432,
                                   0.507213254},
                                  {{40, -6},
                                   {-12, 25},
                                   {0.33, 0.05, 0.62, 0.41, 0.77, 0.12},
                                   0,
                                   4,
                                   0.551010702,
                                   0.00484904504,
                                   0.555859747,
                                   0.558315621,
                                   0.558378326,
                                   -0.00239317033,
                                   0.55604786,
                                   0.522794293,
                                   0.553529281}};

TEST(second_order_reference, is_the_specification) {
  for (const SpecifiedRow& r : kRows) {
    const SecondOrderSurface s = reference::second_order_surface(r.p2, r.p3, r.samples);
    EXPECT_NEAR(s.at(r.x, r.y), r.value, 5e-10);
    EXPECT_NEAR(s.directly_at(r.x, r.y), r.value, 5e-10);
    EXPECT_NEAR(s.difference(r.x, r.y), r.difference, 5e-11);
    EXPECT_NEAR(2 * s.a, r.twice_a, 5e-12);
    EXPECT_NEAR(r.value + s.segment_difference(r.x, r.y, 2), r.at4, 1e-9);
    EXPECT_NEAR(r.value + s.segment_difference(r.x, r.y, 3), r.at8, 1e-9);
    for (int form = 0; form <= static_cast<int>(QuadraticForm::forward); ++form) {
      double row[9];
      reference::quadratic_row<double>(static_cast<QuadraticForm>(form), s, r.x, r.y, row);
      const double expected[] = {r.value, r.at1, r.at2, r.at3, r.at4, 0, 0, 0, r.at8};
      for (const std::size_t i : {0, 1, 2, 3, 4, 8}) EXPECT_NEAR(row[i], expected[i], 1e-9) << i;
    }
    const std::vector<double> straight = reference::segmented_row(s, r.x, r.y, 9, 2);
    EXPECT_NEAR(straight[2], r.straight2, 5e-10);
    EXPECT_NEAR(straight[4], r.at4, 1e-9);
    EXPECT_NEAR(straight[8], r.at8, 1e-9);
  }
}

// Section 4.4: a segment is off by A q (q - 2^k).
TEST(second_order_reference, segments_are_off_by_the_specifications_error) {
  const SecondOrderSurface s{-4.0 / (64 * 64), 0, 0, 4.0 / 64, 0, 0};
  const double lsb[] = {0.25, 1, 4};
  for (int k = 1; k <= 3; ++k) {
    const std::vector<double> row = reference::segmented_row(s, 0, 0, 65, k);
    double most = 0;
    for (std::size_t i = 0; i < row.size(); ++i) {
      most = std::max(most, std::abs(row[i] - s.at(static_cast<double>(i), 0)));
    }
    EXPECT_NEAR(most, lsb[k - 1] / 256, 1e-12) << k;
  }
}

// In slender triangles a row's beginning is rounded to 0.006 subpixels; 1/40 of an 8-bit step.
constexpr double kClose = 1e-4;

// A triangle on the grid of 1/256 pixel, six values, and one of its rows.
struct Case {
  isa_test::RowFrame<float> frame;
  isa_test::SecondOrder<float> surface;
  isa_test::RowStart<float> start;
  isa_test::RowEnds<float> ends;
  isa_test::RowParabola<float> row;
  SecondOrderSurface exact;
  double from_x, y;  // exact's coordinates of column 0, pixels

  [[nodiscard]] double value(double column) const { return exact.at(column + 0.5 + from_x, y); }
  [[nodiscard]] double straight(int column, int bits) const {
    const int within = (column - ends.first) & ((1 << bits) - 1), begin = column - within;
    if (begin + (1 << bits) > ends.last) return value(column);
    return value(begin) + (value(begin + (1 << bits)) - value(begin)) * within / (1 << bits);
  }
};

// False if no pixel of the row is covered.
bool random_case(Random& random, int reach, Case& c) {
  isa_test::Corners<float> corners{};
  for (int k = 0; k < 3; ++k) {
    corners.x[k] = static_cast<float>(whole(random, 256, std::int64_t{256} * reach));
    corners.y[k] = static_cast<float>(whole(random, 256, std::int64_t{256} * reach));
  }
  isa_test::sort_corners(corners);
  c.frame = isa_test::row_frame(corners);
  if (std::abs(c.frame.area) < 12 * 65536.0f) return false;
  float values[6];
  for (float& v : values) v = random.unit();
  c.surface = isa_test::second_order(values, c.frame.bend);
  // Samples of second_order_surface() lie between corners 1-2, 1-3, 2-3.
  const auto pixels = [&](int k) {
    return Vec2<double>{(double{corners.x[k]} - double{corners.x[0]}) / 256,
                        (double{corners.y[k]} - double{corners.y[0]}) / 256};
  };
  c.exact = reference::second_order_surface(
      pixels(1), pixels(2), {values[0], values[1], values[2], values[3], values[4], values[5]});
  const auto row = whole(random, static_cast<std::int64_t>(corners.y[0]) / 256,
                         static_cast<std::int64_t>(corners.y[1]) / 256);
  const auto y = static_cast<float>(256 * row + 128);
  if (y < corners.y[0] || y >= corners.y[1]) return false;
  c.ends = isa_test::row_ends(c.frame, y);
  c.start = isa_test::row_start(c.frame, y);
  c.row = isa_test::along_row(c.surface, c.start.s);
  c.from_x = -double{corners.x[0]} / 256;
  c.y = (double{y} - double{corners.y[0]}) / 256;
  return c.ends.last >= c.ends.first;
}

// Values of sixteen pixels of the row, from `column` on.
void read(const Case& c, RowForm form, int bits, int column, float out[kLanes]) {
  const isa_test::FormedRow<float> row{c.frame, c.start, c.ends.first, c.ends.last};
  const F32 x = isa_test::to_float(isa_test::iota(column) * I32(256) + I32(128));
  isa_test::store(
      bits == 0 ? row.value(form, c.surface, c.row, x) : row.segment_value(form, bits, c.surface, c.row, x),
      out);
}

TEST(second_order, forms_are_the_parabola_over_a_million_pixels_each) {
  for (const RowForm form : kForms) {
    Random random(5);
    long pixels = 0;
    double worst = 0;
    while (pixels < 1000000) {
      Case c;
      if (!random_case(random, whole(random, 0, 3) == 0 ? 3000 : 300, c)) continue;
      for (int column = c.ends.first & -kLanes; column <= c.ends.last; column += kLanes) {
        float found[kLanes];
        read(c, form, 0, column, found);
        for (int i = std::max(0, c.ends.first - column); i < std::min(kLanes, c.ends.last + 1 - column);
             ++i) {
          worst = std::max(worst, std::abs(double{found[i]} - c.value(column + i)));
          ++pixels;
        }
      }
    }
    EXPECT_LT(worst, kClose) << "form " << static_cast<int>(form);
    RecordProperty("form_" + std::to_string(static_cast<int>(form)), std::to_string(worst * 1e6) + "e-6");
  }
}

TEST(second_order, segments_are_straight_between_their_ends) {
  Random random(6);
  for (int i = 0; i < 20000; ++i) {
    Case c;
    if (!random_case(random, 400, c)) continue;
    const RowForm form = kForms[whole(random, 0, 6)];
    const int bits = static_cast<int>(whole(random, 1, 6));
    for (int column = c.ends.first & -kLanes; column <= c.ends.last; column += kLanes) {
      float found[kLanes];
      read(c, form, bits, column, found);
      for (int k = std::max(0, c.ends.first - column); k < std::min(kLanes, c.ends.last + 1 - column); ++k) {
        ASSERT_NEAR(double{found[k]}, c.straight(column + k, bits), kClose)
            << "form " << static_cast<int>(form);
      }
    }
  }
}

// Sixteen rows side by side, as gathered pixels have them, give the bits of one row's span.
TEST(second_order, a_pixel_does_not_depend_on_its_company) {
  Random random(7);
  for (int i = 0; i < 2000; ++i) {
    Case c;
    if (!random_case(random, 600, c)) continue;
    const auto column = static_cast<int>(whole(random, c.ends.first, c.ends.last));
    isa_test::RowFrame<F32> frame;
    for (int k = 0; k < 3; ++k) {
      frame.x[k] = F32(c.frame.x[k]);
      frame.y[k] = F32(c.frame.y[k]);
    }
    frame.area = F32(c.frame.area);
    frame.inverse_height = F32(c.frame.inverse_height);
    frame.slope = F32(c.frame.slope);
    frame.bend = F32(c.frame.bend);
    frame.over = F32(c.frame.over);
    const isa_test::SecondOrder<F32> surface{F32(c.surface.f), F32(c.surface.a), F32(c.surface.c),
                                             F32(c.surface.b), F32(c.surface.e), F32(c.surface.d)};
    const isa_test::RowStart<F32> start{F32(c.start.s), F32(c.start.along)};
    const isa_test::RowParabola<F32> parabola{F32(c.row.p0), F32(c.row.p1)};
    const isa_test::FormedRow<F32> row{frame, start, I32(c.ends.first), I32(c.ends.last)};
    for (const RowForm form : kForms) {
      for (const int bits : {0, 3}) {
        float span[kLanes], gathered[kLanes];
        read(c, form, bits, column & -kLanes, span);
        const F32 x(static_cast<float>(256 * column + 128));
        isa_test::store(bits == 0 ? row.value(form, surface, parabola, x)
                                  : row.segment_value(form, bits, surface, parabola, x),
                        gathered);
        ASSERT_EQ(span[column % kLanes], gathered[0]) << "form " << static_cast<int>(form);
      }
    }
  }
}

}  // namespace
}  // namespace blysk
