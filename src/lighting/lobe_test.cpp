// The reference forms against the specification's numbers and error tables; the kernels against the
// reference.
#define BLYSK_ISA isa_test
#include "lighting/lobe.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "blysk/methods.h"
#include "blysk/shapes.h"
#include "core/random.h"
#include "lighting/lighting_reference.h"
#include "lighting/lobe_reference.h"
#include "lighting/set_lobe.h"
#include "render/testing.h"

namespace blysk::isa_test {
namespace {

struct Named {
  const char* name;
  Lobe lobe;
};

// In the registry's order.
constexpr Named kLobes[] = {{"power", Lobe::power},
                            {"schlick", Lobe::schlick},
                            {"w3", Lobe::w3},
                            {"w4", Lobe::w4},
                            {"w7", Lobe::w7},
                            {"w8", Lobe::w8},
                            {"w15", Lobe::w15},
                            {"w16", Lobe::w16},
                            {"logarithmic", Lobe::logarithmic},
                            {"quadratic", Lobe::quadratic},
                            {"cosine-squared", Lobe::cosine_squared}};

TEST(lobe, all_of_the_registry_are_tested_here) {
  std::vector<std::string> registered, tested;
  for (const Method& m : methods()) {
    if (m.kind == MethodKind::lobe) registered.emplace_back(m.name);
  }
  for (const Named& n : kLobes) tested.emplace_back(n.name);
  EXPECT_EQ(registered, tested);
}

// Equal in all of the nine digits that the specification prints.
void expect_printed(double value, double printed) {
  const double digit = printed > 0 ? std::pow(10.0, std::floor(std::log10(printed)) - 8) : 1e-25;
  EXPECT_NEAR(value, printed, 0.5001 * digit);
}

// Relief thesis, section 8 of the specification, T13.
TEST(lobe, reference_has_the_numbers_of_the_relief_thesis) {
  struct Row {
    int n, k;
    double c, w, power, schlick, shift;
  };
  constexpr Row kRows[] = {
      {100, 16, 0.99, 0.375312197, 0.366032341, 0.497487437, 0.376796591},
      {100, 8, 0.99, 0.385863908, 0.366032341, 0.497487437, 0.385102437},
      {100, 4, 0.99, 0.405519334, 0.366032341, 0.497487437, 0.407125625},
      {20, 16, 0.95, 0.360568893, 0.358485922, 0.487179487, 0.362055289},
      {1000, 16, 0.9995, 0.619940194, 0.606454823, 0.666555519, 0.621116578},
      {255, 15, 0.998, 0.613946262, 0.600188995, 0.661803714, 0.613946262},
      {50, 3, 0.97, 0.235456609, 0.218065375, 0.392712551, 0.235456609},
      {100, 7, 0.98, 0.130400236, 0.132619556, 0.328859060, 0.130400236},
      {100, 16, 0.5, 0, 0, 0.00990099010, 0},
  };
  for (const Row& r : kRows) {
    SCOPED_TRACE("n " + std::to_string(r.n) + ", k " + std::to_string(r.k));
    expect_printed(reference::w_lobe(r.c, reference::w_scale(r.n, r.k), r.k), r.w);
    expect_printed(reference::w_lobe(r.c, reference::w_shift_scale(r.n, r.k), r.k), r.shift);
    expect_printed(reference::power_lobe(r.c, r.n), r.power);
    expect_printed(reference::schlick_lobe(r.c, r.n), r.schlick);
  }
}

// Shading thesis, section 13 of the specification, R11.
TEST(lobe, reference_has_the_numbers_of_the_shading_thesis) {
  struct Row {
    double c, n, power, cosine_squared, cosine_squared_best, quadratic, schlick;
  };
  constexpr Row kRows[] = {
      {1, 50, 1, 1, 1, 1, 1},
      {0.995, 50, 0.778312557, 0.765625, 0.829979357, 0.829785693, 0.799196787},
      {0.98, 50, 0.36416968, 0.25, 0.414901027, 0.413200792, 0.494949495},
      {0.95, 50, 0.0769449753, 0, 0.0121705652, 0.0105027297, 0.275362319},
      {0.99, 255, 0.0770858423, 0, 0.00856118843, 0.00822339784, 0.279661017},
      {0.9, 10, 0.34867844, 0.25, 0.414901027, 0.406920455, 0.473684211},
      {0.8, 10, 0.107374182, 0, 0.0830916528, 0.0691233796, 0.285714286},
  };
  for (const Row& r : kRows) {
    SCOPED_TRACE("c " + std::to_string(r.c) + ", n " + std::to_string(r.n));
    expect_printed(reference::power_lobe(r.c, r.n), r.power);
    expect_printed(reference::cosine_squared_lobe(r.c, r.n, 2), r.cosine_squared);
    expect_printed(reference::cosine_squared_lobe(r.c, r.n), r.cosine_squared_best);
    expect_printed(reference::quadratic_lobe(r.c, r.n), r.quadratic);
    expect_printed(reference::schlick_lobe(r.c, r.n), r.schlick);
  }
}

// Largest errors against cos^n: relative where it is at least 0.5, absolute where it is 0.25 to 0.5, absolute
// everywhere.
struct Errors {
  double centre = 0, bloom = 0, all = 0;
};

template <class Shape>
Errors measure(double n, Shape shape, int steps = 20'000) {
  Errors e;
  const auto look = [&](double c) {
    const double exact = std::pow(c, n), error = std::abs(shape(c) - exact);
    constexpr double kRounding = 1e-12;
    if (exact >= 0.5 - kRounding) e.centre = std::max(e.centre, error / exact);
    if (exact >= 0.25 - kRounding && exact <= 0.5 + kRounding) e.bloom = std::max(e.bloom, error);
    e.all = std::max(e.all, error);
  };
  const double end = std::min(std::numbers::pi / 2, 9 / std::sqrt(n));
  for (int i = 0; i < steps; ++i) look(std::cos(end * i / steps));
  for (const double level : {0.25, 0.5}) look(std::pow(level, 1 / n));
  return e;
}

// Relief thesis, section 4.2: per cent, two decimals.
TEST(lobe, errors_of_w_are_those_of_the_specification) {
  struct Row {
    int n;
    Errors k16, k8, k4, schlick;
  };
  constexpr Row kRows[] = {
      {20, {0.53, 0.27, 0.27}, {3.11, 1.55, 1.58}, {7.85, 3.92, 3.97}, {17.28, 16.06, 19.10}},
      {50, {1.85, 0.92, 0.94}, {4.43, 2.21, 2.25}, {9.19, 4.59, 4.64}, {17.79, 16.57, 19.85}},
      {100, {2.29, 1.15, 1.17}, {4.88, 2.44, 2.47}, {9.64, 4.82, 4.86}, {17.96, 16.74, 20.11}},
      {256, {2.57, 1.28, 1.30}, {5.16, 2.58, 2.61}, {9.92, 4.96, 5.00}, {18.06, 16.84, 20.26}},
      {1000, {2.70, 1.35, 1.37}, {5.29, 2.65, 2.68}, {10.05, 5.03, 5.07}, {18.11, 16.89, 20.34}},
  };
  const auto expect = [](const Errors& measured, const Errors& printed) {
    EXPECT_NEAR(100 * measured.centre, printed.centre, 0.0053);  // n = 50, k = 4: 9.1848
    EXPECT_NEAR(100 * measured.bloom, printed.bloom, 0.0051);
    EXPECT_NEAR(100 * measured.all, printed.all, 0.0051);
  };
  for (const Row& r : kRows) {
    SCOPED_TRACE(r.n);
    const auto w = [&](int k) {
      return measure(r.n, [&](double c) { return reference::w_lobe(c, reference::w_scale(r.n, k), k); });
    };
    expect(w(16), r.k16);
    expect(w(8), r.k8);
    expect(w(4), r.k4);
    expect(measure(r.n, [&](double c) { return reference::schlick_lobe(c, r.n); }), r.schlick);
  }
}

// The same section, at n = 1000: the scales by shifts.
TEST(lobe, errors_of_w_by_shifts_are_those_of_the_specification) {
  constexpr std::pair<Lobe, double> kPrinted[] = {{Lobe::w3, 6.52}, {Lobe::w7, 3.04}, {Lobe::w15, 1.46},
                                                  {Lobe::w4, 5.20}, {Lobe::w8, 2.61}, {Lobe::w16, 1.50}};
  for (const auto& [lobe, printed] : kPrinted) {
    const auto shape = [lobe = lobe](double c) { return reference::specular_lobe(lobe, c, 1000); };
    EXPECT_NEAR(100 * measure(1000, shape).all, printed, 0.0051);
  }
}

// Shading thesis, section 8.2: three decimals.
TEST(lobe, errors_of_hardware_lobes_are_those_of_the_specification) {
  struct Row {
    double n, logarithmic, cosine_squared, cosine_squared_best, schlick;
  };
  constexpr Row kRows[] = {{10, 0.099, 0.135, 0.080, 0.179},
                           {50, 0.114, 0.157, 0.072, 0.199},
                           {100, 0.116, 0.159, 0.071, 0.201},
                           {255, 0.117, 0.161, 0.070, 0.203}};
  constexpr double kDigit = 0.00051;
  for (const Row& r : kRows) {
    SCOPED_TRACE(r.n);
    const double n = r.n;
    EXPECT_NEAR(measure(n, [&](double c) { return reference::logarithmic_lobe(c, n); }).all, r.logarithmic,
                kDigit);
    EXPECT_NEAR(measure(n, [&](double c) { return reference::cosine_squared_lobe(c, n, 2); }).all,
                r.cosine_squared, kDigit);
    EXPECT_NEAR(measure(n, [&](double c) { return reference::cosine_squared_lobe(c, n); }).all,
                r.cosine_squared_best, kDigit);
    EXPECT_NEAR(measure(n, [&](double c) { return reference::schlick_lobe(c, n); }).all, r.schlick, kDigit);
  }
  // "In the limit of large n", with the best scale and with 1/4.
  EXPECT_NEAR(measure(1000, [](double c) { return reference::quadratic_lobe(c, 1000); }).all, 0.070, kDigit);
  EXPECT_NEAR(measure(1000, [](double c) { return reference::quadratic_lobe(c, 1000, 0.25); }).all, 0.162,
              kDigit);
}

// What the registry claims for every n, the fallbacks to the exact power included.
TEST(lobe, errors_stay_within_what_the_registry_claims) {
  struct Claim {
    Lobe lobe;
    double from, error;
  };
  constexpr Claim kClaims[] = {{Lobe::schlick, 1, 0.204},    {Lobe::w3, 1, 0.066},
                               {Lobe::w4, 1, 0.053},         {Lobe::w7, 1, 0.031},
                               {Lobe::w8, 1, 0.027},         {Lobe::w15, 1, 0.015},
                               {Lobe::w16, 1, 0.016},        {Lobe::logarithmic, 1, 0.118},
                               {Lobe::quadratic, 10, 0.077}, {Lobe::cosine_squared, 10, 0.081}};
  for (const Claim& claim : kClaims) {
    SCOPED_TRACE(static_cast<int>(claim.lobe));
    double worst = 0;
    for (double n = claim.from; n <= 1000; n *= 1.15) {
      const auto shape = [&](double c) { return reference::specular_lobe(claim.lobe, c, n); };
      worst = std::max(worst, measure(n, shape, 2000).all);
    }
    EXPECT_LE(worst, claim.error);
    EXPECT_GE(worst, claim.error - 0.0016);
  }
}

Surface surface_of(Lobe lobe, float shininess) {
  Surface s{};
  s.shininess = shininess;
  s.whole_shininess = shininess == std::floor(shininess) ? static_cast<int>(shininess) : 0;
  set_lobe(s, lobe);
  return s;
}

float random_shininess(Random& random) {
  const float n = std::exp2(std::log2(1000.0f) * random.unit());
  return std::clamp(random.next() % 2 == 0 ? std::round(n) : n, 1.0f, 1000.0f);
}

// A million of (n, cos^2) and of (n, cos) each; the error is that of the rounded root, raised by n, and of
// the polynomials.
TEST(lobe, kernels_agree_with_the_reference) {
  Random random(51);
  for (const Named& named : kLobes) {
    SCOPED_TRACE(named.name);
    double worst = 0;
    for (int i = 0; i < 1'000'000; ++i) {
      const float n = random_shininess(random), square = 1 - random.unit() * random.unit();
      const Surface s = surface_of(named.lobe, n);
      const double bound =
          2e-6 + 5e-8 * static_cast<double>(n) + (named.lobe == Lobe::quadratic ? 4.6e-5 : 0);
      const auto look = [&](double cosine, float got) {
        const double exact = reference::specular_lobe(named.lobe, cosine, static_cast<double>(n));
        worst = std::max(worst, std::abs(static_cast<double>(got) - exact) / bound);
      };
      look(std::sqrt(static_cast<double>(square)), specular_lobe(square, s));
      const float c = std::sqrt(square);
      look(static_cast<double>(c), lobe_of_cosine(c, s));
    }
    EXPECT_LT(worst, 1);
    EXPECT_GT(worst, 0.1);
  }
}

TEST(lobe, lanes_and_floats_have_the_same_bits) {
  Random random(52);
  for (const Named& named : kLobes) {
    SCOPED_TRACE(named.name);
    int different = 0;
    for (int i = 0; i < 2000; ++i) {
      const Surface s = surface_of(named.lobe, random_shininess(random));
      float square[kLanes], got[kLanes];
      for (float& v : square) v = 1 - random.unit() * random.unit();
      store(specular_lobe(load(square), s), got);
      for (int k = 0; k < kLanes; ++k)
        different += bits_of(got[k]) != bits_of(specular_lobe(square[k], s)) ? 1 : 0;
    }
    EXPECT_EQ(different, 0);
  }
}

constexpr float kShininess[] = {1,      1.5f, 2,     2.28f, 2.5f, 2.81f, 2.9f, 3,      3.01f,  4,
                                4.01f,  5,    7,     7.2f,  8,    8.5f,  15,   15.5f,  16,     17,
                                16.01f, 32,   50.5f, 100,   255,  256,   511,  512.5f, 999.5f, 1000};

TEST(lobe, one_in_the_middle_and_nothing_at_right_angles) {
  for (const Named& named : kLobes) {
    for (const float n : kShininess) {
      SCOPED_TRACE(named.name + (", n " + std::to_string(n)));
      const Surface s = surface_of(named.lobe, n);
      EXPECT_NEAR(specular_lobe(1.0f, s), 1, 1e-6);
      EXPECT_NEAR(specular_lobe(1.0000005f, s), 1, 3e-4);  // a rounded cosine
      EXPECT_NEAR(specular_lobe(0.0f, s), 0, 1e-8);
      EXPECT_EQ(reference::specular_lobe(named.lobe, 0, static_cast<double>(n)), 0);
      EXPECT_EQ(reference::specular_lobe(named.lobe, -0.5, static_cast<double>(n)), 0);
      // Between 0 and the least float, too, it is a number from 0 to 1.
      for (const float square : {1e-45f, 1e-38f, 1e-20f, 1e-6f}) {
        const float v = specular_lobe(square, s);
        EXPECT_TRUE(v >= 0 && v <= 1) << square << ": " << v;
      }
    }
  }
}

TEST(lobe, never_grows_with_the_angle) {
  for (const Named& named : kLobes) {
    for (const float n : kShininess) {
      SCOPED_TRACE(named.name + (", n " + std::to_string(n)));
      const Surface s = surface_of(named.lobe, n);
      float last = 1 + 1e-6f, worst = 0;
      for (int i = 0; i <= 4000; ++i) {
        const float v = specular_lobe(1 - static_cast<float>(i) / 4000, s);
        worst = std::max(worst, v - last);
        last = v;
      }
      EXPECT_LE(worst, 1e-6f);
    }
  }
}

// A lobe that would end beyond 90 degrees is the exact power instead.
TEST(lobe, small_shininess_takes_the_exact_power) {
  EXPECT_EQ(surface_of(Lobe::w16, 16).lobe, Lobe::power);
  EXPECT_EQ(surface_of(Lobe::w16, 16.5f).lobe, Lobe::w16);
  EXPECT_EQ(surface_of(Lobe::w3, 3).lobe, Lobe::power);
  EXPECT_EQ(surface_of(Lobe::quadratic, 2).lobe, Lobe::power);
  EXPECT_EQ(surface_of(Lobe::cosine_squared, 2).lobe, Lobe::power);
  EXPECT_EQ(surface_of(Lobe::cosine_squared, 3).lobe, Lobe::cosine_squared);
  EXPECT_EQ(surface_of(Lobe::schlick, 1).lobe, Lobe::schlick);
  EXPECT_EQ(surface_of(Lobe::logarithmic, 1).lobe, Lobe::logarithmic);
}

struct Shot {
  Scene scene;
  RenderOptions options = center_options();
  reference::Lighting lighting;
};

// A sphere without perspective: the picture of normals says what every pixel was lit with.
Shot shot_of(const Named& named, LightingModel model, float shininess) {
  constexpr int kSide = 100;
  Shot shot;
  Result<Scene> sphere = make_shape("sphere?detail=16");
  EXPECT_TRUE(sphere);
  shot.scene = std::move(*sphere);
  for (Vec3f& p : shot.scene.meshes.at(0).positions) p = p * (0.45f * kSide);
  Material& m = shot.scene.materials.at(0);
  m.color = {0.1f, 0.2f, 0.3f};
  m.specular = {0.9f, 0.7f, 0.5f};
  m.shininess = shininess;

  RenderOptions& o = shot.options;
  o.width = o.height = kSide;
  o.camera = pixel_camera(kSide);
  o.camera->eye = {0, 0, 2 * kSide};
  o.camera->far_distance = 4 * kSide;
  o.lighting = model == LightingModel::blinn ? "blinn" : "phong";
  o.lobe = named.name;
  o.transfer = Transfer::none;
  o.ambient = 0.1f;
  o.want_normal = o.want_id = true;
  Light light;
  light.vector = {0.3, 0.4, 1};
  light.color = {1, 1, 1};
  o.lights = {light};
  shot.lighting = {model, m, o.lights, static_cast<double>(o.ambient), named.lobe};
  return shot;
}

// Steps of 1/255 between the picture and the reference, at most.
double worst_error(const Shot& shot, const Frame& frame) {
  double worst = 0;
  int covered = 0;
  for (std::size_t i = 0; i < frame.image.pixels.size(); ++i) {
    if (frame.id[i] == 0) continue;
    ++covered;
    const float* v = &frame.normal.values[3 * i];
    const Vec3d normal = to_double(Vec3f{v[0], v[1], v[2]});
    const reference::Intensity light = reference::light_point(shot.lighting, {}, normal, {0, 0, 1});
    const Vec3d c = light.diffuse + light.specular;
    const double expected[3] = {c.x, c.y, c.z};
    for (int k = 0; k < 3; ++k) {
      const double shown = frame.image.pixels[i] >> (8 * k) & 255;
      worst = std::max(worst, std::abs(shown - 255 * std::min(1.0, expected[k])));
    }
  }
  EXPECT_GT(covered, 6000);
  return worst;
}

TEST(lobe, pictures_of_every_instruction_set_agree_with_the_reference) {
  for (const Named& named : kLobes) {
    for (const LightingModel model : {LightingModel::blinn, LightingModel::phong}) {
      for (const float n : {2.0f, 40.5f, 300.0f}) {
        SCOPED_TRACE(named.name + (", n " + std::to_string(n)) +
                     (model == LightingModel::blinn ? ", Blinn" : ", Phong"));
        const Shot shot = shot_of(named, model, n);
        const Frame expected = render_frame(shot.scene, shot.options, available_isas().front());
        // Half a step of rounding; dot products are good to 1e-6, which the lobe raises by n.
        EXPECT_LT(worst_error(shot, expected), 0.52 + 5e-4 * static_cast<double>(n));
        for (const Isa isa : available_isas()) {
          const Frame frame = render_frame(shot.scene, shot.options, isa);
          EXPECT_TRUE(std::ranges::equal(frame.image.pixels, expected.image.pixels)) << isa_name(isa);
        }
      }
    }
  }
}

}  // namespace
}  // namespace blysk::isa_test
