#include "scenes.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>
#include <vector>

#include "blysk/model.h"
#include "math/trig.h"

namespace blysk::bench {
namespace {

constexpr double kFovDeg = 30, kElevationDeg = 15, kFirstAngle = 0.5;
constexpr double kScreenDistance = 5;  // of the camera from the plane z = 0 of scenes laid out in pixels
constexpr double kMostTriangles = 5e7, kMostLayers = 1000;

// Where a point of the picture, -1..1 each way, lies in the world at height z over the plane.
Vec3f on_screen(double x, double y, double z, double aspect) {
  const double half = (kScreenDistance - z) * tangent(radians(kFovDeg) * 0.5);
  return to_float(Vec3d{x * half * aspect, y * half, z});
}

Mesh quad(double aspect) {
  Mesh mesh;
  for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
    mesh.positions.push_back(on_screen(x, y, 0, aspect));
  }
  mesh.normals.assign(4, Vec3f{0, 0, 1});
  mesh.indices = {0, 1, 2, 0, 2, 3};
  return mesh;
}

// Two triangles for each cell of a grid of (columns + 1) x (rows + 1) vertices that start at `base`.
void add_cells(Mesh& mesh, std::uint32_t base, int columns, int rows) {
  const auto stride = static_cast<std::uint32_t>(columns) + 1;
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const std::uint32_t a = base + static_cast<std::uint32_t>(j) * stride + static_cast<std::uint32_t>(i);
      const std::uint32_t b = a + 1, c = a + stride, d = c + 1;
      mesh.indices.insert(mesh.indices.end(), {a, b, d, a, d, c});
    }
  }
}

struct Layers {
  double area;  // of a triangle, pixels
  int count;
  bool farthest_first;
};

Mesh triangle_layers(const Layers& layers, int width, int height) {
  Mesh mesh;
  const double side = std::sqrt(2 * layers.area), aspect = double(width) / height;
  const int columns = static_cast<int>(std::ceil(width / side)) + 1;
  const int rows = static_cast<int>(std::ceil(height / side)) + 1;
  for (int layer = 0; layer < layers.count; ++layer) {
    const double part = double(layer) / layers.count, shift = side * part;
    const double z = layers.farthest_first ? -0.9 + 1.6 * part : 0.7 - 1.6 * part;
    const auto base = static_cast<std::uint32_t>(mesh.positions.size());
    for (int y = 0; y <= rows; ++y) {
      for (int x = 0; x <= columns; ++x) {
        mesh.positions.push_back(
            on_screen((x * side - shift) / width * 2 - 1, (y * side - shift) / height * 2 - 1, z, aspect));
        const Vec3d tilted = {sine(x * 0.37 + layer), cosine(y * 0.41), 2};
        mesh.normals.push_back(to_float(normalize(tilted)));
      }
    }
    add_cells(mesh, base, columns, rows);
  }
  return mesh;
}

Mesh sphere(double triangles) {
  const int rows = std::max(4, static_cast<int>(std::sqrt(triangles / 4)));
  const int columns = static_cast<int>(triangles / 2 / rows);
  struct Angle {
    double sine, cosine, wave, ripple;
  };
  std::vector<Angle> around;
  for (int k = 0; k <= columns; ++k) {
    const double phi = 2 * kPi * k / columns;
    around.push_back({sine(phi), cosine(phi), cosine(7 * phi), sine(37 * phi)});
  }
  Mesh mesh;
  mesh.positions.reserve(static_cast<std::size_t>(rows + 1) * static_cast<std::size_t>(columns + 1));
  mesh.indices.reserve(6 * static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns));
  for (int j = 0; j <= rows; ++j) {
    const double theta = kPi * j / rows;
    const Angle down = {sine(theta), cosine(theta), sine(9 * theta), sine(41 * theta)};
    for (const Angle& a : around) {
      const double r = 1 + 0.06 * down.wave * a.wave + 0.015 * down.ripple * a.ripple;
      mesh.positions.push_back(to_float(Vec3d{down.sine * a.cosine, down.cosine, down.sine * a.sine} * r));
    }
  }
  const auto stride = static_cast<std::uint32_t>(columns) + 1;
  for (std::uint32_t j = 0; j < static_cast<std::uint32_t>(rows); ++j) {
    for (std::uint32_t k = 0; k < static_cast<std::uint32_t>(columns); ++k) {
      const std::uint32_t a = j * stride + k, b = a + 1, c = a + stride, d = c + 1;
      mesh.indices.insert(mesh.indices.end(), {a, b, c, b, d, c});
    }
  }
  return mesh;
}

