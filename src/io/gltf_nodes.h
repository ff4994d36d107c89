// io/gltf_nodes.h - the tree of nodes: what stands where.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "io/gltf_context.h"

namespace blysk::io::gltf {

/// Numbers of the things that nodes refer to.
struct NodeTargets {
  std::size_t meshes = 0, cameras = 0, lights = 0;
};

/// A node of the scene that holds something.
struct Placement {
  Json json;
  std::string_view name;
  Mat4 world;
  Mat4 mesh_to_world;  ///< as `world`, unless a skin says otherwise
  int mesh = kNone, camera = kNone, light = kNone;
};

struct NodePlaces {
  std::vector<Placement> placements;
  std::vector<std::optional<Mat4>> worlds;  ///< by node; unset outside the scene
};

/// The nodes of the default scene, or of scene 0, or without scenes all of them, parents before children, in
/// the order of the file. Nodes with two parents and nodes among their own ancestors fail.
[[nodiscard]] NodePlaces place_nodes(Context& context, Json root, const NodeTargets& targets);

/// Finite and so small that products with positions stay so.
[[nodiscard]] bool usable(const Mat4& matrix);

}  // namespace blysk::io::gltf
