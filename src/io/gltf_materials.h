// io/gltf_materials.h - materials and the images they refer to.
#pragma once

#include "io/gltf_buffers.h"
#include "io/gltf_context.h"

namespace blysk::io::gltf {

/// Appends all materials of the document, and the images that they use, to the scene.
void read_materials(Context& context, Json root, Buffers& buffers, Scene& scene);

/// The material of primitives that name none: white, rough metal by the specification.
[[nodiscard]] Material default_material();

}  // namespace blysk::io::gltf
