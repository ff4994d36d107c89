#include "render/view.h"

#include <algorithm>

#include "math/trig.h"
#include "render/reach.h"

namespace blysk {
namespace {

constexpr double kLeastNear = 1e-4;  // of the far distance: keeps 1 / w in range

Error usage(std::string message) { return {ErrorCode::usage, std::move(message), "camera", 0}; }

bool finite(Vec3d v) { return length(v) < 1e150; }

// The planes that just enclose the scene, with a little room for rounding.
void enclose(const Scene& scene, const Camera& camera, ViewFrame& view) {
  const auto ends = reach(scene, {view.forward, -view.forward});
  const double eye = dot(camera.eye, view.forward);
  const bool empty = ends[0] < -1e200;
  const double nearest = empty ? length(camera.target - camera.eye) : -ends[1] - eye;
  const double farthest = empty ? nearest : ends[0] - eye;
  const double room = 0.01 * (farthest - nearest) + 1e-6 * length(camera.target - camera.eye);
  view.near_distance = camera.near_distance > 0 ? camera.near_distance : nearest - room;
  view.far_distance = camera.far_distance > 0 ? camera.far_distance : farthest + room;
  if (!(view.far_distance > view.near_distance)) view.far_distance = view.near_distance + 1;
}

void set(float* to, Vec3d v) {
  to[0] = static_cast<float>(v.x);
  to[1] = static_cast<float>(v.y);
  to[2] = static_cast<float>(v.z);
}

// Row `i` becomes scale * (axis . p) + offset, for world p.
void set_row(Mat4& m, int i, Vec3d axis, double offset) {
  m.m[i][0] = axis.x;
  m.m[i][1] = axis.y;
  m.m[i][2] = axis.z;
  m.m[i][3] = offset;
}

}  // namespace

Result<ViewFrame> make_view(const Camera& camera, const Scene& scene, int width, int height) {
  const Vec3d axis = camera.target - camera.eye;
  if (!finite(camera.eye) || !finite(axis) || !(length(axis) > 0)) {
    return usage("eye and target must be two different, finite points");
  }
  const bool orthographic = camera.height > 0;
  if (!orthographic && !(camera.fov_deg >= 1 && camera.fov_deg <= 170)) {
    return usage("the field of view must be 1 to 170 degrees");
  }
  ViewFrame v{};
  v.forward = normalize(axis);
  Vec3d side = cross(v.forward, camera.up);
  if (!(length(side) > 1e-9 * length(camera.up)))
    side = cross(v.forward, {0, 0, v.forward.y > 0 ? 1.0 : -1.0});
  if (!(length(side) > 1e-9)) side = cross(v.forward, {1, 0, 0});
  v.right = normalize(side);
  v.up = cross(v.right, v.forward);
  v.near_distance = camera.near_distance;
  v.far_distance = camera.far_distance;
  if (!(camera.near_distance > 0) || !(camera.far_distance > 0)) enclose(scene, camera, v);
  if (!orthographic) {
    if (v.far_distance <= 0) v.far_distance = 1;  // everything is behind: nothing will be seen
    v.near_distance = std::max(v.near_distance, v.far_distance * kLeastNear);
  }
  if (!(v.far_distance > v.near_distance)) return usage("the far plane must lie behind the near plane");

  const double n = v.near_distance, f = v.far_distance, aspect = double(width) / height;
  const double wide = width * double{kSubpixels}, high = height * double{kSubpixels};
  const double eye_right = dot(v.right, camera.eye), eye_up = dot(v.up, camera.eye),
               eye_forward = dot(v.forward, camera.eye);
  ViewRays& rays = v.rays;
  rays.orthographic = orthographic;
  if (orthographic) {
    const double sx = wide / (camera.height * aspect), sy = high / camera.height;
    set_row(v.screen, 0, v.right * sx, wide * 0.5 - eye_right * sx);
    set_row(v.screen, 1, v.up * -sy, high * 0.5 + eye_up * sy);
    set_row(v.screen, 2, v.forward * (-1 / (f - n)), (f + eye_forward) / (f - n));
    set_row(v.screen, 3, {}, 1);
    set(rays.direction, v.forward);
    set(rays.origin, camera.eye + v.right * (-0.5 * wide / sx) + v.up * (0.5 * high / sy));
    set(rays.origin_x, v.right * (1 / sx));
    set(rays.origin_y, v.up * (-1 / sy));
    rays.depth_a = static_cast<float>(f);
    rays.depth_b = static_cast<float>(n - f);
  } else {
    // View depth d is divided by f, so that w stays near 1.
    const double half = tangent(radians(camera.fov_deg) * 0.5);
    const double sx = wide * 0.5 / (half * aspect * f), sy = high * 0.5 / (half * f);
    const double cx = wide * 0.5 / f, cy = high * 0.5 / f, nz = n / (f - n) / f;
    set_row(v.screen, 0, v.right * sx + v.forward * cx, -eye_right * sx - eye_forward * cx);
    set_row(v.screen, 1, v.up * -sy + v.forward * cy, eye_up * sy - eye_forward * cy);
    set_row(v.screen, 2, v.forward * -nz, (f + eye_forward) * nz);
    set_row(v.screen, 3, v.forward * (1 / f), -eye_forward / f);
    set(rays.direction, v.forward - v.right * (half * aspect) + v.up * half);
    set(rays.direction_x, v.right * (2 * half * aspect / wide));
    set(rays.direction_y, v.up * (-2 * half / high));
    set(rays.origin, camera.eye);
    rays.depth_a = static_cast<float>(f);
    rays.depth_b = static_cast<float>((f - n) / n);
  }
  return v;
}

}  // namespace blysk
