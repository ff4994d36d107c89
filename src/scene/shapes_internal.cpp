#include "scene/shapes_internal.h"

#include <string>
#include <utility>

#include "math/trig.h"

namespace blysk::shape {

Scene scene_of(Mesh mesh, std::string_view name, Material material) {
  Scene scene;
  mesh.name = std::string(name);
  scene.add(std::move(mesh), std::move(material));
  return scene;
}

Material solid_material() {
  Material material;
  material.double_sided = false;
  return material;
}

Turn turn(std::int64_t part, std::int64_t parts) {
  const std::int64_t quarters = 4 * (part % parts);
  const double angle = static_cast<double>(quarters % parts) * (kPi / 2) / static_cast<double>(parts);
  const double c = cosine(angle), s = sine(angle);
  switch (quarters / parts) {
    case 0:
      return {c, s};
    case 1:
      return {-s, c};
    case 2:
      return {-c, -s};
    default:
      return {s, -c};
  }
}

std::vector<Turn> full_circle(int parts) {
  std::vector<Turn> circle;
  circle.reserve(static_cast<std::size_t>(parts) + 1);
  for (int part = 0; part <= parts; ++part) circle.push_back(turn(part, parts));
  return circle;
}

std::size_t Sheet::vertices() const {
  const std::size_t all = (static_cast<std::size_t>(columns) + 1) * (static_cast<std::size_t>(rows) + 1);
  return all - (pole_first ? 1 : 0) - (pole_last ? 1 : 0);
}

std::size_t Sheet::triangles() const {
  const std::size_t cells = static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
  const auto ends = static_cast<std::size_t>((pole_first ? 1 : 0) + (pole_last ? 1 : 0));
  return 2 * cells - ends * static_cast<std::size_t>(columns);
}

void write_indices(const Sheet& sheet, std::uint32_t first, std::uint32_t* to) {
  const auto columns = static_cast<std::uint32_t>(sheet.columns);
  const auto triangle = [&to](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    *to++ = a;
    *to++ = b;
    *to++ = c;
  };
  std::uint32_t upper = first;
  for (int row = 0; row < sheet.rows; ++row) {
    const bool top = sheet.pole(row), bottom = sheet.pole(row + 1);
    const std::uint32_t lower = upper + columns + (top ? 0 : 1);
    for (std::uint32_t c = 0; c < columns; ++c) {
      if (!bottom) triangle(upper + c, lower + c, lower + c + 1);
      if (!top) triangle(upper + c, bottom ? lower + c : lower + c + 1, upper + c + 1);
    }
    upper = lower;
  }
}

}  // namespace blysk::shape
