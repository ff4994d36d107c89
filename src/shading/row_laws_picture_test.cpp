// symmetric and angular: kernels against the reference forms, pictures against Phong shading.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "blysk/metrics.h"
#include "blysk/shapes.h"
#include "raster/coverage_reference.h"
#include "shading/angular_reference.h"
#include "shading/row_normals_reference.h"
#include "shading/symmetric_reference.h"
#include "shading/testing.h"

namespace blysk {
namespace {

constexpr const char* kVariants[] = {"symmetric:row=3",
                                     "symmetric:root=exact,row=3",
                                     "symmetric:root=taylor,row=3",
                                     "symmetric:root=chebyshev,row=3",
                                     "symmetric:root=shift,row=3",
                                     "angular:row=3",
                                     "angular:walk=foot,row=3",
                                     "angular:ends=spherical,row=3"};

bool mentions(const std::string& method, std::string_view word) {
  return method.find(word) != std::string::npos;
}

constexpr int kPlainWidth = 90, kPlainHeight = 70;
constexpr double kShininess = 24;

// A triangle of pixel_camera() under one far light, in double precision.
struct Plain {
  reference::Triangle triangle;
  Vec3d normal[3];
  Vec3d light = normalize(Vec3d{2, 3, 6});

  [[nodiscard]] Vec3d normal_at(int column, int row) const {
    const auto& [a, b, c] = triangle.corner;
    const double x = column * 256.0 + 128, y = row * 256.0 + 128;
    const auto twice = [&](const reference::Place& p, const reference::Place& q) {
      return (double(p.x) - x) * (double(q.y) - y) - (double(q.x) - x) * (double(p.y) - y);
    };
    const double area = double(triangle.area());
    return normalize((normal[0] * twice(b, c) + normal[1] * twice(c, a) + normal[2] * twice(a, b)) *
                     (1 / area));
  }

  static double lit(double n_l, double n_h) {
    if (n_l <= 0) return 0;
    return 0.5 * std::min(n_l, 1.0) + 0.4 * std::pow(std::clamp(n_h, 0.0, 1.0), kShininess);
  }

  [[nodiscard]] double phong(int column, int row) const {
    Vec3d n = normal_at(column, row);
    if (n.z < 0) n = -n;
    return lit(dot(n, light), dot(n, normalize(light + Vec3d{0, 0, 1})));
  }

  // Of two rows, for L and for H. The foot is moved to a pixel unless it lies half-way between two.
  static double walked(const reference::AngularRow& l, const reference::AngularRow& h, double x) {
    const auto half_way = [](const reference::AngularRow& row) {
      return std::abs(row.foot() - std::floor(row.foot()) - 0.5) < 1e-3 || std::abs(row.foot()) < 1e-3 ||
             std::abs(row.foot() - row.m) < 1e-3;
    };
    if (half_way(l) || half_way(h)) return -1;
    return lit(l.walked(x), h.walked(x));
  }

  // Rows of spherical triangles: from where the long edge is crossed to where another one is.
  double spherical(int column, int row, int first, int last, double& other) const {
    std::size_t top = 0, bottom = 0;
    for (std::size_t k = 1; k < 3; ++k) {
      if (triangle.corner[k].y < triangle.corner[top].y) top = k;
      if (triangle.corner[k].y >= triangle.corner[bottom].y) bottom = k;
    }
    const std::size_t middle = 3 - top - bottom;
    const double y = row * 256.0 + 128;
    const std::size_t pole = y < double(triangle.corner[middle].y) ? top : bottom;
    const std::size_t ends[] = {top + bottom - pole, middle};
    double down[2], at[2];
    for (int i = 0; i < 2; ++i) {
      const reference::Place &c = triangle.corner[pole], &d = triangle.corner[ends[i]];
      down[i] = (y - double(c.y)) / double(d.y - c.y);
      at[i] = double(c.x) + down[i] * double(d.x - c.x);
    }
    Vec3d n[3] = {normal[pole], normal[ends[0]], normal[ends[1]]};
    if (std::min({dot(n[0], n[1]), dot(n[0], n[2]), dot(n[1], n[2])}) < 0) return other;
    const Vec3d a = reference::slerp(n[0], n[1], down[0]), b = reference::slerp(n[0], n[2], down[1]);
    const auto along = [&](int x) { return (x * 256.0 + 128 - at[0]) / (at[1] - at[0]); };
    const Vec3d na = reference::slerp(a, b, along(first)), nb = reference::slerp(a, b, along(last));
    if (std::abs(na.z) < 1e-4 || std::abs(nb.z) < 1e-4) return other;
    if ((na.z < 0) != (nb.z < 0) || dot(na, nb) < 0 || dot(a, b) > 1 - 1e-6) return other;
    if (na.z < 0) {
      for (Vec3d& v : n) v = -v;
    }
    const double m = (at[1] - at[0]) / 256;
    const auto cosine = [&](Vec3d h) {
      const reference::SphericalTriangle t(n[0], n[1], n[2], h);
      const double tau = t.angle_d * down[0], mu = t.angle_f * down[1];
      return reference::AngularRow(t.cos_phi(tau, mu), t.cos_alpha(tau), t.cos_lambda(mu), m)
          .pair(along(column) * m);
    };
    return lit(cosine(light), cosine(normalize(light + Vec3d{0, 0, 1})));
  }

