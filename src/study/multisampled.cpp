#include "study/multisampled.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "antialias/coverage_mask.h"
#include "geometry/screen_vertex.h"
#include "render/view.h"
#include "shading/shading_reference.h"

namespace blysk::study {
namespace {

using antialias::Mask;
using antialias::SamplePattern;

// A triangle on the screen, and what its light needs.
struct PlacedTriangle {
  std::array<antialias::Subpixel, 3> corners;
  std::array<double, 3> z;
  reference::ShadedTriangle lit;
};

class Multisampler {
 public:
  Multisampler(const RenderOptions& options, const Multisampling& sampling)
      : options_(options),
        pattern_(*sampling.pattern),
        shade_at_(sampling.shade_at),
        samples_(static_cast<std::size_t>(options.width) * static_cast<std::size_t>(options.height) *
                     pattern_.count,
                 Sample{{double{options.background.x}, double{options.background.y},
                         double{options.background.z}}}) {}

  void draw(const PlacedTriangle& t) {
    const antialias::TriangleCoverage coverage(t.corners, pattern_);
    if (coverage.empty()) return;
    const antialias::DepthPlane plane = antialias::depth_plane(t.corners, t.z);
    const auto [left, right] = std::minmax({t.corners[0].x, t.corners[1].x, t.corners[2].x});
    const auto [top, bottom] = std::minmax({t.corners[0].y, t.corners[1].y, t.corners[2].y});
    const auto pixel = [](std::int64_t v, int size) {
      return static_cast<int>(std::clamp<std::int64_t>(v >> kSubpixelBits, 0, size - 1));
    };
    for (int y = pixel(top, options_.height); y <= pixel(bottom, options_.height); ++y) {
      for (int x = pixel(left, options_.width); x <= pixel(right, options_.width); ++x) {
        draw_pixel(t, plane, coverage.mask(x, y), x, y);
      }
    }
  }

  [[nodiscard]] Image picture() const {
    Image image;
    image.resize(options_.width, options_.height);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
      Vec3d sum;
      for (std::size_t s = 0; s < pattern_.count; ++s) sum = sum + samples_[i * pattern_.count + s].color;
      const auto code = [&](double v) {
        return static_cast<std::uint32_t>(v / static_cast<double>(pattern_.count) * 255 + 0.5);
      };
      image.pixels[i] = code(sum.x) | code(sum.y) << 8 | code(sum.z) << 16 | 0xff000000u;
    }
    return image;
  }

 private:
  struct Sample {
    Vec3d color;
    double z = std::numeric_limits<double>::infinity();
  };

  void draw_pixel(const PlacedTriangle& t, const antialias::DepthPlane& plane, Mask covered, int x, int y) {
    if (covered == 0) return;
    Sample* const pixel = &samples_[(static_cast<std::size_t>(y) * static_cast<std::size_t>(options_.width) +
                                     static_cast<std::size_t>(x)) *
                                    pattern_.count];
    const double center = plane.at(x, y);
    std::optional<Vec3d> color;
    for (Mask left = covered; left != 0; left &= left - 1) {
      const auto s = static_cast<std::size_t>(std::countr_zero(left));
      const double z = center + double{pattern_.a[s]} * plane.zx + double{pattern_.b[s]} * plane.zy;
      if (z >= pixel[s].z) continue;
      if (!color) color = shade(t, covered, x, y);
      pixel[s] = {*color, z};
    }
  }

  [[nodiscard]] Vec3d shade(const PlacedTriangle& t, Mask covered, int x, int y) const {
    double right = 0, down = 0;
    for (Mask left = shade_at_ == ShadeAt::centroid ? covered : 0; left != 0; left &= left - 1) {
      const auto s = static_cast<std::size_t>(std::countr_zero(left));
      right += pattern_.x[s];
      down += pattern_.y[s];
    }
    const double share = 1.0 / antialias::samples_in(covered);
    const auto w = reference::weights(t.lit.corner, (x + 0.5) * kSubpixels + right * share,
                                      (y + 0.5) * kSubpixels + down * share);
    Vec3d position;
    for (std::size_t k = 0; k < 3; ++k) position = position + t.lit.corner[k].position * w[k];
    const Vec3d c = reference::phong(t.lit, w, position);
    const auto shown = [](double v) { return std::clamp(v, 0.0, 1.0); };
    return {shown(c.x), shown(c.y), shown(c.z)};
  }

  const RenderOptions& options_;
  const SamplePattern& pattern_;
  ShadeAt shade_at_;
  std::vector<Sample> samples_;
};

// One instance's triangles, one after another.
class Placer {
 public:
  Placer(const Scene& scene, const Instance& instance, const ViewFrame& view, const RenderOptions& options)
      : mesh_(scene.meshes[instance.mesh]),
        instance_(instance),
        normals_(normal_matrix(instance.transform)),
        view_(view) {
    t_.lit.lighting = {LightingModel::blinn, scene.materials[instance.material], options.lights,
                       double{options.ambient}, Lobe::power};
    t_.lit.view = {options.camera->height > 0, options.camera->eye, view.forward};
  }

  [[nodiscard]] const PlacedTriangle* place(std::size_t first) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (!place_corner(mesh_.indices[first + k], k)) return nullptr;
    }
    if (mesh_.normals.empty()) {
      const Vec3d face = reference::face_normal(t_.lit.corner);
      for (reference::Corner& c : t_.lit.corner) c.normal = face;
    }
    return &t_;
  }

 private:
  bool place_corner(std::uint32_t vertex, std::size_t k) {
    reference::Corner& c = t_.lit.corner[k];
    c.position = transform_point(instance_.transform, to_double(mesh_.positions[vertex]));
    const Vec4d p = transform(view_.screen, {c.position.x, c.position.y, c.position.z, 1});
    if (!(p.w > 0) || p.z < 0 || p.z > p.w) return false;
    c.q = 1 / p.w;
    t_.corners[k] = {std::llrint(p.x * c.q), std::llrint(p.y * c.q)};
    c.x = static_cast<double>(t_.corners[k].x);
    c.y = static_cast<double>(t_.corners[k].y);
    t_.z[k] = 1 - p.z * c.q;
    if (!mesh_.normals.empty()) c.normal = transform_point(normals_, to_double(mesh_.normals[vertex]));
    if (!mesh_.colors.empty()) {
      const Vec4f& own = mesh_.colors[vertex];
      c.color = {double{own.x}, double{own.y}, double{own.z}};
    }
    return true;
  }

  const Mesh& mesh_;
  const Instance& instance_;
  const Mat4 normals_;
  const ViewFrame& view_;
  PlacedTriangle t_;
};

}  // namespace

Result<Image> multisampled(const Scene& scene, const RenderOptions& options, const Multisampling& sampling) {
  const Result<ViewFrame> view = make_view(*options.camera, scene, options.width, options.height);
  if (!view) return view.error();
  Multisampler picture(options, sampling);
  for (const Instance& instance : scene.instances) {
    Placer placer(scene, instance, *view, options);
    const std::size_t corners = 3 * scene.meshes[instance.mesh].triangles();
    for (std::size_t i = 0; i < corners; i += 3) {
      if (const PlacedTriangle* t = placer.place(i)) picture.draw(*t);
    }
  }
  return picture.picture();
}

}  // namespace blysk::study
