#include "io/gltf_cameras.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "math/trig.h"

namespace blysk::io::gltf {
namespace {

// Scales of a node do not act on cameras and lamps; they look along -z.
Vec3d backward(const Mat4& world) { return normalize(transform_direction(world, {0, 0, 1})); }

double positive(Context& context, Json json, std::string_view name) {
  const double value = context.number(json, name, 0);
  return value > 0 && value < 1e30 ? value : 0;
}

bool read_perspective(Context& context, Json json, Camera& camera) {
  constexpr double kNarrowest = 1, kWidest = 170;  // what Camera::fov_deg takes
  const double yfov = positive(context, json, "yfov");
  camera.fov_deg = std::clamp(yfov * (180 / kPi), kNarrowest, kWidest);
  return yfov > 0;
}

bool read_orthographic(Context& context, Json json, Camera& camera) {
  camera.height = 2 * std::abs(context.number(json, "ymag", 0));
  return camera.height > 0 && camera.height < 1e30;
}

// A lamp before the exposure is known.
struct Lamp {
  Light light;
  double brightness = 0;  // lux or candela; where the lamp is placed, illuminance at the middle of the scene
};

// Falls off with the square of the distance. Inside the model the distance is ill-defined: no nearer than
// half its radius.
double point_brightness(double candela, Vec3d position, const Bounds& bounds) {
  if (bounds.empty()) return candela;
  const Vec3d to_middle = bounds.center() - position;
  const double nearest = bounds.radius() * 0.5;
  const double squared = std::max(dot(to_middle, to_middle), nearest * nearest);
  return squared > 0 ? candela / squared : candela;
}

Lamp read_lamp(Context& context, Json json) {
  Lamp lamp;
  const std::string_view type = context.text(json, "type");
  lamp.brightness = context.number(json, "intensity", 1);
  std::array<double, 3> color{1, 1, 1};
  context.numbers(json, "color", color);
  lamp.light.name = json["name"].text();
  for (double& c : color) c = std::clamp(c, 0.0, 1.0);
  lamp.light.color = {static_cast<float>(color[0]), static_cast<float>(color[1]),
                      static_cast<float>(color[2])};
  if (type == "point" || type == "spot") {
    lamp.light.kind = Light::Kind::point;
    if (type == "spot") context.problem(json, "a spot light shines to all sides, as a point light");
  } else if (type != "directional") {
    context.fail(json, "its type " + in_quotes(type) + " is none of directional, point, spot");
  }
  return lamp;
}

void place_lamp(Lamp& lamp, const Mat4& world, const Bounds& bounds) {
  if (lamp.light.kind == Light::Kind::directional) {
    lamp.light.vector = backward(world);
  } else {
    lamp.light.vector = transform_point(world, {0, 0, 0});
    lamp.brightness = point_brightness(lamp.brightness, lamp.light.vector, bounds);
  }
}

// Unset where it cannot be used.
std::optional<Camera> read_camera(Context& context, Json json) {
  const std::string_view type = context.text(json, "type");
  const Json lens = context.object(json, type);
  Camera camera;
  const bool usable = (type == "perspective" && read_perspective(context, lens, camera)) ||
                      (type == "orthographic" && read_orthographic(context, lens, camera));
  if (!usable) {
    context.problem(json,
                    "left out: a camera must be perspective with yfov > 0 or orthographic with ymag > 0");
    return std::nullopt;
  }
  camera.near_distance = positive(context, lens, "znear");
  camera.far_distance = positive(context, lens, "zfar");
  camera.name = json["name"].text();
  return camera;
}

void name_after(const Placement& placement, std::string& name) {
  if (name.empty()) name = placement.name;
}

}  // namespace

std::vector<Json> light_list(Context& context, Json root) {
  return context.list(extension(context, root, "KHR_lights_punctual"), "lights");
}

void add_cameras(Context& context, Json root, const std::vector<Placement>& placements, Scene& scene) {
  std::vector<std::optional<Camera>> cameras;
  for (const Json& json : context.list(root, "cameras")) cameras.push_back(read_camera(context, json));
  for (const Placement& placement : placements) {
    if (placement.camera == kNone) continue;
    const std::optional<Camera>& found = cameras[static_cast<std::size_t>(placement.camera)];
    if (!found) continue;
    if (!context.allow(sizeof(Camera) + found->name.size(), placement.json)) return;
    Camera camera = *found;
    camera.eye = transform_point(placement.world, {0, 0, 0});
    camera.target = camera.eye - backward(placement.world);
    camera.up = normalize(transform_direction(placement.world, {0, 1, 0}), {0, 1, 0});
    name_after(placement, camera.name);
    scene.cameras.push_back(std::move(camera));
  }
}

// The file gives lux and candela and no exposure. Here lamps count relative to each other: the brightest at
// the middle of the scene becomes 1, or less where all together would exceed kMaxTotal.
void add_lights(Context& context, Json root, const std::vector<Placement>& placements, Scene& scene) {
  constexpr double kMaxTotal = 2;
  std::vector<Lamp> known, lamps;
  for (const Json& json : light_list(context, root)) known.push_back(read_lamp(context, json));
  if (known.empty()) return;
  const Bounds bounds = scene.bounds();
  double brightest = 0, total = 0;
  for (const Placement& placement : placements) {
    if (placement.light == kNone) continue;
    const Lamp& found = known[static_cast<std::size_t>(placement.light)];
    if (!context.allow(2 * (sizeof(Lamp) + found.light.name.size()), placement.json)) return;
    Lamp lamp = found;
    place_lamp(lamp, placement.world, bounds);
    if (!(lamp.brightness > 0 && lamp.brightness < 1e30)) continue;
    name_after(placement, lamp.light.name);
    brightest = std::max(brightest, lamp.brightness);
    total += lamp.brightness;
    lamps.push_back(std::move(lamp));
  }
  if (lamps.empty()) return;
  const double scale = 1 / std::max(brightest, total / kMaxTotal);
  for (Lamp& lamp : lamps) {
    lamp.light.color = lamp.light.color * static_cast<float>(lamp.brightness * scale);
    scene.lights.push_back(std::move(lamp.light));
  }
}

}  // namespace blysk::io::gltf