  // Where rounding may decide otherwise, what it decides against is `other`; below 0: it may well.
  double at(const std::string& method, int column, int row, double& other) const {
    int first = column, last = column;
    while (reference::covers(triangle, first - 1, row)) --first;
    while (reference::covers(triangle, last + 1, row)) ++last;
    other = phong(column, row);
    if (last - first < 2) return other;
    if (mentions(method, "spherical")) return spherical(column, row, first, last, other);
    Vec3d na = normal_at(first, row), nb = normal_at(last, row);
    if (std::abs(na.z) < 1e-4 || std::abs(nb.z) < 1e-4) return other;
    if ((na.z < 0) != (nb.z < 0) || dot(na, nb) < 0) return other;
    if (na.z < 0) {
      na = -na;
      nb = -nb;
    }
    const Vec3d h = normalize(light + Vec3d{0, 0, 1});
    const double x = column - first, m = last - first, c = 2 - 2 * dot(na, nb);
    if (mentions(method, "angular")) {
      if (c < 1e-6) return other;
      const reference::AngularRow of_l(na, nb, light, m), of_h(na, nb, h, m);
      return mentions(method, "foot") ? walked(of_l, of_h, x) : lit(of_l.pair(x), of_h.pair(x));
    }
    const auto by = [&](auto root) {
      return lit(reference::SymmetricRow(na, nb, light, m).cosine(x, root),
                 reference::SymmetricRow(na, nb, h, m).cosine(x, root));
    };
    if (mentions(method, "exact")) return by(reference::exact_root);
    if (mentions(method, "taylor")) return by(reference::taylor_root);
    if (mentions(method, "chebyshev")) return by(reference::chebyshev_root);
    if (mentions(method, "shift")) return by(reference::shift_root);
    return by([&](double q) { return reference::fitted_root(q, std::min(-c / 4, -1e-12)); });
  }
};

// A million pixels of symmetric, of angular a third of that each way; its laws have a million each of their
// own in row_laws_test.cpp.
TEST(row_laws, kernels_follow_the_reference_forms) {
  Random random(23);
  RenderOptions o;
  o.antialias = "none";
  o.width = kPlainWidth;
  o.height = kPlainHeight;
  o.camera = pixel_camera(kPlainHeight);
  o.ambient = 0;
  o.transfer = Transfer::none;
  o.want_id = true;
  o.lights.resize(1);
  o.lights[0].vector = {2, 3, 6};
  o.lights[0].color = {1, 1, 1};
  Material material;
  material.color = {0.5f, 0.5f, 0.5f};
  material.specular = {0.4f, 0.4f, 0.4f};
  material.shininess = kShininess;
  material.double_sided = true;
  Scene scene = scene_of(mesh_of({{}, {}, {}}, {0, 1, 2}), material);
  Mesh& mesh = scene.meshes[0];
  mesh.normals.resize(3);
  Frame frame;
  long pixels = 0;
  const std::vector<Isa> isas = available_isas();
  for (int i = 0; pixels < 1600000; ++i) {
    Plain plain;
    const auto reach = static_cast<std::int64_t>(256) << whole(random, 2, 6);
    const std::int64_t cx = whole(random, 0, kPlainWidth * 256), cy = whole(random, 0, kPlainHeight * 256);
    const Vec3d axis = normalize(random_direction(random) + Vec3d{0, 0, 1});
    const double cone = uniform(random, 0, 1.2);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int64_t x = cx + whole(random, -reach, reach), y = cy + whole(random, -reach, reach);
      mesh.positions[k] =
          to_float(Vec3d{double(x - kPlainWidth * 128) / 256, double(kPlainHeight * 128 - y) / 256, 0.0});
      mesh.normals[k] = to_float(normalize(axis + random_direction(random) * cone));
      plain.triangle.corner[k] = {x, y, 0};
      plain.normal[k] = to_double(mesh.normals[k]);
    }
    if (std::abs(plain.triangle.area()) < 20 * 65536) continue;
    const std::string method = kVariants[i % 8];
    o.shading = method;
    render_to(frame, scene, o, isas[static_cast<std::size_t>(i) % isas.size()]);
    for (int y = 0; y < kPlainHeight; ++y) {
      for (int x = 0; x < kPlainWidth; ++x) {
        const auto at = static_cast<std::size_t>(y * kPlainWidth + x);
        if (frame.id[at] == 0) continue;
        double other = 0;
        const double light = plain.at(method, x, y, other);
        if (light < 0) continue;
        const double expected = 255 * std::min(1.0, light);
        const double shown = frame.image.pixels[at] & 255;
        // The fitted polynomial stands back where its error would show.
        const bool may_stand_back = method == kVariants[0];
        if (may_stand_back && std::abs(shown - 255 * std::min(other, 1.0)) < 0.52) continue;
        ASSERT_NEAR(shown, expected, 0.53) << method << ", triangle " << i << ", pixel " << x << "," << y;
        ++pixels;
      }
    }
  }
}

// The thesis' experiment; bounds a little above what was measured. Chebyshev's 1.003 at flat rows is the one
// that grows with finer meshes (erratum E21).
TEST(row_laws, spheres) {
  const struct {
    const char* method;
    double most[3];
  } rows[] = {{"symmetric:row=3", {8e-7, 6e-8, 2e-8}},
              {"symmetric:root=exact,row=3", {8e-7, 6e-8, 2e-8}},
              {"symmetric:root=taylor,row=3", {8e-7, 6e-8, 2e-8}},
              {"symmetric:root=chebyshev,row=3", {2e-4, 2.8e-4, 2.8e-4}},
              {"symmetric:root=shift,row=3", {4e-5, 2e-6, 3e-7}},
              {"angular:row=3", {8e-7, 6e-8, 2e-8}},
              {"angular:walk=foot,row=3", {8e-7, 6e-8, 2e-8}},
              {"angular:ends=spherical,row=3", {3.2e-6, 1.1e-7, 2e-8}}};
  constexpr int kFineness[] = {10, 25, 50};
  for (int i = 0; i < 3; ++i) {
    const Scene scene = *make_shape("spheres?detail=" + std::to_string(kFineness[i]));
    RenderOptions o;
    o.antialias = "none";
    o.width = 1000;
    o.height = 400;
    o.camera = scene.cameras[0];
    o.ambient = 0.196f;
    o.background = {0.5f, 0.5f, 0.5f, 1};
    o.transfer = Transfer::none;
    o.interpolation = Interpolation::screen;
    const Frame phong = render_frame(scene, o);
    for (const auto& row : rows) {
      o.shading = row.method;
      const double nmse = compare(phong.image, render_frame(scene, o).image)->nmse;
      EXPECT_LE(nmse, row.most[i]) << row.method << ", detail " << kFineness[i];
      RecordProperty(std::string(row.method) + "_" + std::to_string(kFineness[i]),
                     std::to_string(nmse * 1e6) + "e-6");
    }
  }
}

// Near lamps, a near viewer, both models, perspective: Phong's picture but for a step or two.
TEST(row_laws, near_lamps_and_viewers) {
  Scene scene = *make_shape("sphere?detail=24");
  scene.materials.at(0).specular = {0.5f, 0.5f, 0.5f};
  scene.materials.at(0).shininess = 50;
  RenderOptions o;
  o.antialias = "none";
  o.width = 400;
  o.height = 300;
  o.camera = Camera{};
  o.camera->eye = {0.4, 0.8, 2.2};
  o.camera->fov_deg = 60;
  o.transfer = Transfer::none;
  o.lights.resize(2);
  o.lights[0].kind = Light::Kind::point;
  o.lights[0].vector = {1, 1, 1.5};
  o.lights[0].color = {0.5f, 0.5f, 0.5f};
  o.lights[1].vector = {-1, 1, 1};
  o.lights[1].color = {0.4f, 0.4f, 0.4f};
  for (const char* lighting : {"blinn", "phong", "lambert"}) {
    for (const Interpolation interpolation : {Interpolation::perspective, Interpolation::screen}) {
      o.lighting = lighting;
      o.interpolation = interpolation;
      o.shading = "phong";
      const Frame phong = render_frame(scene, o);
      for (const char* method :
           {"symmetric:row=3", "symmetric:root=exact,row=3", "angular:row=3", "angular:walk=foot,row=3"}) {
        o.shading = method;
        const Difference d = *compare(phong.image, render_frame(scene, o).image);
        EXPECT_LE(d.max_difference, 2) << method << ", " << lighting;
        EXPECT_LT(d.nmse, 2e-6) << method << ", " << lighting;
        EXPECT_GT(d.different_pixels, 0u) << method << ", " << lighting;
      }
    }
  }
}

// Spans, gathered pixels, clipped and unclipped company, faces without normals.
TEST(row_laws, instruction_sets_and_company_do_not_show) {
  const char* const shapes[] = {"teapot?detail=5", "terrain?detail=60", "triangles?count=400&size=1", "cube"};
  for (const char* shape : shapes) {
    Scene scene = std::move(*make_shape(shape));
    if (std::strcmp(shape, "cube") == 0) scene.meshes.at(0).normals.clear();
    const Scene opposite = turned(scene);
    for (const char* method : {"symmetric:row=3", "symmetric:root=exact,row=9", "angular:row=3", "angular",
                               "angular:walk=foot,ends=spherical"}) {
      for (const double height : {0.0, 2.0}) {
        SCOPED_TRACE(std::string(shape) + ", " + method);
        RenderOptions o;
        o.antialias = "none";
        o.width = 165;
        o.height = 107;
        o.shading = method;
        o.cull = Cull::none;
        o.camera = camera_inside(height);
        o.lights.resize(2);
        o.lights[0].vector = {1, 2, 2};
        o.lights[0].color = {0.5f, 0.5f, 0.5f};
        o.lights[1].kind = Light::Kind::point;
        o.lights[1].vector = {0.5, 1, 0.5};
        o.lights[1].color = {0.5f, 0.4f, 0.3f};
        const Frame expected = render_frame(scene, o);
        EXPECT_GT(expected.statistics.pixels_covered, 500u);
        for (const Isa isa : available_isas()) {
          EXPECT_TRUE(same(expected.image, render_frame(scene, o, isa).image)) << isa_name(isa);
        }
        EXPECT_TRUE(same(expected.image, render_frame(opposite, o).image));
      }
    }
  }
}

// Opposite normals, normals of length 0, needles, lamps behind and in the surface: never darker than the
// ambient light, and Phong's colour where the law does not hold.
TEST(row_laws, hard_triangles) {
  const Mesh mesh = hard_triangles();
  Scene scene = scene_of(mesh);
  scene.materials.at(0).color = {1, 1, 1};
  RenderOptions o;
  o.antialias = "none";
  o.width = o.height = 200;
  o.camera = pixel_camera(200);
  o.transfer = Transfer::none;
  o.want_id = true;
  o.ambient = 0.2f;
  o.lights.resize(3);
  o.lights[0].vector = {0, 0, 1};
  o.lights[0].color = {0.2f, 0.2f, 0.2f};
  o.lights[1].vector = {0, 0, -1};
  o.lights[1].color = {0.2f, 0.2f, 0.2f};
  o.lights[2].kind = Light::Kind::point;
  o.lights[2].vector = {3, 4, 0};
  o.lights[2].color = {0.2f, 0.2f, 0.2f};
  for (const char* method : kVariants) {
    SCOPED_TRACE(method);
    o.shading = method;
    const Frame expected = render_frame(scene, o);
    int covered = 0, dark = 0;
    for (std::size_t i = 0; i < expected.id.size(); ++i) {
      if (expected.id[i] == 0) continue;
      ++covered;
      dark += (expected.image.pixels[i] & 255) < 51 ? 1 : 0;
    }
    EXPECT_GT(covered, 15000);
    EXPECT_EQ(dark, 0);
    for (const Isa isa : available_isas()) {
      EXPECT_TRUE(same(expected.image, render_frame(scene, o, isa).image)) << isa_name(isa);
    }
  }
}

}  // namespace
}  // namespace blysk
