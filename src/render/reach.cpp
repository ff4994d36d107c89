#include "render/reach.h"

#include <algorithm>

#include "render/kernels.h"

namespace blysk {

std::array<double, kSupportAxes> reach(const Scene& scene, const std::array<Vec3d, kSupportAxes>& axes) {
  constexpr float kLeast = -3e38f;
  std::array<double, kSupportAxes> most;
  most.fill(-1e300);
  for (const Instance& instance : scene.instances) {
    const Array<Vec3f>& points = scene.meshes[instance.mesh].positions;
    if (points.empty()) continue;
    // Axes are carried into the mesh's coordinates, not every vertex out of them.
    const auto& m = instance.transform.m;
    Vec3f local[kSupportAxes];
    float far[kSupportAxes];
    const auto column = [&](Vec3d a, int j) { return a.x * m[0][j] + a.y * m[1][j] + a.z * m[2][j]; };
    for (std::size_t k = 0; k < kSupportAxes; ++k) {
      local[k] = to_float(Vec3d{column(axes[k], 0), column(axes[k], 1), column(axes[k], 2)});
      far[k] = kLeast;
    }
    kernels(Isa::best).support(points.data(), points.size(), local, far);
    for (std::size_t k = 0; k < kSupportAxes; ++k) {
      most[k] = std::max(most[k], double{far[k]} + column(axes[k], 3));
    }
  }
  return most;
}

}  // namespace blysk
