// Shapes with flat faces and hard edges: cube, plane, cylinder.
#include <utility>

#include "scene/shapes_internal.h"

namespace blysk::shape {
namespace {

// From -1 to 1 in n steps; exactly antisymmetric, so that edges meet whichever end they are counted from.
double across(int step, int n) { return static_cast<double>(2 * step - n) / n; }

// A square of side 2 at `front` from the origin; right x up = front.
void add_square(Mesh& mesh, int detail, Vec3d front, Vec3d right, Vec3d up) {
  add_sheet(mesh, {.columns = detail, .rows = detail}, [&](int row, int column, Vec2f texcoord) {
    const Vec3d at = front + right * across(column, detail) + up * across(detail - row, detail);
    return Vertex{to_float(at), to_float(front), texcoord};
  });
}

Scene make_cube(const Arguments& arguments) {
  const int detail = arguments.whole("detail");
  constexpr Vec3d kX{1, 0, 0}, kY{0, 1, 0}, kZ{0, 0, 1};
  Mesh mesh;
  add_square(mesh, detail, kX, -kZ, kY);
  add_square(mesh, detail, -kX, kZ, kY);
  add_square(mesh, detail, kY, kX, -kZ);
  add_square(mesh, detail, -kY, kX, kZ);
  add_square(mesh, detail, kZ, kX, kY);
  add_square(mesh, detail, -kZ, -kX, kY);
  return scene_of(std::move(mesh), "cube", solid_material());
}

Scene make_plane(const Arguments& arguments) {
  const int detail = arguments.whole("detail");
  Mesh mesh;
  add_sheet(mesh, {.columns = detail, .rows = detail}, [&](int row, int column, Vec2f texcoord) {
    return Vertex{to_float({across(column, detail), 0, across(row, detail)}), {0, 1, 0}, texcoord};
  });
  return scene_of(std::move(mesh), "plane");
}

Scene make_cylinder(const Arguments& arguments) {
  const int detail = arguments.whole("detail");
  const std::vector<Turn> circle = full_circle(detail);
  const auto outward = [&](int column) {
    const Turn& t = circle[static_cast<std::size_t>(column)];
    return to_float({-t.sine, 0, -t.cosine});  // the seam is behind
  };
  Mesh mesh;
  add_sheet(mesh, {.columns = detail, .rows = 1}, [&](int row, int column, Vec2f texcoord) {
    const Vec3f out = outward(column);
    return Vertex{{out.x, row == 0 ? 1.0f : -1.0f, out.z}, out, texcoord};
  });
  const auto add_cap = [&](const Sheet& sheet, float side) {
    add_sheet(mesh, sheet, [&](int row, int column, Vec2f) {
      const Vec3f out = sheet.pole(row) ? Vec3f{0, 0, 0} : outward(column);
      return Vertex{{out.x, side, out.z}, {0, side, 0}, {(1 + out.x) / 2, (1 - side * out.z) / 2}};
    });
  };
  add_cap({.columns = detail, .rows = 1, .pole_first = true}, 1);
  add_cap({.columns = detail, .rows = 1, .pole_last = true}, -1);
  return scene_of(std::move(mesh), "cylinder", solid_material());
}

}  // namespace

Entry cube() {
  return {{"cube",
           "cube of side 2 with hard edges, each face the whole texture",
           {{"detail", 1, 2000, 1, "segments along each edge"}}},
          make_cube};
}

Entry plane() {
  return {{"plane",
           "square of side 2 in the XZ plane, facing +Y",
           {{"detail", 1, 5000, 1, "segments along each side"}}},
          make_plane};
}

Entry cylinder() {
  return {{"cylinder",
           "upright cylinder of radius 1 and height 2, closed by caps with hard rims",
           {{"detail", 3, 1'000'000, 32, "segments around"}}},
          make_cylinder};
}

}  // namespace blysk::shape
