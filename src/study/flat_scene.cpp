#include "study/flat_scene.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "geometry/screen_vertex.h"
#include "render/view.h"
#include "scene/weld.h"

namespace blysk::study {
namespace {

// Numbers for the parts of a mesh that hang together: of each position the least of its part.
class Parts {
 public:
  Parts(const Mesh& mesh, ThreadPool& threads) {
    welded_ = weld_ids(mesh.positions, threads);
    parent_.resize(welded_.count);
    std::iota(parent_.begin(), parent_.end(), 0u);
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
      join(mesh.indices[i], mesh.indices[i + 1]);
      join(mesh.indices[i], mesh.indices[i + 2]);
    }
  }

  [[nodiscard]] std::uint32_t of(std::uint32_t position) { return root(welded_.ids[position]); }
  [[nodiscard]] std::uint32_t count() const { return static_cast<std::uint32_t>(parent_.size()); }

 private:
  std::uint32_t root(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::uint32_t one, std::uint32_t other) {
    const std::uint32_t a = of(one), b = of(other);
    parent_[std::max(a, b)] = std::min(a, b);
  }

  WeldedIds welded_;
  std::vector<std::uint32_t> parent_;
};

// The share of its colour that a surface shows to the lamp; both sides are alike.
double brightness(Vec3d a, Vec3d b, Vec3d c) {
  const Vec3d towards_lamp = normalize(Vec3d{0.4, 0.5, 0.77});
  return 0.25 + 0.75 * std::abs(dot(normalize(cross(b - a, c - a)), towards_lamp));
}

struct Placed {
  Vec3d at;
  bool inside = false;
};

Placed place(const Mat4& screen, Vec3d world) {
  const Vec4d p = transform(screen, {world.x, world.y, world.z, 1});
  if (!(p.w > 0)) return {};
  const Vec3d at = {p.x / p.w / kSubpixels, p.y / p.w / kSubpixels, 1 - p.z / p.w};
  constexpr double kGuard = 1 << 15;
  return {at, at.z >= 0 && at.z <= 1 && std::abs(at.x) <= kGuard && std::abs(at.y) <= kGuard};
}

bool beside(const std::array<Vec3d, 3>& c, int width, int height) {
  const auto [left, right] = std::minmax({c[0].x, c[1].x, c[2].x});
  const auto [top, bottom] = std::minmax({c[0].y, c[1].y, c[2].y});
  return right < 0 || bottom < 0 || left > width || top > height;
}

Vec3f color_of(const Mesh& mesh, const Material& material, std::uint32_t corner) {
  if (mesh.colors.empty()) return material.color;
  const Vec4f& c = mesh.colors[corner];
  return {material.color.x * c.x, material.color.y * c.y, material.color.z * c.z};
}

}  // namespace

Camera study_camera(const Scene& scene, int width, int height) {
  return scene.cameras.empty() ? frame_camera(scene, {.aspect = static_cast<double>(width) / height})
                               : scene.cameras.front();
}

Result<std::vector<FlatTriangle>> flat_triangles(const Scene& scene, const Camera& camera, int width,
                                                 int height) {
  const Result<ViewFrame> view = make_view(camera, scene, width, height);
  if (!view) return view.error();

  ThreadPool threads(1);
  std::vector<FlatTriangle> triangles;
  std::uint32_t first_object = 0;
  for (const Instance& instance : scene.instances) {
    const Mesh& mesh = scene.meshes[instance.mesh];
    const Material& material = scene.materials[instance.material];
    Parts parts(mesh, threads);
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
      Vec3d world[3];
      FlatTriangle t;
      bool inside = true;
      for (std::size_t k = 0; k < 3; ++k) {
        world[k] = transform_point(instance.transform, to_double(mesh.positions[mesh.indices[i + k]]));
        const Placed placed = place(view->screen, world[k]);
        t.corners[k] = placed.at;
        inside = inside && placed.inside;
      }
      if (!inside || beside(t.corners, width, height)) continue;
      const double bright = material.unlit ? 255 : 255 * brightness(world[0], world[1], world[2]);
      t.rgb = to_float(to_double(color_of(mesh, material, mesh.indices[i])) * bright);
      t.alpha = material.alpha_mode == AlphaMode::blend ? material.opacity : 1;
      t.object = first_object + parts.of(mesh.indices[i]);
      triangles.push_back(t);
    }
    first_object += parts.count();
  }
  return triangles;
}

}  // namespace blysk::study