// Cuts the next ":"-separated word off `text`.
std::string_view next_word(std::string_view& text) {
  const std::size_t end = std::min(text.find(':'), text.size());
  const std::string_view word = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return word;
}

// A number in the range, or 0.
double number(std::string_view word, double least, double most) {
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  const bool whole = error == std::errc() && end == word.data() + word.size();
  return whole && value >= least && value <= most ? value : 0;
}

Error unknown(const std::string& name) {
  return {ErrorCode::usage, "not a scene; use quad, sphere:N, tris:AREA:DEPTH[:b2f] or a model file", name,
          0};
}

Result<Scene> make_scene(const std::string& name, int width, int height) {
  std::string_view rest = name;
  const std::string_view kind = next_word(rest);
  Scene scene;
  if (kind == "quad") {
    scene.add(quad(double(width) / height));
  } else if (kind == "sphere") {
    const double triangles = number(next_word(rest), 64, kMostTriangles);
    if (triangles == 0) return unknown(name);
    scene.add(sphere(triangles));
  } else if (kind == "tris") {
    const double area = number(next_word(rest), 0.1, 1e6);
    const double count = number(next_word(rest), 1, kMostLayers);
    const double pixels = double(width) * height;
    if (area == 0 || count == 0 || pixels / area * count > kMostTriangles ||
        (!rest.empty() && rest != "b2f")) {
      return unknown(name);
    }
    scene.add(triangle_layers({area, static_cast<int>(count), rest == "b2f"}, width, height));
  } else {
    return load_model(name, {.crease_deg = 180, .threads = 0, .limits = {}});
  }
  return scene;
}

Material material() {
  Material m;
  m.color = {0.75f, 0.7f, 0.65f};
  m.specular = Vec3f{1, 1, 1} * (0.4f / 0.85f);  // the light's colour is 0.85
  m.shininess = 48;
  return m;
}

}  // namespace

Result<Stage> make_stage(const std::string& name, int width, int height) {
  Result<Scene> scene = make_scene(name, width, height);
  if (!scene) return scene.error();
  Stage stage;
  stage.on_screen = name == "quad" || name.starts_with("tris:");
  stage.scene = std::move(*scene);
  for (Material& m : stage.scene.materials) m = material();
  for (Mesh& mesh : stage.scene.meshes) {
    if (mesh.normals.empty()) make_normals(mesh, 180);
    mesh.colors.clear();
  }
  stage.center = stage.scene.bounds().center();
  for (const Instance& instance : stage.scene.instances) {
    for (const Vec3f& p : stage.scene.meshes[instance.mesh].positions) {
      const Vec3d at = transform_point(instance.transform, to_double(p));
      stage.radius = std::max(stage.radius, length(at - stage.center));
    }
  }
  return stage;
}

void aim(const Stage& stage, double turn, RenderOptions& options) {
  Camera camera;
  Light light;
  camera.fov_deg = kFovDeg;
  light.color = {0.85f, 0.85f, 0.85f};
  if (stage.on_screen) {
    camera.eye = {0, 0, kScreenDistance};
    camera.near_distance = kScreenDistance - 2;
    camera.far_distance = kScreenDistance + 2;
    light.vector = normalize(Vec3d{0.3, 0.5, 1});
  } else {
    const double angle = kFirstAngle + 2 * kPi * turn, rise = radians(kElevationDeg);
    const Vec3d back = {sine(angle) * cosine(rise), sine(rise), cosine(angle) * cosine(rise)};
    const double distance = stage.radius / sine(radians(kFovDeg) * 0.5);
    const Vec3d right = normalize(cross(Vec3d{0, 1, 0}, back));
    camera.eye = stage.center + back * distance;
    camera.target = stage.center;
    camera.near_distance = distance - 1.01 * stage.radius;
    camera.far_distance = distance + 1.01 * stage.radius;
    light.vector = normalize(cross(back, right) * 0.6 + right * 0.4 + back);
  }
  options.camera = camera;
  options.lights = {light};
}

RenderOptions frame_options(int width, int height) {
  RenderOptions options;
  options.antialias = "none";
  options.width = width;
  options.height = height;
  options.ambient = 0.15f;
  options.cull = Cull::none;
  options.transfer = Transfer::none;
  return options;
}

RenderOptions aimed_options(const Stage& stage, int width, int height) {
  RenderOptions options = frame_options(width, height);
  aim(stage, 0, options);
  return options;
}

}  // namespace blysk::bench
