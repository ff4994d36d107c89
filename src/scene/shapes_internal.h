// scene/shapes_internal.h - what the files of the built-in shapes share.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "blysk/scene.h"
#include "blysk/shapes.h"

namespace blysk::shape {

/// The values of a shape's parameters, all inside their ranges.
class Arguments {
 public:
  explicit Arguments(const ShapeInfo& info);

  void set(std::size_t parameter, double value) { values_[parameter] = value; }
  [[nodiscard]] double real(std::string_view name) const;
  [[nodiscard]] int whole(std::string_view name) const { return static_cast<int>(real(name)); }

 private:
  std::span<const ShapeParameter> parameters_;
  std::vector<double> values_;
};

/// A row of the table of shapes.
struct Entry {
  ShapeInfo info;
  Scene (*make)(const Arguments& arguments);
};

Entry teapot();
Entry sphere();
Entry icosphere();
Entry torus();
Entry cube();
Entry cylinder();
Entry plane();
Entry trefoil();
Entry terrain();
Entry xfighter();
Entry triangles();
Entry spheres();
Entry soup();
Entry micro();
Entry meshes();
Entry grass();
Entry fans();

/// A scene of one mesh, which takes the shape's name.
[[nodiscard]] Scene scene_of(Mesh mesh, std::string_view name, Material material = {});
/// A material for solids, whose inside is never seen.
[[nodiscard]] Material solid_material();

/// Cosine and sine of part/parts of a full turn; exact at quarter turns.
struct Turn {
  double cosine, sine;
};
[[nodiscard]] Turn turn(std::int64_t part, std::int64_t parts);
/// turn(0, parts) ... turn(parts - 1, parts) and turn(0, parts) again.
[[nodiscard]] std::vector<Turn> full_circle(int parts);

struct Vertex {
  Vec3f position, normal;
  Vec2f texcoord;
};

/// A rectangle of cells, seen from the front: columns go right, rows go down. A row at a pole is one point,
/// with a vertex for the middle of each column.
struct Sheet {
  int columns, rows;
  bool pole_first = false, pole_last = false;

  [[nodiscard]] bool pole(int row) const { return (row == 0 && pole_first) || (row == rows && pole_last); }
  [[nodiscard]] std::size_t vertices() const;
  [[nodiscard]] std::size_t triangles() const;
};

/// Writes the sheet's triangles, whose vertices begin at `first`.
void write_indices(const Sheet& sheet, std::uint32_t first, std::uint32_t* to);

/// Appends a sheet; vertex(row, column, texcoord) gives its vertices.
template <class VertexOf>
void add_sheet(Mesh& mesh, const Sheet& sheet, const VertexOf& vertex) {
  const std::size_t first = mesh.positions.size(), first_index = mesh.indices.size();
  const std::size_t end = first + sheet.vertices();
  mesh.positions.resize(end);
  mesh.normals.resize(end);
  mesh.texcoords.resize(end);
  mesh.indices.resize(first_index + 3 * sheet.triangles());
  std::size_t at = first;
  for (int row = 0; row <= sheet.rows; ++row) {
    const bool pole = sheet.pole(row);
    const double v = 1 - static_cast<double>(row) / sheet.rows;
    for (int column = 0; column < sheet.columns + (pole ? 0 : 1); ++column, ++at) {
      const double u = (column + (pole ? 0.5 : 0.0)) / sheet.columns;
      const Vertex made = vertex(row, column, Vec2f{static_cast<float>(u), static_cast<float>(v)});
      mesh.positions[at] = made.position;
      mesh.normals[at] = made.normal;
      mesh.texcoords[at] = made.texcoord;
    }
  }
  write_indices(sheet, static_cast<std::uint32_t>(first), mesh.indices.data() + first_index);
}

}  // namespace blysk::shape
