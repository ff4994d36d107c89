// The camera that a scene just fits into.
#include <algorithm>
#include <array>

#include "blysk/render.h"
#include "math/trig.h"
#include "render/reach.h"

namespace blysk {
namespace {

Vec3d looking_from(View view) {
  switch (view) {
    case View::front:
      return {0, 0, 1};
    case View::back:
      return {0, 0, -1};
    case View::left:
      return {-1, 0, 0};
    case View::right:
      return {1, 0, 0};
    case View::top:
      return {0, 1, 0};
    case View::bottom:
      return {0, -1, 0};
    case View::iso:
      break;
  }
  return normalize(Vec3d{1, 0.8, 1.4});
}

}  // namespace

Camera frame_camera(const Scene& scene, const Framing& framing) {
  constexpr double kMargin = 1.06;
  const Vec3d from = looking_from(framing.view);
  const Vec3d forward = -from;
  Camera c;
  c.fov_deg = framing.fov_deg;
  c.up = framing.view == View::top      ? Vec3d{0, 0, -1}
         : framing.view == View::bottom ? Vec3d{0, 0, 1}
                                        : Vec3d{0, 1, 0};
  const Vec3d right = normalize(cross(forward, c.up));
  const Vec3d up = cross(right, forward);
  const double half = tangent(radians(framing.fov_deg) * 0.5);
  // The planes of a perspective picture lean outwards, those of an orthographic one do not.
  const double high = framing.orthographic ? 0 : half / kMargin, wide = high * framing.aspect;
  auto s = reach(scene, {right - forward * wide, -right - forward * wide, up - forward * high,
                         -up - forward * high, forward, -forward});
  if (s[0] < -1e200) s = {1, 1, 1, 1, 1, 1};  // nothing there: frame a box of side 2
  const double across = s[0] + s[1], tall = s[2] + s[3], deep = s[4] + s[5];
  const double least = 1e-6 * std::max({std::abs(s[0]), std::abs(s[2]), std::abs(s[4]), 1e-30});

  double depth = 0;  // of the eye, along `forward`
  if (framing.orthographic) {
    c.height = kMargin * std::max({tall, across / framing.aspect, least}) / framing.zoom;
    depth = -s[5] - std::max({deep, tall, across, least});
  } else {
    // The eye is where the four planes, pushed against the scene, meet: of the two pairs the one that needs
    // more distance decides.
    depth = -std::max({across / (2 * wide), tall / (2 * high), s[5] + 0.05 * deep + least});
    // Zoom narrows the view: the eye stays outside of the scene.
    if (framing.zoom != 1) {
      c.fov_deg = std::clamp(2 * arc_tangent(half / framing.zoom) * (180.0 / kPi), 1.0, 170.0);
    }
  }
  c.eye = right * ((s[0] - s[1]) * 0.5) + up * ((s[2] - s[3]) * 0.5) + forward * depth;
  c.target = c.eye + forward * std::max((s[4] - s[5]) * 0.5 - depth, least);
  const double room = 0.01 * deep + least;
  c.near_distance = std::max(-s[5] - depth - room, 1e-4 * (s[4] - depth));
  c.far_distance = s[4] - depth + room;
  return c;
}

}  // namespace blysk
