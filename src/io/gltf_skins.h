// io/gltf_skins.h - where skinned meshes stand.
#pragma once

#include "io/gltf_accessor.h"
#include "io/gltf_context.h"
#include "io/gltf_nodes.h"

namespace blysk::io::gltf {

/// Moves skinned meshes to where their skin's first joint carries them: the transform of their own node does
/// not count by the specification. That is exact for models that stand as they were bound to their skeleton;
/// limbs that the file poses otherwise keep the pose of the binding.
void place_skinned_meshes(Context& context, Json root, Accessors& accessors, NodePlaces& places);

}  // namespace blysk::io::gltf
