// io/ply_vertices.h - which property of a PLY vertex goes where in a mesh.
#pragma once

#include <cstddef>
#include <vector>

#include "blysk/scene.h"
#include "core/threads.h"
#include "io/ply_header.h"

namespace blysk::io {

/// Which of r, g, b, a (0..3) a property of this name is; -1: none.
[[nodiscard]] int ply_color_channel(std::string_view name);

/// A channel of a colour as files have it, an sRGB value of the type's range, as linear light 0..1. Alpha is
/// not bent.
[[nodiscard]] float ply_color(int channel, PlyType type, double value);

class PlyVertices {
 public:
  /// Finds the attributes. Memory is taken by allocate().
  explicit PlyVertices(const PlyElement& element);

  [[nodiscard]] bool has_positions() const { return has(Attribute::position, 3); }
  [[nodiscard]] bool has_colors() const { return has(Attribute::color, 3); }
  [[nodiscard]] std::uint64_t bytes_per_vertex() const;
  void allocate(Mesh& mesh);

  /// Stores a value of property number `property` of a vertex.
  void store(std::size_t vertex, std::size_t property, double value) const;

  /// Stores all vertices from rows without lists, `row_bytes` each.
  void store_rows(const std::byte* rows, std::size_t row_bytes, PlyFormat format, ThreadPool& pool) const;

 private:
  enum class Attribute { none, position, normal, color, texcoord };

  struct Column {
    Attribute attribute = Attribute::none;
    int component = 0;
    PlyType type = PlyType::float32;
    std::size_t offset = 0;  // in a row without lists
    float* first = nullptr;
    std::size_t step = 0;  // floats from vertex to vertex
  };

  static Column find_column(const PlyProperty& property);
  [[nodiscard]] bool has(Attribute attribute, int components) const;
  template <class T, bool kSwap>
  static void store_block(const Column& column, const std::byte* rows, std::size_t row_bytes,
                          std::size_t begin, std::size_t end);

  std::size_t count_;
  std::vector<Column> columns_;  // one per property
};

}  // namespace blysk::io
