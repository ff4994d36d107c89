// io/gltf_cameras.h - cameras and lamps that nodes hold.
#pragma once

#include <vector>

#include "io/gltf_context.h"
#include "io/gltf_nodes.h"

namespace blysk::io::gltf {

/// The lamps of KHR_lights_punctual.
[[nodiscard]] std::vector<Json> light_list(Context& context, Json root);

/// Appends the cameras of the placements to the scene.
void add_cameras(Context& context, Json root, const std::vector<Placement>& placements, Scene& scene);

/// Appends their lamps; needs the scene's instances, whose place decides how bright a point light is.
void add_lights(Context& context, Json root, const std::vector<Placement>& placements, Scene& scene);

}  // namespace blysk::io::gltf
