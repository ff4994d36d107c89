// blysk/scene.h - what is drawn: meshes, materials, lights, cameras, and where they stand.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "blysk/array.h"
#include "blysk/vector.h"

namespace blysk {

/// Triangles with attributes at their vertices, in the mesh's own coordinates.
struct Mesh {
  std::string name;
  Array<Vec3f> positions;   ///< finite
  Array<Vec3f> normals;     ///< one per position, unit; empty: every face has its own normal
  Array<Vec4f> colors;      ///< one per position, linear RGBA 0..1; empty: none
  Array<Vec2f> texcoords;   ///< one per position; empty: none
  Array<Vec2f> texcoords1;  ///< second set (glTF TEXCOORD_1); empty: none
  Array<Vec4f> tangents;    ///< one per position, w is the sign of the bitangent; empty: none
  Array<std::uint32_t>
      indices;  ///< three per triangle, counter-clockwise from the front; each < positions.size()

  [[nodiscard]] std::size_t triangles() const { return indices.size() / 3; }
};

/// An image that a material refers to. Read by a later version; readers keep what the file says.
struct TextureReference {
  std::string uri;            ///< path as the file gives it; empty: embedded
  Array<std::uint8_t> bytes;  ///< an embedded image file (PNG, JPEG)
  std::string mime_type;      ///< of `bytes`, where the file says it
  std::string name;
};

enum class AlphaMode { opaque, mask, blend };

/// How a surface answers light. Colours are linear, 0..1.
struct Material {
  static constexpr int kNoTexture = -1;

  std::string name;
  Vec3f color{0.6f, 0.6f, 0.6f};     ///< diffuse and ambient reflectance (ka, kd)
  Vec3f specular{0.2f, 0.2f, 0.2f};  ///< ks
  float shininess = 32;              ///< exponent of the lobe, 1..1000
  Vec3f emission{0, 0, 0};           ///< added light, independent of lamps
  float opacity = 1;                 ///< 0 clear, 1 opaque; of AlphaMode::mask and blend
  AlphaMode alpha_mode = AlphaMode::opaque;
  float alpha_cutoff = 0.5f;        ///< for AlphaMode::mask
  bool double_sided = true;         ///< false: back faces are culled when Cull::material is asked for
  bool unlit = false;               ///< show `color` (and vertex colours) without light
  int color_texture = kNoTexture;   ///< index into Scene::textures
  int normal_texture = kNoTexture;  ///< likewise
};

/// A lamp. `color` may exceed 1; it is intensity times colour.
struct Light {
  enum class Kind { directional, point };
  Kind kind = Kind::directional;
  Vec3d vector{0, 0, 1};  ///< directional: towards the light; point: its position (world)
  Vec3f color{1, 1, 1};
  std::string name;
};

/// A camera looking from `eye` to `target`.
struct Camera {
  Vec3d eye{0, 0, 5};
  Vec3d target{0, 0, 0};
  Vec3d up{0, 1, 0};
  double fov_deg = 30;       ///< vertical field of view, 1..170; unused when orthographic
  double height = 0;         ///< > 0: orthographic, world height of the picture
  double near_distance = 0;  ///< 0: from the scene's bounds
  double far_distance = 0;   ///< 0: from the scene's bounds
  std::string name;
};

/// A mesh at a place.
struct Instance {
  std::uint32_t mesh = 0;      ///< index into Scene::meshes
  std::uint32_t material = 0;  ///< index into Scene::materials
  Mat4 transform;              ///< mesh to world; affine
  std::string name;
};

/// Everything a picture is made of. Plain data: build it by hand or with load_model().
struct Scene {
  std::vector<Mesh> meshes;
  std::vector<Material> materials;  ///< never empty once an instance exists
  std::vector<TextureReference> textures;
  std::vector<Instance> instances;
  std::vector<Light> lights;  ///< of the file; none: the renderer's default key light
  std::vector<Camera> cameras;
  std::vector<std::string> problems;  ///< what a reader had to leave out or mend, one sentence each

  /// Appends a mesh with its own material and one instance of it.
  void add(Mesh mesh, Material material = {}, const Mat4& transform = {});
  /// Appends everything of another scene.
  void append(Scene other);

  [[nodiscard]] Bounds bounds() const;            ///< of all instances, world space
  [[nodiscard]] std::uint64_t triangles() const;  ///< as drawn: instances counted each
};

/// Area-weighted vertex normals. Vertices whose faces differ by more than `crease_deg` are split, so
/// hard edges stay hard; 180 never splits, 0 leaves the mesh without normals (every face its own).
/// Vertices at the same position count as one, so that a seam in the texture coordinates does not show.
void make_normals(Mesh& mesh, double crease_deg);

}  // namespace blysk
