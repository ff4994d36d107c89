#include "io/gltf_skins.h"

#include <array>
#include <optional>
#include <vector>

namespace blysk::io::gltf {
namespace {

Mat4 first_inverse_bind_matrix(Context& context, Json skin, Accessors& accessors) {
  Mat4 matrix;
  const Json json = skin["inverseBindMatrices"];
  const int index = context.index(json, accessors.size(), "accessor");
  if (index == kNone) return matrix;
  const Accessor& accessor = accessors[index];
  if (accessor.elements.shape != Shape::mat4 || accessor.elements.component != Component::f32 ||
      accessor.count == 0) {
    context.fail(json, "accessor " + std::to_string(index) + " must hold MAT4 of type 5126");
    return matrix;
  }
  std::array<float, 16> columns{};
  accessors.check(index);
  if (!context.failed()) accessors.read(index, Target<float>{columns.data(), 0, 1, 16});
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 4; ++column) {
      matrix.m[row][column] = static_cast<double>(columns[column * 4 + row]);
    }
  }
  return matrix;
}

// From the mesh's coordinates to the world's; unset where the skeleton is not part of the scene.
std::optional<Mat4> skin_transform(Context& context, Json skin, Accessors& accessors,
                                   const NodePlaces& places) {
  const std::vector<Json> joints = context.list(skin, "joints");
  if (joints.empty()) return std::nullopt;
  const int joint = context.index(joints[0], places.worlds.size(), "node");
  if (joint == kNone || !places.worlds[static_cast<std::size_t>(joint)]) return std::nullopt;
  const Mat4 inverse = first_inverse_bind_matrix(context, skin, accessors);
  return *places.worlds[static_cast<std::size_t>(joint)] * inverse;
}

}  // namespace

void place_skinned_meshes(Context& context, Json root, Accessors& accessors, NodePlaces& places) {
  if (context.failed()) return;
  const std::vector<Json> skins = context.list(root, "skins");
  std::vector<std::optional<Mat4>> transforms;
  for (const Json& skin : skins) {
    transforms.push_back(skin_transform(context, skin, accessors, places));
    if (context.failed()) return;
  }
  for (Placement& placement : places.placements) {
    if (placement.mesh == kNone) continue;
    const int skin = context.index(placement.json, "skin", skins.size(), "skin");
    if (skin == kNone || !transforms[static_cast<std::size_t>(skin)]) continue;
    placement.mesh_to_world = *transforms[static_cast<std::size_t>(skin)];
    if (!usable(placement.mesh_to_world)) {
      return context.fail(skins[static_cast<std::size_t>(skin)],
                          "its transform is not finite, or has elements beyond 1e30");
    }
  }
}

}  // namespace blysk::io::gltf
