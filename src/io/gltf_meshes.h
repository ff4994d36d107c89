// io/gltf_meshes.h - primitives: triangle lists, strips and fans with their attributes.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "io/gltf_accessor.h"
#include "io/gltf_context.h"

namespace blysk::io::gltf {

enum class Mode : std::uint8_t {
  points,
  lines,
  line_loop,
  line_strip,
  triangles,
  triangle_strip,
  triangle_fan
};

/// The accessors that make a primitive's geometry; kNone where there is none.
struct Geometry {
  Mode mode = Mode::triangles;
  int indices = kNone;
  int position = kNone, normal = kNone, tangent = kNone, color = kNone, texcoord0 = kNone, texcoord1 = kNone;

  friend auto operator<=>(const Geometry&, const Geometry&) = default;
};

struct Primitive {
  Json json;
  std::string name;  ///< of the mesh; "meshes[2].primitives[0]" where that has none
  Geometry geometry;
  int material = kNone;
  std::uint64_t triangles = 0;  ///< before bad ones are left out
};

/// The document's meshes, read when a node first asks for them.
class Meshes {
 public:
  Meshes(Context& context, Json root, Accessors& accessors);

  [[nodiscard]] std::size_t size() const { return meshes_.size(); }
  /// Primitives that consist of triangles.
  [[nodiscard]] const std::vector<Primitive>& primitives(int mesh);
  /// Index in `to` of the primitive's geometry, which is read if it is not there yet: primitives
  /// of one geometry share it whatever their material.
  [[nodiscard]] std::uint32_t geometry(const Primitive& primitive, std::vector<Mesh>& to);
  /// Says what was no triangles.
  void report();

 private:
  struct Entry {
    Json json;
    bool read = false;
    std::vector<Primitive> primitives;
  };

  void read_primitive(Entry& entry, Json json, std::string name);
  void read_geometry(Json primitive, Json attributes, Geometry& geometry);
  [[nodiscard]] int attribute(Json attributes, std::string_view name, std::initializer_list<Shape> shapes);
  [[nodiscard]] Mesh build(const Primitive& primitive);
  void read_indices(const Primitive& primitive, Array<std::uint32_t>& indices);
  void read_attributes(const Primitive& primitive, std::uint64_t first, std::uint64_t count, Mesh& mesh);

  Context& context_;
  Accessors& accessors_;
  std::size_t materials_;
  std::vector<Entry> meshes_;
  std::map<Geometry, std::uint32_t> built_;
  std::uint64_t points_ = 0, lines_ = 0, without_positions_ = 0;  // primitives left out
};

}  // namespace blysk::io::gltf
