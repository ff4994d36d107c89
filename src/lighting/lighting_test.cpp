// The reference forms against the specification's numbers; the kernels' lobe against the reference.
#define BLYSK_ISA isa_test
#include "lighting/lighting.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/random.h"
#include "lighting/lighting_reference.h"

namespace blysk::isa_test {
namespace {

// Section 13, R1: N, L, V (normalised first), Ia = 1, ka = 0.1, Il = 1, kd = 0.6, ks = 0.3.
struct SpecifiedRow {
  Vec3d normal, light, viewer;
  double n, n_l, r_v, n_h, lambert, phong, blinn;
};

constexpr SpecifiedRow kSpecifiedRows[] = {
    {{0.2, 0.3, 1},
     {0.5, 0.5, 1},
     {0, 0, 1},
     10,
     0.960119216,
     0.989911784,
     0.997271232,
     0.676071529,
     0.947144488,
     0.967985022},
    {{0.2, 0.3, 1},
     {0.5, 0.5, 1},
     {0, 0, 1},
     50,
     0.960119216,
     0.989911784,
     0.997271232,
     0.676071529,
     0.856766457,
     0.937760745},
    {{-0.4, 0.1, 1},
     {1, 0.2, 0.3},
     {0.1, -0.2, 1},
     255,
     -0.06957574,
     -0.448510368,
     0.477246408,
     0.1,
     0.1,
     0.1},
    {{0.9, 0, 0.2}, {-1, 0, 0.5}, {0, 0, 1}, 20, -0.776114, -0.783939126, -0.328679839, 0.1, 0.1, 0.1},
    {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}, 50, 1, 1, 1, 0.7, 1, 1},
};

reference::Lighting lighting_of(const SpecifiedRow& row, LightingModel model) {
  reference::Lighting l;
  l.model = model;
  // ka and kd are one colour here, 0.6: Ia * ka = 0.1 is an ambient light of 0.1 / 0.6.
  l.material.color = {0.6f, 0.6f, 0.6f};
  l.ambient = 0.1 / static_cast<double>(0.6f);
  l.material.specular = {0.3f, 0.3f, 0.3f};
  l.material.shininess = static_cast<float>(row.n);
  Light light;
  light.vector = row.light;
  l.lights = {light};
  return l;
}

TEST(lighting, reference_has_the_specifications_numbers) {
  for (const SpecifiedRow& row : kSpecifiedRows) {
    const reference::Directions d = {normalize(row.normal), normalize(row.light), normalize(row.viewer)};
    EXPECT_NEAR(dot(d.normal, d.light), row.n_l, 1e-9);
    EXPECT_NEAR(reference::cos_reflected(d), row.r_v, 1e-9);
    EXPECT_NEAR(reference::cos_halfway(d), row.n_h, 1e-9);
    const auto intensity = [&](LightingModel model) {
      const reference::Intensity i =
          reference::light_point(lighting_of(row, model), {}, row.normal, row.viewer);
      return i.diffuse.x + i.specular.x;
    };
    constexpr double kFloat = 5e-8;  // materials are floats
    EXPECT_NEAR(intensity(LightingModel::lambert), row.lambert, kFloat);
    EXPECT_NEAR(intensity(LightingModel::phong), row.phong, kFloat);
    EXPECT_NEAR(intensity(LightingModel::blinn), row.blinn, kFloat);
  }
}

// Section 13, R11: cos^n.
TEST(lighting, reference_lobe_has_the_specifications_numbers) {
  const double rows[][3] = {{1, 50, 1},
                            {0.995, 50, 0.778312557},
                            {0.98, 50, 0.36416968},
                            {0.95, 50, 0.0769449753},
                            {0.99, 255, 0.0770858423},
                            {0.9, 10, 0.34867844},
                            {0.8, 10, 0.107374182}};
  for (const auto& [cosine, n, expected] : rows) {
    // With L = V = H along z, N stands at the angle asked for.
    const Vec3d normal = {std::sqrt(1 - cosine * cosine), 0, cosine};
    EXPECT_NEAR(reference::specular(LightingModel::blinn, {normal, {0, 0, 1}, {0, 0, 1}}, n), expected, 1e-9);
  }
}

TEST(lighting, opposite_light_and_viewer_have_no_halfway) {
  EXPECT_EQ(reference::specular(LightingModel::blinn, {{0, 0, 1}, {0, 0, 1}, {0, 0, -1}}, 10), 0);
}

Surface surface_of(float shininess) {
  Surface s{};
  s.shininess = shininess;
  s.whole_shininess = shininess == std::floor(shininess) ? static_cast<int>(shininess) : 0;
  return s;
}

// cos^n from the square of the cosine, by squaring or by the polynomials.
TEST(lighting, power_lobe) {
  Random random(41);
  double worst_whole = 0, worst_real = 0;
  for (int i = 0; i < 1'500'000; ++i) {
    const bool is_whole = i % 2 == 0;
    const float n = is_whole ? static_cast<float>(1 + random.next() % 1000) : 1 + 999 * random.unit();
    const float square = 1 - random.unit() * random.unit();
    const double exact = std::pow(static_cast<double>(square), static_cast<double>(n) / 2);
    const double error = std::abs(static_cast<double>(power_lobe(square, surface_of(n))) - exact);
    (is_whole ? worst_whole : worst_real) = std::max(is_whole ? worst_whole : worst_real, error);
  }
  EXPECT_LT(worst_whole, 8e-6);
  EXPECT_LT(worst_real, 1e-6);
  for (const float n : {1.0f, 2.0f, 7.5f, 31.0f, 255.0f, 1000.0f}) {
    EXPECT_EQ(power_lobe(0.0f, surface_of(n)), 0.0f) << n;
    EXPECT_NEAR(power_lobe(1.0f, surface_of(n)), 1.0f, 1e-6f) << n;
  }
}

Surface surface_of(const reference::Lighting& l) {
  Surface s = surface_of(l.material.shininess);
  s.model = l.model;
  const auto set = [](float* to, Vec3f v) { to[0] = v.x, to[1] = v.y, to[2] = v.z; };
  set(s.ambient, l.material.color * static_cast<float>(l.ambient));
  set(s.emission, l.material.emission);
  for (const Light& light : l.lights) {
    Lamp& lamp = s.lamp[s.lamps++];
    lamp.point = light.kind == Light::Kind::point;
    set(lamp.vector, to_float(lamp.point ? light.vector : normalize(light.vector)));
    const Vec3f c = light.color, kd = l.material.color, ks = l.material.specular;
    set(lamp.diffuse, {c.x * kd.x, c.y * kd.y, c.z * kd.z});
    set(lamp.specular, {c.x * ks.x, c.y * ks.y, c.z * ks.z});
  }
  return s;
}

Vec3d random_vector(Random& random) {
  const auto c = [&] { return static_cast<double>(random.signed_unit()); };
  const double x = c(), y = c(), z = c();
  return normalize(Vec3d{x, y, z});
}

// Any direction of everything, lengths from a thousandth to a thousand: a million points.
TEST(lighting, light_point_agrees_with_the_reference) {
  Random random(42);
  double worst = 0, sum = 0;
  int skipped = 0;
  constexpr int kPoints = 1'000'000;
  for (int i = 0; i < kPoints; ++i) {
    reference::Lighting l;
    l.model = static_cast<LightingModel>(random.next() % 3);
    l.ambient = static_cast<double>(random.unit());
    l.material.color = {random.unit(), 0.5f, 1};
    l.material.specular = {1, random.unit(), 0.25f};
    l.material.shininess = 1 + 255 * random.unit() * random.unit();
    if (random.next() % 2 == 0) l.material.shininess = std::round(l.material.shininess);
    Light light;
    light.kind = random.next() % 2 == 0 ? Light::Kind::point : Light::Kind::directional;
    light.vector = random_vector(random) * 3;
    l.lights = {light};
    const auto any_length = [&] {
      return random_vector(random) * std::pow(10.0, 6 * static_cast<double>(random.unit()) - 3);
    };
    const Vec3f normal = to_float(any_length()), viewer = to_float(any_length()),
                position = to_float(random_vector(random));

    // Light jumps where the normal turns away from viewer or lamp.
    const Vec3d n = normalize(to_double(normal)), p = to_double(position);
    const Vec3d to_light = normalize(light.kind == Light::Kind::point ? light.vector - p : light.vector);
    if (std::abs(dot(n, normalize(to_double(viewer)))) < 1e-5 || std::abs(dot(n, to_light)) < 1e-5) {
      ++skipped;
      continue;
    }
    const reference::Intensity exact = reference::light_point(l, p, to_double(normal), to_double(viewer));
    // Roots are good to 1.2e-6; the lobe raises that by its power, and Blinn's H by 1 / |L + V|^2: it is lost
    // where light and viewer are opposite.
    const double l_v = dot(to_light, normalize(to_double(viewer)));
    const double bound = 2e-6 + 5e-6 * static_cast<double>(l.material.shininess) /
                                    (l.model == LightingModel::blinn ? 1 + l_v : 1);
    const V3<float> at = {position.x, position.y, position.z};
    const Intensity<float> got = light_point(surface_of(l), V3<float>{normal.x, normal.y, normal.z},
                                             V3<float>{viewer.x, viewer.y, viewer.z}, [&] { return at; });
    const double errors[] = {static_cast<double>(got.diffuse.x) - exact.diffuse.x,
                             static_cast<double>(got.diffuse.y) - exact.diffuse.y,
                             static_cast<double>(got.diffuse.z) - exact.diffuse.z,
                             static_cast<double>(got.specular.x) - exact.specular.x,
                             static_cast<double>(got.specular.y) - exact.specular.y,
                             static_cast<double>(got.specular.z) - exact.specular.z};
    for (const double e : errors) {
      worst = std::max(worst, std::abs(e) / bound);
      sum += std::abs(e);
    }
  }
  EXPECT_LT(worst, 1);
  EXPECT_LT(sum / (6 * kPoints), 2e-7);
  EXPECT_LT(skipped, 100);
}

}  // namespace
}  // namespace blysk::isa_test
