// A small fighter of four long thin crossing wings with hair-thin gun barrels: what antialiasing finds hard.
// Its nose points to +Z. Every part is closed by itself.
#include <array>
#include <span>
#include <string>
#include <utility>

#include "scene/shapes_internal.h"

namespace blysk::shape {
namespace {

// An ellipse across the Z axis, around the part's own axis raised by `lift`. Zero width is a tip.
struct Station {
  double z, half_width, half_height, lift;
};

struct Axis {
  double x, y;
};

void add_loft_end(Mesh& mesh, const Station& s, Axis axis, const std::vector<Turn>& circle, double facing) {
  const int sides = static_cast<int>(circle.size()) - 1;
  const Sheet sheet{.columns = sides, .rows = 1, .pole_first = facing > 0, .pole_last = facing < 0};
  add_sheet(mesh, sheet, [&](int row, int column, Vec2f texcoord) {
    const Turn t = sheet.pole(row) ? Turn{0, 0} : circle[static_cast<std::size_t>(column)];
    const Vec3d at{axis.x + s.half_width * t.cosine, axis.y + s.lift + s.half_height * t.sine, s.z};
    return Vertex{to_float(at), to_float({0, 0, facing}), texcoord};
  });
}

// A skin over stations from front (largest z) to back, with flat ends where there is no tip.
void add_loft(Mesh& mesh, std::span<const Station> stations, Axis axis, int sides) {
  const std::vector<Turn> circle = full_circle(sides);
  const int last = static_cast<int>(stations.size()) - 1;
  const bool tip_first = stations.front().half_width == 0, tip_last = stations.back().half_width == 0;
  const Sheet sheet{.columns = sides, .rows = last, .pole_first = tip_first, .pole_last = tip_last};
  add_sheet(mesh, sheet, [&](int row, int column, Vec2f texcoord) {
    const Station& s = stations[static_cast<std::size_t>(row)];
    const Vec3d middle{axis.x, axis.y + s.lift, s.z};
    if (sheet.pole(row)) return Vertex{to_float(middle), {0, 0, row == 0 ? 1.0f : -1.0f}, texcoord};
    const Station& before = stations[static_cast<std::size_t>(row == 0 ? 0 : row - 1)];
    const Station& after = stations[static_cast<std::size_t>(row == last ? last : row + 1)];
    const Turn& t = circle[static_cast<std::size_t>(column)];
    const Vec3d across{-s.half_width * t.sine, s.half_height * t.cosine, 0};
    const Vec3d down{(after.half_width - before.half_width) * t.cosine,
                     after.lift - before.lift + (after.half_height - before.half_height) * t.sine,
                     after.z - before.z};
    const Vec3d at = middle + Vec3d{s.half_width * t.cosine, s.half_height * t.sine, 0};
    return Vertex{to_float(at), to_float(normalize(cross(down, across))), texcoord};
  });
  if (!tip_first) add_loft_end(mesh, stations.front(), axis, circle, 1);
  if (!tip_last) add_loft_end(mesh, stations.back(), axis, circle, -1);
}

void add_rod(Mesh& mesh, Axis axis, double radius, double front, double back) {
  const Station stations[] = {{front, radius, radius, 0}, {back, radius, radius, 0}};
  add_loft(mesh, stations, axis, 8);
}

void add_quad(Mesh& mesh, const std::array<Vec3d, 4>& corners) {
  const Vec3f normal = to_float(normalize(cross(corners[1] - corners[0], corners[2] - corners[0])));
  constexpr Vec2f kCorners[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (std::size_t i = 0; i < 4; ++i) {
    mesh.positions.push_back(to_float(corners[i]));
    mesh.normals.push_back(normal);
    mesh.texcoords.push_back(kCorners[i]);
  }
  for (const std::uint32_t i : {0u, 1u, 2u, 0u, 2u, 3u}) mesh.indices.push_back(first + i);
}

// A flat plate that reaches away from the ship's axis: where it begins and ends, and its chord along Z there.
struct Plate {
  Vec3d out;         // unit, across Z
  double root, tip;  // distances along `out`
  double root_front, root_back, tip_front, tip_back;
  double thickness;
};

void add_plate(Mesh& mesh, const Plate& p) {
  const Vec3d side = cross(Vec3d{0, 0, 1}, p.out) * (p.thickness / 2);
  const auto corner = [&](double distance, double z, double face) {
    return p.out * distance + Vec3d{0, 0, z} + side * face;
  };
  const auto chord = [&](double face) {
    return std::array{corner(p.root, p.root_back, face), corner(p.root, p.root_front, face),
                      corner(p.tip, p.tip_front, face), corner(p.tip, p.tip_back, face)};
  };
  const std::array<Vec3d, 4> upper = chord(1), lower = chord(-1);
  add_quad(mesh, upper);
  add_quad(mesh, {lower[3], lower[2], lower[1], lower[0]});
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t next = (i + 1) % 4;
    add_quad(mesh, {lower[i], lower[next], upper[next], upper[i]});
  }
}

constexpr Station kHull[] = {{5.6, 0, 0, 0},           {5.5, 0.07, 0.06, 0},     {5.0, 0.15, 0.12, 0},
                             {3.6, 0.26, 0.2, 0.01},   {2.2, 0.38, 0.3, 0.02},   {1.0, 0.5, 0.4, 0.04},
                             {-0.6, 0.56, 0.46, 0.04}, {-2.2, 0.52, 0.44, 0.02}, {-3.2, 0.4, 0.34, 0},
                             {-3.4, 0.3, 0.26, 0}};
constexpr Station kCanopy[] = {{2.3, 0, 0, 0.26},       {2.15, 0.1, 0.09, 0.28}, {1.7, 0.21, 0.2, 0.34},
                               {1.1, 0.28, 0.27, 0.38}, {0.5, 0.26, 0.24, 0.4},  {0.05, 0.14, 0.12, 0.4},
                               {-0.1, 0, 0, 0.39}};
constexpr Station kDome[] = {{-1.0, 0, 0, 0.46},
                             {-1.07, 0.13, 0.13, 0.46},
                             {-1.25, 0.2, 0.2, 0.46},
                             {-1.43, 0.13, 0.13, 0.46},
                             {-1.5, 0, 0, 0.46}};
constexpr Station kEngine[] = {{0.1, 0.24, 0.24, 0},
                               {-0.2, 0.34, 0.34, 0},
                               {-1.6, 0.34, 0.34, 0},
                               {-3.0, 0.28, 0.28, 0},
                               {-3.3, 0.22, 0.22, 0}};
constexpr Station kGlow[] = {{-3.28, 0.18, 0.18, 0}, {-3.34, 0.18, 0.18, 0}};

constexpr double kSpread = 4.5;          // from the axis to a wing's tip
constexpr double kBarrelRadius = 0.012;  // under a pixel in most pictures

struct Part {
  Mesh mesh;
  Material material;
};

Part part(const char* name, Vec3f color, float specular, float shininess) {
  Part p;
  p.material = solid_material();
  p.material.name = name;
  p.material.color = color;
  p.material.specular = {specular, specular, specular};
  p.material.shininess = shininess;
  p.mesh.name = name;
  return p;
}

Scene make_xfighter(const Arguments&) {
  Part hull = part("hull", {0.56f, 0.57f, 0.54f}, 0.2f, 30),
       wing = part("wing", {0.42f, 0.45f, 0.5f}, 0.2f, 30);
  Part trim = part("trim", {0.05f, 0.2f, 0.45f}, 0.3f, 60),
       engine = part("engine", {0.1f, 0.11f, 0.14f}, 0.5f, 90);
  Part gun = part("gun", {0.2f, 0.2f, 0.22f}, 0.5f, 120), glow = part("glow", {0, 0, 0}, 0, 1);
  Part glass = part("glass", {0.04f, 0.07f, 0.1f}, 0.9f, 300);
  glow.material.emission = {1, 0.45f, 0.1f};
  glass.material.opacity = 0.5f;
  glass.material.alpha_mode = AlphaMode::blend;
  glass.material.double_sided = true;

  add_loft(hull.mesh, kHull, {0, 0}, 16);
  add_loft(trim.mesh, kDome, {0, 0}, 12);
  add_loft(glass.mesh, kCanopy, {0, 0}, 12);
  add_plate(trim.mesh, {{0, 1, 0}, 0.3, 1.25, -1.9, -3.3, -2.9, -3.5, 0.05});
  for (const double x : {1.0, -1.0}) {
    for (const double y : {1.0, -1.0}) {
      const Vec3d out = normalize(Vec3d{x, 0.28 * y, 0});
      const Vec3d tip = out * kSpread;
      add_plate(wing.mesh, {out, 0.2, kSpread, -0.2, -2.9, -1.3, -2.5, 0.06});
      add_plate(trim.mesh, {out, 2.9, 3.5, -0.86, -2.66, -1.0, -2.58, 0.07});
      const Axis motor{x * 0.82, y * 0.62}, muzzle{tip.x, tip.y};
      add_loft(engine.mesh, kEngine, motor, 12);
      add_loft(glow.mesh, kGlow, motor, 12);
      add_rod(gun.mesh, muzzle, 0.07, 0.4, -2.6);
      add_rod(gun.mesh, muzzle, kBarrelRadius, 3.9, 0.3);
      add_rod(gun.mesh, muzzle, 0.026, 4.1, 3.8);
    }
  }
  Scene scene;
  for (Part* p : {&hull, &wing, &trim, &engine, &glow, &gun, &glass}) {
    scene.add(std::move(p->mesh), std::move(p->material));
  }
  return scene;
}

}  // namespace

Entry xfighter() {
  return {{"xfighter",
           "fighter of four long thin crossing wings, 9 long: barrels 0.024 wide, seven materials, a canopy "
           "of glass",
           {}},
          make_xfighter};
}

}  // namespace blysk::shape
