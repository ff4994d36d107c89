// A finely tessellated sphere against the sphere itself: silhouette, depth, normals and light, from rays in
// double precision.
#include <gtest/gtest.h>

#include <optional>

#include "blysk/shapes.h"
#include "lighting/lighting_reference.h"
#include "render/testing.h"

namespace blysk {
namespace {

constexpr int kLensWidth = 300, kLensHeight = 240, kDetail = 360;
constexpr double kPi = 3.14159265358979323846;

struct Ray {
  Vec3d from, along;  ///< component of `along` on the view axis is 1
};

struct Lens {
  Camera camera;

  [[nodiscard]] Vec3d forward() const { return normalize(camera.target - camera.eye); }
  [[nodiscard]] Vec3d right() const { return normalize(cross(forward(), camera.up)); }
  [[nodiscard]] Vec3d up() const { return cross(right(), forward()); }

  /// Through a point of the picture, pixels.
  [[nodiscard]] Ray at(double x, double y) const {
    const double sx = (2 * x - kLensWidth) / kLensHeight, sy = 1 - 2 * y / kLensHeight;
    if (camera.height > 0) {
      return {camera.eye + (right() * sx + up() * sy) * (camera.height / 2), forward()};
    }
    const double half = std::tan(camera.fov_deg * kPi / 360);
    return {camera.eye, forward() + right() * (sx * half) + up() * (sy * half)};
  }
};

/// View depth at which a ray meets the unit sphere.
std::optional<double> meet(const Ray& r) {
  const double a = dot(r.along, r.along), b = dot(r.along, r.from), c = dot(r.from, r.from) - 1;
  const double square = b * b - a * c;
  if (square < 0) return std::nullopt;
  return (-b - std::sqrt(square)) / a;
}

struct Shot {
  std::string name;
  Lens lens;
  std::vector<Light> lights;
  std::string lighting = "blinn";
};

std::vector<Shot> shots() {
  const auto light = [](Light::Kind kind, Vec3d v, Vec3f color) {
    Light l;
    l.kind = kind;
    l.vector = v;
    l.color = color;
    return l;
  };
  const Light above = light(Light::Kind::directional, {1, 2, 1.5}, {0.7f, 0.6f, 0.5f});
  const Light beside = light(Light::Kind::directional, {-3, 0.2, 0.5}, {0.1f, 0.2f, 0.3f});
  const Light lamp = light(Light::Kind::point, {1.2, 1.0, 1.8}, {0.5f, 0.6f, 0.7f});
  const Light close_lamp = light(Light::Kind::point, {-0.9, 0.2, 1.0}, {0.4f, 0.2f, 0.2f});

  Lens perspective;
  perspective.camera.eye = {0.8, 0.9, 3};
  perspective.camera.target = {0.1, -0.1, 0};
  perspective.camera.fov_deg = 45;
  perspective.camera.near_distance = 1;
  perspective.camera.far_distance = 7;
  Lens wide = perspective;
  wide.camera.eye = {0, 0.3, 1.9};
  wide.camera.target = {0.6, 0, 0};
  wide.camera.fov_deg = 95;
  wide.camera.near_distance = 0.2;
  Lens parallel = perspective;
  parallel.camera.height = 2.3;
  return {{"perspective", perspective, {above, beside}},
          {"perspective, Phong's lighting", perspective, {above, lamp}, "phong"},
          {"perspective, point lights", perspective, {lamp, close_lamp}},
          {"wide, off the middle", wide, {above, lamp}},
          {"wide, diffuse only", wide, {close_lamp}, "lambert"},
          {"orthographic", parallel, {above, beside}},
          {"orthographic, point lights", parallel, {lamp, close_lamp}, "phong"}};
}

const Scene& sphere() {
  static const Scene scene = [] {
    Scene s = std::move(*make_shape("sphere?detail=" + std::to_string(kDetail)));
    Material& m = s.materials.at(0);
    m.color = {0.7f, 0.5f, 0.4f};
    m.specular = {0.3f, 0.3f, 0.2f};
    m.shininess = 40;
    return s;
  }();
  return scene;
}

Frame render(const Shot& shot) {
  RenderOptions o;
  o.antialias = "none";
  o.width = kLensWidth;
  o.height = kLensHeight;
  o.camera = shot.lens.camera;
  o.lights = shot.lights;
  o.lighting = shot.lighting;
  o.ambient = 0.2f;
  o.transfer = Transfer::none;
  o.want_depth = o.want_normal = o.want_id = true;
  return render_frame(sphere(), o);
}

// Calls visit(index, depth, point, cosine of the viewing angle) for pixels that see the sphere and are drawn,
// but for the outermost: there a facet's pixel may show a normal that faces away.
template <class Visit>
void for_each_hit(const Lens& lens, const Frame& frame, Visit visit) {
  for (int y = 0; y < kLensHeight; ++y) {
    for (int x = 0; x < kLensWidth; ++x) {
      const auto i = static_cast<std::size_t>(y * kLensWidth + x);
      const Ray ray = lens.at(x + 0.5, y + 0.5);
      const std::optional<double> depth = meet(ray);
      if (!depth || frame.id[i] == 0) continue;
      const Vec3d p = ray.from + ray.along * *depth;
      const double cosine = -dot(p, normalize(ray.along));
      if (cosine > 0.1) visit(i, *depth, p, cosine);
    }
  }
}

// How far the flat triangles lie inside the sphere: both ways across a facet.
constexpr double kSagitta = 2 * (kPi / kDetail) * (kPi / kDetail) / 8;
// How far snapping to 1/256 pixel may move a corner, in the world, at the distances of these cameras.
constexpr double kSnapped = 2e-5;
// What a pixel shows lies this far from the true point, more the more aslant it is seen.
constexpr double kError = kSagitta + kSnapped;

TEST(analytic_sphere, silhouette) {
  for (const Shot& shot : shots()) {
    SCOPED_TRACE(shot.name);
    const Frame frame = render(shot);
    long drawn = 0, analytic = 0, different = 0;
    for (int y = 0; y < kLensHeight; ++y) {
      for (int x = 0; x < kLensWidth; ++x) {
        const bool covered = frame.id[static_cast<std::size_t>(y * kLensWidth + x)] != 0;
        const bool inside = meet(shot.lens.at(x + 0.5, y + 0.5)).has_value();
        drawn += covered ? 1 : 0;
        analytic += inside ? 1 : 0;
        if (covered == inside) continue;
        ++different;
        bool near_edge = false;
        for (int k = 0; k < 16; ++k) {
          const double dx = 0.5 * std::cos(k * kPi / 8), dy = 0.5 * std::sin(k * kPi / 8);
          near_edge = near_edge || meet(shot.lens.at(x + 0.5 + dx, y + 0.5 + dy)).has_value() != inside;
        }
        EXPECT_TRUE(near_edge) << x << "," << y;
      }
    }
    EXPECT_GT(analytic, 10000);
    // Of a circumference of some 600 pixels: an error of 1/50 pixel.
    EXPECT_LE(different, 12);
    EXPECT_LE(std::abs(drawn - analytic), 12);
  }
}

TEST(analytic_sphere, depth) {
  for (const Shot& shot : shots()) {
    SCOPED_TRACE(shot.name);
    const Frame frame = render(shot);
    const double n = shot.lens.camera.near_distance, f = shot.lens.camera.far_distance;
    double worst = 0;
    for_each_hit(shot.lens, frame, [&](std::size_t i, double depth, Vec3d, double cosine) {
      const double shown = static_cast<double>(frame.depth.values[i]);
      // 0 at the near plane, 1 at the far plane, linear on the screen.
      const double at =
          shot.lens.camera.height > 0 ? n + shown * (f - n) : 1 / (1 / n - shown * (1 / n - 1 / f));
      worst = std::max(worst, std::abs(at - depth) * cosine);
    });
    EXPECT_LT(worst, 2 * kError);
  }
}

TEST(analytic_sphere, normal) {
  for (const Shot& shot : shots()) {
    SCOPED_TRACE(shot.name);
    const Frame frame = render(shot);
    double worst = 0, worst_length = 0;
    for_each_hit(shot.lens, frame, [&](std::size_t i, double, Vec3d p, double cosine) {
      const Vec3d shown = {double{frame.normal.values[3 * i]}, double{frame.normal.values[3 * i + 1]},
                           double{frame.normal.values[3 * i + 2]}};
      worst = std::max(worst, length(shown - p) * cosine);
      worst_length = std::max(worst_length, std::abs(length(shown) - 1));
    });
    EXPECT_LT(worst, 2 * kError);
    EXPECT_LT(worst_length, 2e-7);
  }
}

TEST(analytic_sphere, light) {
  for (const Shot& shot : shots()) {
    SCOPED_TRACE(shot.name);
    const Frame frame = render(shot);
    const reference::Lighting lighting = {shot.lighting == "blinn"   ? LightingModel::blinn
                                          : shot.lighting == "phong" ? LightingModel::phong
                                                                     : LightingModel::lambert,
                                          sphere().materials.at(0), shot.lights, 0.2f};
    long values = 0, rounded_otherwise = 0;
    double worst = 0;
    for_each_hit(shot.lens, frame, [&](std::size_t i, double, Vec3d p, double) {
      const Vec3d viewer = shot.lens.camera.height > 0 ? -shot.lens.forward() : shot.lens.camera.eye - p;
      const reference::Intensity light = reference::light_point(lighting, p, p, viewer);
      const Vec3d c = light.diffuse + light.specular;
      const double expected[3] = {c.x, c.y, c.z};
      for (std::size_t k = 0; k < 3; ++k) {
        const double shown = frame.image.pixels[i] >> (8 * k) & 255;
        const double error = shown - 255 * std::min(expected[k], 1.0);
        worst = std::max(worst, std::abs(error));
        rounded_otherwise += std::abs(error) > 0.5 ? 1 : 0;
        ++values;
      }
    });
    EXPECT_LT(worst, 0.6);  // half a step of rounding, and what the tessellation adds
    EXPECT_GT(values, 30000);
    EXPECT_LT(rounded_otherwise, values / 400);
  }
}

}  // namespace
}  // namespace blysk
