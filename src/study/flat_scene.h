// study/flat_scene.h - a scene as flat-coloured triangles on the screen.
#pragma once

#include <vector>

#include "blysk/result.h"
#include "blysk/scene.h"
#include "study/flat_raster.h"

namespace blysk::study {

/// The scene's first camera, else one that frames it from an oblique side.
[[nodiscard]] Camera study_camera(const Scene& scene, int width, int height);

/// A triangle has the colour
/// of its first corner, else its material's, shaded by how squarely it faces a fixed lamp; unlit materials
/// keep theirs. Triangles that the near or far plane would cut are left out, those beside the picture too.
/// Triangles that hang together have one object number.
[[nodiscard]] Result<std::vector<FlatTriangle>> flat_triangles(const Scene& scene, const Camera& camera,
                                                               int width, int height);

}  // namespace blysk::study
