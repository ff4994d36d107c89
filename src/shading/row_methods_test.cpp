// The methods whose normals depend on the ends of a row: kernels against reference forms, and pictures
// against Phong shading.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>

#include "blysk/metrics.h"
#include "blysk/shapes.h"
#include "raster/coverage_reference.h"
#include "shading/normals_reference.h"
#include "shading/row_normals_reference.h"
#include "shading/testing.h"

namespace blysk {
namespace {

constexpr int kRowsSide = 480;

// A row of a triangle: its normal at any column, not unit, and its covered columns.
struct RowOfNormals {
  Vec3d origin, step;
  int first, last;
  double width;  // of the triangle, pixels

  [[nodiscard]] Vec3d raw(int column) const { return origin + step * column; }
  [[nodiscard]] Vec3d unit(int column) const { return normalize(raw(column)); }
};

Vec3d arc_or_linear(const RowOfNormals& row, int from, int to, int column) {
  const Vec3d a = row.unit(from), b = row.unit(to);
  if (from == to) return a;
  if (dot(a, b) < kLowestArc) return row.unit(column);
  return reference::arc(a, b, double(column - from) / (to - from));
}

Vec3d whole_row(const RowOfNormals& row, int column) {
  if (row.last - row.first + 1 < kShortestArc) return row.unit(column);
  return arc_or_linear(row, row.first, row.last, column);
}

template <class Make>
Vec3d nines(const RowOfNormals& row, int column, Make make) {
  const int start = row.first + (column - row.first) / 8 * 8;
  if (start + 8 > row.last) return arc_or_linear(row, start, row.last, column);
  const Vec3d a = row.unit(start), b = row.unit(start + 8);
  if (dot(a, b) < 0) return arc_or_linear(row, start, start + 8, column);
  return make(a, b)[static_cast<std::size_t>(column - start)];
}
template <const ChebyshevRow& kRow>
Vec3d chebyshev(const RowOfNormals& row, int column) {
  return nines(row, column, [](Vec3d a, Vec3d b) { return reference::chebyshev_row(kRow, a, b); });
}
Vec3d weights(const RowOfNormals& row, int column) {
  return nines(row, column, [](Vec3d a, Vec3d b) { return reference::weighted_row(kRowWeightsCubic, a, b); });
}

template <reference::Between kForm>
Vec3d dichotomy(const RowOfNormals& row, int column) {
  if ((column - row.first) % 2 == 0 || column == row.last || row.width < kShortestArc - 1) {
    return row.unit(column);
  }
  const Vec3d a = row.unit(column - 1), b = row.unit(column + 1);
  return dot(a, b) < kLowestArc ? row.unit(column) : reference::between(kForm, a, b);
}

struct RowMethod {
  const char* name;
  Vec3d (*normal)(const RowOfNormals&, int column);
  double sphere;  // largest NMSE to Phong shading, of spheres of any detail
};
constexpr RowMethod kRowMethods[] = {
    {"parallel", whole_row, 1e-5},
    {"parallel:fit=paper", chebyshev<kChebyshevPaper>, 3e-3},
    {"parallel:fit=quadratic", chebyshev<kChebyshevQuadratic>, 1e-5},
    {"parallel:fit=cubic", chebyshev<kChebyshevCubic>, 1e-5},
    {"parallel:fit=weights", weights, 1e-5},
    {"dichotomy", dichotomy<reference::Between::exact>, 1e-5},
    {"dichotomy:form=paper", dichotomy<reference::Between::paper>, 3e-3},
    {"dichotomy:form=minimax", dichotomy<reference::Between::minimax>, 1e-5},
    {"dichotomy:form=half-sum", dichotomy<reference::Between::half_sum>, 1e-4},
};

// Of a pixel that the triangle covers.
RowOfNormals row_of(const Mesh& mesh, std::uint32_t triangle, int column, int row) {
  Vec2<double> corner[3];
  Vec3d normal[3];
  reference::Triangle t;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::uint32_t vertex = mesh.indices[3 * std::size_t{triangle} + k];
    const Vec3d p = to_double(mesh.positions[vertex]);
    corner[k] = {p.x + kRowsSide / 2, kRowsSide / 2 - p.y};
    t.corner[k] = {std::llrint(corner[k].x * 256), std::llrint(corner[k].y * 256), 0};
    normal[k] = to_double(mesh.normals[vertex]);
  }
  const reference::LinearNormals n = reference::linear_normals(corner, normal);
  const auto [left, right] = std::minmax({corner[0].x, corner[1].x, corner[2].x});
  RowOfNormals r = {n.at(0.5, row + 0.5), n.horizontal, column, column, right - left};
  while (reference::covers(t, r.first - 1, row)) --r.first;
  while (reference::covers(t, r.last + 1, row)) ++r.last;
  return r;
}

// More than a million pixels of each method.
TEST(row_methods, kernels_follow_the_reference_forms) {
  Random random(37);
  const Vec3d towards = normalize(Vec3d{2, 3, 6});
  std::map<std::string, long> pixels;
  for (const double size : {7.0, 30.0, 120.0}) {
    for (const double spread : {0.2, 0.7, 3.0}) {
      const int triangles = size < 10 ? 8000 : size < 100 ? 900 : 90;
      const Mesh mesh = random_triangles(random, {kRowsSide, triangles, size, spread, 0.5, 2});
      Material material;
      material.color = {0.5f, 0.5f, 0.5f};
      material.specular = {0.4f, 0.4f, 0.4f};
      material.shininess = 12;
      material.double_sided = true;
      RenderOptions o;
      o.antialias = "none";
      o.width = o.height = kRowsSide;
      o.camera = pixel_camera(kRowsSide);
      o.ambient = 0;
      o.transfer = Transfer::none;
      o.want_id = true;
      Light light;
      light.vector = {2, 3, 6};
      light.color = {1, 1, 1};
      o.lights = {light};
      const Scene scene = scene_of(mesh, material);
      std::map<std::pair<std::uint32_t, int>, RowOfNormals> rows;
      for (const RowMethod& shading : kRowMethods) {
        SCOPED_TRACE(std::string(shading.name) + ", size " + std::to_string(size) + ", spread " +
                     std::to_string(spread));
        o.shading = shading.name;
        const Frame frame = render_frame(scene, o);
        double worst = 0;
        long count = 0, wrong = 0;
        for (int y = 0; y < kRowsSide; ++y) {
          for (int x = 0; x < kRowsSide; ++x) {
            const auto i = static_cast<std::size_t>(y * kRowsSide + x);
            if (frame.id[i] == 0) continue;
            const std::uint32_t triangle = frame.id[i] - 1;
            auto row = rows.find({triangle, y});
            if (row == rows.end())
              row = rows.emplace(std::pair(triangle, y), row_of(mesh, triangle, x, y)).first;
            const RowOfNormals& r = row->second;
            // Where the digits of a float decide: which side is seen, opposite ends.
            const double d = dot(r.unit(r.first), r.unit(r.last));
            const Vec3d n = shading.normal(r, x);
            if (std::abs(n.z) < 2e-3 || d < kLowestArc + 0.02 || length(r.raw(x)) < 0.01) continue;
            const double error =
                std::abs((frame.image.pixels[i] & 255) - 255 * std::min(1.0, lit(n, towards, 12)));
            worst = std::max(worst, error);
            wrong += error > 0.501 ? 1 : 0;
            ++count;
          }
        }
        EXPECT_GT(count, 50000);
        EXPECT_LE(wrong, count / 500);
        EXPECT_LT(worst, 0.7);  // a needle's normals have few digits
        pixels[shading.name] += count;
      }
    }
  }
  for (const auto& [name, count] : pixels) EXPECT_GT(count, 1000000) << name;
}

TEST(row_methods, spheres_look_like_phong) {
  for (const float shininess : {20.0f, 100.0f}) {
    for (const int detail : {10, 25, 50, 100}) {
      Scene scene = std::move(*make_shape("sphere?detail=" + std::to_string(detail)));
      Material& m = scene.materials.at(0);
      m.color = {0.5f, 0.4f, 0.3f};
      m.specular = {0.4f, 0.4f, 0.4f};
      m.shininess = shininess;
      RenderOptions o;
      o.antialias = "none";
      o.width = o.height = 400;
      Light light;
      light.vector = {1, 2, 2};
      light.color = {1, 1, 1};
      o.lights = {light};
      o.transfer = Transfer::none;
      const Frame phong = render_frame(scene, o);
      for (const RowMethod& shading : kRowMethods) {
        SCOPED_TRACE(std::string(shading.name) + ", detail " + std::to_string(detail) + ", shininess " +
                     std::to_string(shininess));
        o.shading = shading.name;
        const Difference d = *compare(phong.image, render_frame(scene, o).image);
        RecordProperty(std::string(shading.name) + "-" + std::to_string(detail) + "-" +
                           std::to_string(static_cast<int>(shininess)),
                       std::to_string(d.nmse * 1e6));
        EXPECT_LT(d.nmse, shading.sphere);
      }
    }
  }
}

// Spans, gathered pixels, clipped and unclipped company, tiles, faces without normals, colours, point lights.
TEST(row_methods, instruction_sets_and_company_do_not_show) {
  const char* const shapes[] = {"teapot?detail=5", "terrain?detail=60", "triangles?count=400&size=1", "cube",
                                "plane"};
  for (const char* shape : shapes) {
    Scene scene = std::move(*make_shape(shape));
    if (std::strcmp(shape, "cube") == 0) scene.meshes.at(0).normals.clear();
    const Scene opposite = turned(scene);
    for (const Interpolation interpolation : {Interpolation::perspective, Interpolation::screen}) {
      for (const double height : {0.0, 2.0}) {
        for (const RowMethod& shading : kRowMethods) {
          SCOPED_TRACE(std::string(shape) + ", " + shading.name);
          RenderOptions o;
          o.antialias = "none";
          o.width = 165;
          o.height = 107;
          o.shading = shading.name;
          o.interpolation = interpolation;
          o.cull = Cull::none;
          Light light;
          light.kind = Light::Kind::point;
          light.vector = {0.4, 0.8, 0.3};
          light.color = {0.6f, 0.6f, 0.6f};
          o.lights = {light, Light{}};
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

// Opposite normals, normals of length 0, needles: a colour like any other.
TEST(row_methods, hard_triangles) {
  const Mesh mesh = hard_triangles();
  RenderOptions o;
  o.antialias = "none";
  o.width = o.height = 200;
  o.camera = pixel_camera(200);
  o.transfer = Transfer::none;
  o.want_id = true;
  for (const RowMethod& shading : kRowMethods) {
    SCOPED_TRACE(shading.name);
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

}  // namespace
}  // namespace blysk
