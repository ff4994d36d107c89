// The Utah teapot, by its 32 published Bezier patches.
//
// Based on: Newell. The Utilization of Procedure Models in Digital Image Synthesis. 1975; its bottom is Frank
// Crow's, 1987. Differs in: the control points are written as what they are, rings of a body of revolution
// and sections of two tubes that are their own mirror images. Each part is one smooth sheet.
#include <array>
#include <span>
#include <utility>

#include "scene/shapes_internal.h"

namespace blysk::shape {
namespace {

// Four quarter patches: the ring meets the axes at `radius`; the control points beside lie `arm` aside.
struct Ring {
  double radius, arm, height;
};

constexpr Ring kPot[] = {{1.4, 0.784, 2.4}, {1.3375, 0.749, 2.53125}, {1.4375, 0.805, 2.53125},  // rim
                         {1.5, 0.84, 2.4},  {1.75, 0.98, 1.875},      {2.0, 1.12, 1.35},   // body, upper
                         {2.0, 1.12, 0.9},  {2.0, 1.12, 0.45},        {1.5, 0.84, 0.225},  // body, lower
                         {1.5, 0.84, 0.15}, {1.5, 0.84, 0.075},       {1.425, 0.798, 0.0},
                         {0.0, 0.0, 0.0}};  // bottom

constexpr Ring kLid[] = {{0.0, 0.0, 3.15},  {0.8, 0.45, 3.15},  {0.0, 0.0, 2.85},  // knob
                         {0.2, 0.112, 2.7}, {0.4, 0.224, 2.55}, {1.3, 0.728, 2.55},
                         {1.3, 0.728, 2.4}};  // lid

// Two half patches: they meet at (x0, height0) and (x1, height1) and reach `reach` to either side.
struct Section {
  double x0, height0, x1, height1, reach;
};

constexpr Section kHandle[] = {{-1.6, 2.025, -1.5, 2.25, 0.3}, {-2.3, 2.025, -2.5, 2.25, 0.3},
                               {-2.7, 2.025, -3.0, 2.25, 0.3}, {-2.7, 1.8, -3.0, 1.8, 0.3},
                               {-2.7, 1.575, -3.0, 1.35, 0.3}, {-2.5, 1.125, -2.65, 0.9375, 0.3},
                               {-2.0, 0.9, -1.9, 0.6, 0.3}};

constexpr Section kSpout[] = {{1.7, 1.425, 1.7, 0.6, 0.66},       {2.6, 1.425, 3.1, 0.825, 0.66},
                              {2.3, 2.1, 2.4, 2.025, 0.25},       {2.7, 2.4, 3.3, 2.4, 0.25},
                              {2.8, 2.475, 3.525, 2.49375, 0.25}, {2.9, 2.475, 3.45, 2.5125, 0.15},
                              {2.8, 2.4, 3.2, 2.4, 0.15}};

// The cubic Bernstein polynomials at one parameter, and their derivatives.
struct Bernstein {
  double value[4], slope[4];

