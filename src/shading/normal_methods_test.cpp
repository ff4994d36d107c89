// The methods that interpolate normals: kernels against reference forms, and pictures against Phong shading.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "blysk/metrics.h"
#include "blysk/shapes.h"
#include "shading/normals_reference.h"
#include "shading/testing.h"

namespace blysk {
namespace {

constexpr int kNormalsSide = 200;

struct NormalMethod {
  const char* name;
  const InverseLength* inverse_length;  // one of the two
  const MidVector* mid_vector;
};

constexpr NormalMethod kNormalMethods[] = {{"fast-normalize", &kInverseLengthPaper, nullptr},
                                           {"fast-normalize:fit=minimax", &kInverseLengthMinimax, nullptr},
                                           {"fast-normalize:fit=cubic", &kInverseLengthCubic, nullptr},
                                           {"barycentric", nullptr, &kMidVectorPaper},
                                           {"barycentric:fit=minimax", nullptr, &kMidVectorMinimax}};

Vec3d reference_normal(const NormalMethod& shading, const Mesh& mesh, std::uint32_t triangle, double x,
                       double y) {
  Vec2<double> corner[3];
  Vec3d normal[3];
  for (std::size_t k = 0; k < 3; ++k) {
    const std::uint32_t vertex = mesh.indices[3 * std::size_t{triangle} + k];
    corner[k] = {double{mesh.positions[vertex].x}, double{mesh.positions[vertex].y}};
    normal[k] = to_double(mesh.normals[vertex]);
  }
  if (shading.inverse_length != nullptr) {
    return reference::normalize_fast(*shading.inverse_length,
                                     reference::linear_normals(corner, normal).at(x, y));
  }
  const Vec3d axes[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const Vec3d c = reference::linear_normals(corner, axes).at(x, y);
  return reference::six_point_normal(*shading.mid_vector, normal, c.x, c.y);
}

struct Followed {
  long pixels = 0, wrong = 0;
  double worst = 0;
};

void follow(const NormalMethod& shading, const Mesh& mesh, const Frame& frame, Vec3d light, Followed& found) {
  for (int row = 0; row < kNormalsSide; ++row) {
    for (int column = 0; column < kNormalsSide; ++column) {
      const auto i = static_cast<std::size_t>(row * kNormalsSide + column);
      if (frame.id[i] == 0) continue;
      const Vec3d n = reference_normal(shading, mesh, frame.id[i] - 1, column + 0.5 - kNormalsSide / 2,
                                       kNormalsSide / 2 - (row + 0.5));
      if (std::abs(n.z) < 1e-3) continue;  // which side faces the viewer is open
      const double expected = 255 * std::min(1.0, lit(n, light, 12));
      const double error = std::abs((frame.image.pixels[i] & 255) - expected);
      found.worst = std::max(found.worst, error);
      found.wrong += error > 0.501 ? 1 : 0;
      ++found.pixels;
    }
  }
}

// More than a million pixels of each.
TEST(normal_methods, kernels_follow_the_reference_forms) {
  Random random(31);
  Material material;
  material.color = {0.5f, 0.5f, 0.5f};
  material.specular = {0.4f, 0.4f, 0.4f};
  material.shininess = 12;
  material.double_sided = true;
  RenderOptions o;
  o.antialias = "none";
  o.width = o.height = kNormalsSide;
  o.camera = pixel_camera(kNormalsSide);
  o.ambient = 0;
  o.transfer = Transfer::none;
  o.want_id = true;
  Light light;
  light.vector = {2, 3, 6};
  light.color = {1, 1, 1};
  o.lights = {light};
  Followed found[std::size(kNormalMethods)];
  for (int round = 0; found[0].pixels < 1000000; ++round) {
    const double size = round % 2 == 0 ? 6 : 70, spreads[] = {0.2, 0.7, 1.5};
    const Mesh mesh =
        random_triangles(random, {kNormalsSide, size < 10 ? 1500 : 60, size, spreads[round % 3]});
    o.interpolation = round / 6 % 2 == 0 ? Interpolation::perspective : Interpolation::screen;
    for (std::size_t i = 0; i < std::size(kNormalMethods); ++i) {
      o.shading = kNormalMethods[i].name;
      follow(kNormalMethods[i], mesh, render_frame(scene_of(mesh, material), o), normalize(light.vector),
             found[i]);
    }
  }
  for (std::size_t i = 0; i < std::size(kNormalMethods); ++i) {
    SCOPED_TRACE(kNormalMethods[i].name);
    EXPECT_LE(found[i].wrong, found[i].pixels / 1000);
    EXPECT_LT(found[i].worst, 0.6);  // a needle's coordinates have few digits
  }
}

RenderOptions sphere_options() {
  RenderOptions o;
  o.antialias = "none";
  o.width = o.height = 400;
  Light light;
  light.vector = {1, 2, 2};
  light.color = {1, 1, 1};
  o.lights = {light};
  o.transfer = Transfer::none;
  o.interpolation = Interpolation::screen;
  return o;
}

// NMSE against Phong shading, a twentieth above and below what was measured. A length that is wrong by 0.3 %
// on flat faces dims or brightens a highlight by its power, by 6 % and 35 %, however fine the mesh.
struct SphereErrors {
  float shininess;
  double nmse[std::size(kNormalMethods)][4];  // in the order of kNormalMethods, by detail
};
constexpr int kSphereDetails[] = {10, 25, 50, 100};
constexpr SphereErrors kSphereErrors[] = {{20,
                                           {{2.816e-5, 1.648e-4, 2.061e-4, 2.173e-4},
                                            {3.104e-5, 1.874e-4, 2.349e-4, 2.473e-4},
                                            {9.541e-6, 2.118e-6, 5.676e-7, 1.419e-7},
                                            {7.283e-5, 3.248e-4, 3.829e-4, 3.982e-4},
                                            {7.358e-6, 5.856e-7, 8.342e-7, 8.917e-7}}},
                                          {100,
                                           {{1.580e-4, 8.077e-4, 1.024e-3, 1.080e-3},
                                            {1.791e-4, 9.187e-4, 1.166e-3, 1.230e-3},
                                            {2.475e-5, 2.902e-6, 7.496e-7, 1.891e-7},
                                            {3.333e-4, 1.665e-3, 1.891e-3, 1.956e-3},
                                            {8.520e-6, 7.432e-7, 1.089e-6, 1.200e-6}}}};

TEST(normal_methods, spheres_look_like_phong) {
  for (const SphereErrors& errors : kSphereErrors) {
    for (std::size_t d = 0; d < std::size(kSphereDetails); ++d) {
      Scene scene = std::move(*make_shape("sphere?detail=" + std::to_string(kSphereDetails[d])));
      Material& m = scene.materials.at(0);
      m.color = {0.5f, 0.4f, 0.3f};
      m.specular = {0.4f, 0.4f, 0.4f};
      m.shininess = errors.shininess;
      RenderOptions o = sphere_options();
      const Frame phong = render_frame(scene, o);
      for (std::size_t i = 0; i < std::size(kNormalMethods); ++i) {
        o.shading = kNormalMethods[i].name;
        const double nmse = compare(phong.image, render_frame(scene, o).image)->nmse;
        EXPECT_NEAR(nmse, errors.nmse[i][d], 0.05 * errors.nmse[i][d])
            << kNormalMethods[i].name << ", detail " << kSphereDetails[d] << ", shininess "
            << errors.shininess;
      }
    }
  }
}

// Spans, gathered pixels, clipped and unclipped company, faces without normals, colours.
TEST(normal_methods, instruction_sets_and_company_do_not_show) {
  const char* const shapes[] = {"teapot?detail=5", "terrain?detail=60", "triangles?count=400&size=1", "cube"};
  for (const char* shape : shapes) {
    Scene scene = std::move(*make_shape(shape));
    if (std::strcmp(shape, "cube") == 0) scene.meshes.at(0).normals.clear();
    const Scene opposite = turned(scene);
    for (const Interpolation interpolation : {Interpolation::perspective, Interpolation::screen}) {
      for (const double height : {0.0, 2.0}) {
        for (const NormalMethod& shading : kNormalMethods) {
          SCOPED_TRACE(std::string(shape) + ", " + shading.name);
          RenderOptions o;
          o.antialias = "none";
          o.width = 165;
          o.height = 107;
          o.shading = shading.name;
          o.interpolation = interpolation;
          o.cull = Cull::none;
          o.camera = camera_inside(height);
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
}

// Opposite normals, normals of length 0, needles: a colour like any other, and no pixel far from Phong
// shading's side.
TEST(normal_methods, hard_triangles) {
  const Mesh mesh = hard_triangles();
  RenderOptions o;
  o.antialias = "none";
  o.width = o.height = kNormalsSide;
  o.camera = pixel_camera(kNormalsSide);
  o.transfer = Transfer::none;
  o.want_id = true;
  for (const NormalMethod& shading : kNormalMethods) {
    for (const Interpolation interpolation : {Interpolation::perspective, Interpolation::screen}) {
      SCOPED_TRACE(shading.name);
      o.interpolation = interpolation;
      o.shading = shading.name;
      const Frame expected = render_frame(scene_of(mesh), o);
      int dark = 0, covered = 0;
      for (std::size_t i = 0; i < expected.id.size(); ++i) {
        if (expected.id[i] == 0) continue;
        ++covered;
        dark += (expected.image.pixels[i] & 255) == 0 ? 1 : 0;
      }
      EXPECT_GT(covered, 15000);
      EXPECT_EQ(dark, 0);
      for (const Isa isa : available_isas()) {
        EXPECT_TRUE(same(expected.image, render_frame(scene_of(mesh), o, isa).image)) << isa_name(isa);
      }
    }
  }
}

}  // namespace
}  // namespace blysk
