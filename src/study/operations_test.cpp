// Counts against those of the specification, and the walks against the exact model.
#include "study/operations.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "blysk/methods.h"
#include "shading/angular_reference.h"
#include "shading/cubic_reference.h"
#include "shading/normals_reference.h"
#include "shading/row_normals_reference.h"
#include "shading/symmetric_reference.h"
#include "study/cost_model.h"
#include "study/paper_tables.h"

namespace blysk::study {
namespace {

using reference::RowCubicOf;

Operations without_compare(Operations o) {
  o.compare = 0;
  return o;
}

TEST(operations, counted_numbers) {
  const Counted a = Counted::input(3), b = Counted::input(2);
  const Operations before = operations_so_far();
  Counted r = (a + b) * (a - b) / a;
  r = sqrt(r) * 8 / 2 + 0;
  r = -r * 1.5;
  const bool less = r < a;
  EXPECT_TRUE(less);
  EXPECT_NEAR(r.value(), -1.5 * 4 * std::sqrt(5.0 / 3), 1e-12);
  EXPECT_EQ(operations_so_far() - before,
            (Operations{.add = 2, .mul = 2, .div = 1, .sqrt = 1, .shift = 2, .shift_bits = 4, .compare = 1}));
}

TEST(operations, constants_are_free) {
  const Operations before = operations_so_far();
  const Counted third = Counted(1) / 3 + 2 * Counted(5);
  EXPECT_NEAR(third.value(), 31.0 / 3, 1e-12);
  EXPECT_EQ(operations_so_far(), before);
}

// Section 3.4 of the specification; two pixels, so that a pair of the symmetric form is whole.
TEST(operations, per_pixel) {
  const auto two = [](const char* name) { return without_compare(count_two_pixels(find_walk(name))); };
  EXPECT_EQ(two("phong"), (Operations{.add = 18, .mul = 38, .div = 2, .sqrt = 2}));
  Operations symmetric = two("symmetric");
  symmetric.shift_bits = 0;
  EXPECT_EQ(symmetric, (Operations{.add = 10, .mul = 21, .shift = 4}));
  EXPECT_EQ(two("angular"), (Operations{.add = 4, .mul = 20}));
  EXPECT_EQ(two("cubic"), (Operations{.add = 12}));
  EXPECT_EQ(two("quadratic"), (Operations{.add = 8}));
  EXPECT_EQ(kPentium32.clocks(two("phong")), 2u * 347);
  EXPECT_EQ(kPentium32.clocks(symmetric), 265u);  // 2 * 132.5
  EXPECT_EQ(kPentium32.clocks(two("angular")), 2u * 116);
  EXPECT_EQ(kPentium32.clocks(two("cubic")), 2u * 18);
  EXPECT_EQ(kPentium32.clocks(two("quadratic")), 2u * 12);
}

TEST(operations, horner) {
  const auto in = [](double v) { return Counted::input(v); };
  const RowCubicOf<Counted> cubic = {in(0.1), in(0.2), in(0.3), in(0.4)};
  const Operations before = operations_so_far();
  static_cast<void>(cubic.at(in(0.7)));
  const Operations once = operations_so_far() - before;
  EXPECT_EQ(once, (Operations{.add = 3, .mul = 3}));  // twice for both terms: 6, 6, 84 clocks
  EXPECT_EQ(2 * kPentium32.clocks(once), 84u);
}

// Table 2.1 of the thesis, all of it but the misprinted multiplications of (2.2).
TEST(operations, table_2_1) {
  for (const FormulaRow& row : formula_table()) {
    const Operations o = count_row(static_cast<QuadraticForm>(row.form), 16);
    const bool misprinted = row.form == 0;
    EXPECT_EQ(8 * o.mul, misprinted ? 1024u : row.mul_clocks) << row.form;
    EXPECT_EQ(o.add, row.add) << row.form;
    EXPECT_EQ(o.shift_bits, row.shift) << row.form;
    EXPECT_EQ(kXeonPhi.clocks(o), misprinted ? 1104u : row.total) << row.form;
    EXPECT_EQ(row.true_total(), row.total) << row.form;
  }
}

// The thesis' own formulas for n pixels (section 4.3).
TEST(operations, totals_of_a_row) {
  for (const std::uint64_t n : {4u, 16u, 57u}) {
    const auto of = [&](QuadraticForm form) {
      const Operations o = count_row(form, n);
      return std::array{o.mul, o.add, o.shift_bits};
    };
    EXPECT_EQ(of(QuadraticForm::step), (std::array{n + 4, 4 * n + 1, n - 1}));
    EXPECT_EQ(of(QuadraticForm::pair), (std::array<std::uint64_t, 3>{6, 2 * n + 5, 2 * n - 3}));
    EXPECT_EQ(of(QuadraticForm::triple), (std::array<std::uint64_t, 3>{6, 3 * n + 2, 2 * n - 3}));
    EXPECT_EQ(of(QuadraticForm::values), (std::array<std::uint64_t, 3>{2 * n, 2 * n + 5, 3}));
    EXPECT_EQ(of(QuadraticForm::values_shift), (std::array<std::uint64_t, 3>{6, 4 * n - 1, 2 * n - 3}));
    EXPECT_EQ(of(QuadraticForm::horner), (std::array<std::uint64_t, 3>{5 * n, 5 * n, 0}));
  }
}

TEST(operations, forms_of_a_row_agree) {
  const reference::SecondOrderSurface surface = {-0.0022, -0.0015, 0.0011, 0.013, 0.021, 0.45};
  for (int form = 0; form <= static_cast<int>(QuadraticForm::forward); ++form) {
    double row[24];
    reference::quadratic_row<double>(static_cast<QuadraticForm>(form), surface, -5, 6, row);
    for (int k = 0; k < 24; ++k) EXPECT_NEAR(row[k], surface.at(-5 + k, 6), 1e-12) << form << " " << k;
  }
}

// Against the exactly interpolated normal, at every pixel. Methods of rows start from unit row ends, which
// bends the normals a little (4e-4).
TEST(operations, walks_show_what_their_method_does) {
  const WalkTriangle<double> t = average_triangle<double>();
  Pixels<double> exact(t.rows);
  find_walk("phong").run_exactly(t, exact);
  const struct {
    const char* name;
    double diffuse, specular;  // largest difference from phong on this triangle
  } expected[] = {{"flat", 0.2, 1},
                  {"gouraud", 0.03, 1},
                  {"gouraud-constant", 0.03, 1},
                  {"quadratic", 0.001, 0.25},
                  {"cubic", 4e-4, 0.2},
                  {"cubic-horner", 4e-4, 0.2},
                  {"symmetric", 0.006, 0.8},
                  {"symmetric-exact", 4e-4, 1.4e-4},
                  {"symmetric-chebyshev", 0.0031, 1.2},
                  {"angular", 5e-4, 0.01},
                  {"fast-normalize", 0.0031, 1.2},
                  {"dichotomy-half-sum", 0.004, 1.2},
                  {"barycentric", 0.006, 1.9},
                  {"parallel", 5e-4, 0.01},
                  {"parallel-nines", 0.03, 1},
                  {"lighting-texture", 0.03, 1},
                  {"lighting-texture-17", 0.03, 1}};
  for (const auto& e : expected) {
    Pixels<double> shown(t.rows);
    find_walk(e.name).run_exactly(t, shown);
    double diffuse = 0, specular = 0;
    for (std::size_t i = 0; i < exact.all().size(); ++i) {
      diffuse = std::max(diffuse, std::abs(shown.all()[i].diffuse - exact.all()[i].diffuse));
      specular = std::max(specular, std::abs(shown.all()[i].specular - exact.all()[i].specular));
    }
    EXPECT_LE(diffuse, e.diffuse) << e.name;
    EXPECT_LE(specular, e.specular) << e.name;
  }
  EXPECT_EQ(exact.all().size(), static_cast<std::size_t>(kAveragePixels));
}

TEST(operations, every_method_has_a_program) {
  for (const Method& method : methods()) {
    if (method.kind != MethodKind::shading) continue;
    EXPECT_NE(std::ranges::find(walks(), method.name, &Walk::method), walks().end()) << method.name;
  }
}

// A-buffer specification, C.8: one dot product, two parabolas, six vectors of six products and three sums,
// of which the first one's three products with U_0 = 1 are none; the second vector by (10) and five
// polynomials U besides.
TEST(operations, row_of_nine) {
  const auto in = [](double v) { return Counted::input(v); };
  const Vec3<Counted> a = {in(0), in(0), in(1)}, b = {in(0.6), in(0), in(0.8)};
  const Operations before = operations_so_far();
  static_cast<void>(reference::chebyshev_row(kChebyshevPaper, a, b));
  EXPECT_EQ(operations_so_far() - before, (Operations{.add = 2 + 2 * 2 + 6 + 6 * 3 + 5,
                                                      .mul = 3 + 2 * 2 + 9 + 6 * 6 - 3 + 5,
                                                      .shift = 1,
                                                      .shift_bits = 1}));
}

// A highlight of shininess 256 does not fit a triangle whose normals are 20 degrees apart.
TEST(operations, auto_is_one_of_its_two_ways) {
  const WalkTriangle<double> t = average_triangle<double>();
  const auto pixels = [&](const char* name) {
    Pixels<double> out(t.rows);
    find_walk(name).run_exactly(t, out);
    return out;
  };
  const Pixels<double> phong = pixels("phong"), planes = pixels("gouraud-constant");
  const Pixels<double> chosen = pixels("auto"), fitting = pixels("auto-planes");
  for (std::size_t i = 0; i < phong.all().size(); ++i) {
    EXPECT_EQ(chosen.all()[i].diffuse, phong.all()[i].diffuse);
    EXPECT_EQ(chosen.all()[i].specular, phong.all()[i].specular);
    EXPECT_NEAR(fitting.all()[i].diffuse, planes.all()[i].diffuse, 1e-15);
    EXPECT_NEAR(fitting.all()[i].specular, planes.all()[i].specular, 1e-15);
  }
  const auto count = [](const char* name) { return count_operations(find_walk(name)); };
  EXPECT_EQ(count("auto").pixel, count("phong").pixel);
  EXPECT_GT(kPentium32.clocks(count("auto").triangle), kPentium32.clocks(count("phong").triangle));
  EXPECT_EQ(count("auto-planes").pixel, count("gouraud-constant").pixel);
}

// The points of a texture take most of its clocks: 153 of them for a hundred pixels, or six.
TEST(operations, points_of_textures) {
  const StepCounts few = count_operations(find_walk("lighting-texture")),
                   many = count_operations(find_walk("lighting-texture-17"));
  EXPECT_EQ(many.triangle.sqrt, 5u);  // five of the nine corners of its blocks are made unit
  EXPECT_GT(kPentium32.clocks(many.triangle), 153u * 8 * 11);
  EXPECT_LT(kPentium32.clocks(few.triangle), kPentium32.clocks(many.triangle) / 15);
  EXPECT_EQ(few.pixel.div + few.pixel.sqrt, 0u);
}

// The walks of rows against the closed forms that the kernels are held to.
TEST(operations, walks_of_rows_are_their_reference_forms) {
  const WalkTriangle<double> t = average_triangle<double>();
  const auto normals = reference::linear_normals<double>(t.corner, t.normal);
  Pixels<double> symmetric(t.rows), chebyshev(t.rows), angular(t.rows);
  find_walk("symmetric").run_exactly(t, symmetric);
  find_walk("symmetric-chebyshev").run_exactly(t, chebyshev);
  find_walk("angular").run_exactly(t, angular);
  Pixels<double> parallel(t.rows), nines(t.rows);
  find_walk("parallel").run_exactly(t, parallel);
  find_walk("parallel-nines").run_exactly(t, nines);
  for (std::size_t r = 0; r < t.rows.size(); ++r) {
    const PixelRow& row = t.rows[r];
    if (row.steps() == 0) continue;
    const Vec3d a = normalize(normals.at(row.left, row.y)), b = normalize(normals.at(row.right, row.y));
    const reference::SymmetricRow exact(a, b, t.light, row.steps());
    const reference::AngularRow arc(a, b, t.light, row.steps());
    for (int x = 0; x <= row.steps(); ++x) {
      EXPECT_NEAR(symmetric.at(r, x).diffuse, exact.cosine(x, reference::shift_root), 1e-12);
      EXPECT_NEAR(chebyshev.at(r, x).diffuse, exact.cosine(x, reference::chebyshev_root), 1e-12);
      EXPECT_NEAR(angular.at(r, x).diffuse, arc.expanded(x), 2e-5);  // its arc cosine is a polynomial
      EXPECT_NEAR(parallel.at(r, x).diffuse,
                  dot(reference::arc(a, b, static_cast<double>(x) / row.steps()), t.light), 1e-12);
    }
    if (row.steps() < 8) continue;
    const auto nine =
        reference::chebyshev_row(kChebyshevPaper, a, normalize(normals.at(row.left + 8, row.y)));
    for (int x = 0; x <= 8; ++x) {
      EXPECT_NEAR(nines.at(r, x).diffuse, dot(nine[static_cast<std::size_t>(x)], t.light), 1e-12);
    }
  }
}

TEST(operations, the_two_cubics_and_the_two_gouraud_agree) {
  const WalkTriangle<double> t = average_triangle<double>();
  Pixels<double> differences(t.rows), horner(t.rows);
  find_walk("cubic").run_exactly(t, differences);
  find_walk("cubic-horner").run_exactly(t, horner);
  for (std::size_t i = 0; i < horner.all().size(); ++i) {
    EXPECT_NEAR(differences.all()[i].diffuse, horner.all()[i].diffuse, 1e-12);
    EXPECT_NEAR(differences.all()[i].specular, horner.all()[i].specular, 1e-12);
  }
}

// Reference values R15: every printed and every true total.
TEST(paper_tables, clocks) {
  const PaperTable &accelerated = paper_table("4.3"), &phong = paper_table("4.4"),
                   &cubic = paper_table("4.5");
  EXPECT_EQ(accelerated.model.clocks(accelerated.clocked), 20823u);
  EXPECT_EQ(accelerated.true_clocks(), 21873u);
  Operations with_powers = accelerated.clocked;
  with_powers += kPaperPowers;
  EXPECT_EQ(accelerated.model.clocks(with_powers), 29623u);
  EXPECT_EQ(phong.model.clocks(phong.clocked), 146036u);
  EXPECT_EQ(phong.true_clocks(), 146936u);
  EXPECT_EQ(kPentium16.clocks(phong.true_sum()), 122552u);
  EXPECT_EQ(cubic.model.clocks(cubic.clocked), 8484u);
  EXPECT_EQ(cubic.true_clocks(), 8784u);
  for (const PaperTable& table : paper_tables()) {
    EXPECT_EQ(table.model.clocks(table.clocked), table.printed_clocks) << table.id;
  }
}

TEST(paper_tables, sums) {
  EXPECT_EQ(paper_table("4.3").true_sum(), paper_table("4.3").printed_sum);
  EXPECT_EQ(paper_table("4.4").true_sum(),
            (Operations{.add = 3684, .mul = 4100, .div = 1524, .sqrt = 400, .shift = 300}));
  EXPECT_EQ(paper_table("4.5").true_sum(), (Operations{.add = 504, .mul = 528, .div = 48, .shift = 264}));
}

// Section 10.4: one cost of a division for all three tables.
TEST(paper_tables, corrected_ratios) {
  const auto ratio = [](const CostModel& model, Operations candidate) {
    return static_cast<double>(model.clocks(paper_table("4.4").true_sum())) /
           static_cast<double>(model.clocks(candidate));
  };
  Operations specular = paper_table("4.3").true_sum();
  specular += kPaperPowers;
  EXPECT_NEAR(ratio(kPentium16, paper_table("4.3").true_sum()), 5.60, 0.005);
  EXPECT_NEAR(ratio(kPentium32, paper_table("4.3").true_sum()), 6.37, 0.005);
  EXPECT_NEAR(ratio(kPentium16, specular), 4.00, 0.005);
  EXPECT_NEAR(ratio(kPentium32, specular), 4.61, 0.005);
  EXPECT_NEAR(ratio(kPentium16, paper_table("4.5").true_sum()), 13.95, 0.005);
  EXPECT_NEAR(ratio(kPentium32, paper_table("4.5").true_sum()), 15.38, 0.005);
}

}  // namespace
}  // namespace blysk::study
