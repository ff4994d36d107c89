// render/view.h - a camera as matrices: world to screen, pixel to ray.
#pragma once

#include "blysk/render.h"
#include "shading/shade.h"

namespace blysk {

struct ViewFrame {
  Vec3d right, up, forward;  ///< unit
  double near_distance, far_distance;
  Mat4 screen;  ///< world to homogeneous subpixels, nearness, w (w = 1 at the far plane or orthographic)
  ViewRays rays;
};

/// ErrorCode::usage if the camera has no direction or its numbers make no sense. The scene is only asked for
/// its bounds where the camera leaves its planes open.
[[nodiscard]] Result<ViewFrame> make_view(const Camera& camera, const Scene& scene, int width, int height);

}  // namespace blysk
