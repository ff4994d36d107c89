// Scenes that other renderers' benchmark programs draw too, described so that the same pixels are covered.
//
//   quad             two triangles over the whole picture
//   sphere:N         a bumpy sphere of about N triangles
//   tris:AREA:DEPTH  DEPTH layers over the whole picture of right triangles of AREA pixels, the nearest layer
//                    first; with :b2f at the end the farthest first
//   anything else    a model file, its normals area-weighted and smooth everywhere if it has none
#pragma once

#include <string>

#include "blysk/render.h"

namespace blysk::bench {

struct Stage {
  Scene scene;             ///< one material, no lights
  bool on_screen = false;  ///< laid out in pixels: the camera stands still
  Vec3d center;            ///< of the bounding box
  double radius = 0;       ///< largest distance of a vertex from `center`
};

/// `width` and `height` are those of the picture, for scenes that are laid out in pixels.
[[nodiscard]] Result<Stage> make_stage(const std::string& name, int width, int height);

/// Camera and light of one frame: 30 degrees of view, the bounding sphere fits the height, seen from 15
/// degrees above, `turn` of the way round (0..1) from 0.5 rad.
void aim(const Stage& stage, double turn, RenderOptions& options);

/// What all frames share: two-sided Phong shading with Blinn's lobe, nothing culled, no transfer function.
[[nodiscard]] RenderOptions frame_options(int width, int height);
/// Both, for the first frame.
[[nodiscard]] RenderOptions aimed_options(const Stage& stage, int width, int height);

}  // namespace blysk::bench
