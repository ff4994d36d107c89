// Tubes around closed curves: torus and trefoil knot.
#include <algorithm>
#include <utility>

#include "scene/shapes_internal.h"

namespace blysk::shape {
namespace {

Scene make_torus(const Arguments& arguments) {
  const int around = arguments.whole("detail"), across = std::max(3, around / 2);
  const double ratio = arguments.real("ratio"), ring = 1 / (1 + ratio), tube = ratio * ring;
  const std::vector<Turn> circle = full_circle(around);
  Mesh mesh;
  add_sheet(mesh, {.columns = around, .rows = across}, [&](int row, int column, Vec2f texcoord) {
    const Turn& c = circle[static_cast<std::size_t>(column)];
    const Turn t =
        turn(3 * std::int64_t{across} - 2 * row, 2 * std::int64_t{across});  // from the inside over the top
    const Vec3d out{-c.sine, 0, -c.cosine};
    const Vec3d normal = out * t.cosine + Vec3d{0, t.sine, 0};
    return Vertex{to_float(out * ring + normal * tube), to_float(normal), texcoord};
  });
  return scene_of(std::move(mesh), "torus", solid_material());
}

// A point of the (2, 3) torus knot on a ring of radius 2 and a tube of radius 1, with its Frenet frame.
struct KnotPoint {
  Vec3d at, normal, binormal;
};

KnotPoint knot_point(int part, int parts) {
  const Turn a = turn(2 * std::int64_t{part}, parts), b = turn(3 * std::int64_t{part}, parts);
  const double r = 2 + b.cosine, r1 = -3 * b.sine, r2 = -9 * b.cosine;
  const Vec3d first{r1 * a.cosine - 2 * r * a.sine, r1 * a.sine + 2 * r * a.cosine, 3 * b.cosine};
  const Vec3d second{(r2 - 4 * r) * a.cosine - 4 * r1 * a.sine, (r2 - 4 * r) * a.sine + 4 * r1 * a.cosine,
                     -9 * b.sine};
  const Vec3d tangent = normalize(first), binormal = normalize(cross(first, second));
  return {{r * a.cosine, r * a.sine, b.sine}, cross(binormal, tangent), binormal};
}

Scene make_trefoil(const Arguments& arguments) {
  const int along = arguments.whole("detail"), around = std::max(3, along / 8);
  const double tube = arguments.real("tube"), scale = 1 / (3 + tube);
  std::vector<KnotPoint> knot;
  for (int part = 0; part <= along; ++part) knot.push_back(knot_point(part % along, along));
  const std::vector<Turn> circle = full_circle(around);
  Mesh mesh;
  add_sheet(mesh, {.columns = along, .rows = around}, [&](int row, int column, Vec2f texcoord) {
    const KnotPoint& k = knot[static_cast<std::size_t>(column)];
    const Turn& t = circle[static_cast<std::size_t>(row)];
    const Vec3d normal = k.normal * t.cosine + k.binormal * t.sine;
    return Vertex{to_float((k.at + normal * tube) * scale), to_float(normal), texcoord};
  });
  return scene_of(std::move(mesh), "trefoil", solid_material());
}

}  // namespace

Entry torus() {
  return {{"torus",
           "lying ring of outer radius 1",
           {{"detail", 3, 7000, 48, "segments around the ring, half as many (at least 3) around the tube"},
            {"ratio", 0.01, 0.99, 0.4, "radius of the tube over radius of the ring", false}}},
          make_torus};
}

Entry trefoil() {
  return {{"trefoil",
           "tube knotted into a trefoil around the Z axis, radius 1",
           {{"detail", 24, 14000, 256, "segments along the tube, an eighth as many (at least 3) around it"},
            {"tube", 0.05, 0.7, 0.45, "radius of the tube where the knot winds on a torus of radii 2 and 1",
             false}}},
          make_trefoil};
}

}  // namespace blysk::shape