  explicit Bernstein(double t) {
    const double s = 1 - t;
    const double values[4] = {s * s * s, 3 * t * s * s, 3 * t * t * s, t * t * t};
    const double slopes[4] = {-3 * s * s, 3 * s * (s - 2 * t), 3 * t * (2 * s - t), 3 * t * t};
    for (int i = 0; i < 4; ++i) {
      value[i] = values[i];
      slope[i] = slopes[i];
    }
  }
};

std::vector<Bernstein> bernstein_table(int detail) {
  std::vector<Bernstein> table;
  for (int i = 0; i <= detail; ++i) table.emplace_back(static_cast<double>(i) / detail);
  return table;
}

// A number that runs along the rows of patches, and how it changes.
struct Along {
  double value, slope;
};

template <class Control>
Along along(std::span<const Control> controls, double Control::*field, const std::vector<Bernstein>& table,
            int row) {
  const int detail = static_cast<int>(table.size()) - 1;
  const int patches = static_cast<int>(controls.size() - 1) / 3;
  const int patch = row / detail < patches ? row / detail : patches - 1;
  const Bernstein& b = table[static_cast<std::size_t>(row - patch * detail)];
  Along sum{0, 0};
  for (int i = 0; i < 4; ++i) {
    const double control = controls[static_cast<std::size_t>(3 * patch + i)].*field;
    sum.value += control * b.value[i];
    sum.slope += control * b.slope[i];
  }
  return sum;
}

// Half size, so that the body has radius 1; the middle of its height comes to the origin.
Vertex vertex(Vec3d at, Vec3d normal, Vec2f texcoord) {
  return {to_float({at.x * 0.5, (at.y - 1.575) * 0.5, at.z * 0.5}), to_float(normal), texcoord};
}

void add_turned(Mesh& mesh, std::span<const Ring> rings, const Sheet& sheet,
                const std::vector<Bernstein>& table) {
  const int detail = static_cast<int>(table.size()) - 1;
  struct Row {
    Along radius, arm, height;
  };
  std::vector<Row> rows;
  for (int row = 0; row <= sheet.rows; ++row) {
    rows.push_back({along(rings, &Ring::radius, table, row), along(rings, &Ring::arm, table, row),
                    along(rings, &Ring::height, table, row)});
  }
  constexpr Vec3d kAxes[] = {{0, 0, -1}, {-1, 0, 0}, {0, 0, 1}, {1, 0, 0}};  // the seam is behind
  add_sheet(mesh, sheet, [&](int row, int column, Vec2f texcoord) {
    const auto& [radius, arm, height] = rows[static_cast<std::size_t>(row)];
    // All tangents at a pole are level: the knob's and the bottom's control points lie in a plane.
    if (sheet.pole(row)) return vertex({0, height.value, 0}, {0, row == 0 ? 1.0 : -1.0, 0}, texcoord);
    const Bernstein& b = table[static_cast<std::size_t>(column % detail)];
    const Vec3d axis = kAxes[column / detail % 4], next = kAxes[(column / detail + 1) % 4];
    const auto point = [&](const double(&w)[4], double r, double a, double h) {
      return axis * (r * (w[0] + w[1]) + a * w[2]) + next * (a * w[1] + r * (w[2] + w[3])) + Vec3d{0, h, 0};
    };
    const Vec3d across = point(b.slope, radius.value, arm.value, 0);
    const Vec3d down = point(b.value, radius.slope, arm.slope, height.slope);
    const Vec3d at = point(b.value, radius.value, arm.value, height.value);
    return vertex(at, normalize(cross(down, across)), texcoord);
  });
}

void add_tube(Mesh& mesh, std::span<const Section> sections, const std::vector<Bernstein>& table) {
  const int detail = static_cast<int>(table.size()) - 1;
  struct Row {
    Along x0, height0, x1, height1, reach;
  };
  std::vector<Row> rows;
  for (int row = 0; row <= 2 * detail; ++row) {
    rows.push_back({along(sections, &Section::x0, table, row), along(sections, &Section::height0, table, row),
                    along(sections, &Section::x1, table, row), along(sections, &Section::height1, table, row),
                    along(sections, &Section::reach, table, row)});
  }
  add_sheet(mesh, {.columns = 2 * detail, .rows = 2 * detail}, [&](int row, int column, Vec2f texcoord) {
    const Row& r = rows[static_cast<std::size_t>(row)];
    const double side = column <= detail ? -1 : 1;  // there behind the mirror plane, back before it
    const Bernstein& b = table[static_cast<std::size_t>(column <= detail ? column : 2 * detail - column)];
    const auto point = [&](const double(&w)[4], double Along::*part) {
      const double from = w[0] + w[1], to = w[2] + w[3];
      return Vec3d{r.x0.*part * from + r.x1.*part * to, r.height0.*part * from + r.height1.*part * to,
                   side * (r.reach.*part * (w[1] + w[2]))};
    };
    const Vec3d across = point(b.slope, &Along::value) * -side;
    const Vec3d down = point(b.value, &Along::slope);
    return vertex(point(b.value, &Along::value), normalize(cross(down, across)), texcoord);
  });
}

Scene make_teapot(const Arguments& arguments) {
  const int detail = arguments.whole("detail");
  const std::vector<Bernstein> table = bernstein_table(detail);
  Mesh mesh;
  add_turned(mesh, kPot, {.columns = 4 * detail, .rows = 4 * detail, .pole_last = true}, table);
  add_turned(mesh, kLid, {.columns = 4 * detail, .rows = 2 * detail, .pole_first = true}, table);
  add_tube(mesh, kHandle, table);
  add_tube(mesh, kSpout, table);
  return scene_of(std::move(mesh), "teapot");
}

}  // namespace

Entry teapot() {
  return {{"teapot",
           "Newell's teapot of 32 Bezier patches, its body of radius 1; open under the lid and at the spout",
           {{"detail", 1, 256, 8, "segments along each side of a patch; 1 leaves handle and spout flat"}}},
          make_teapot};
}

}  // namespace blysk::shape
