#include "scene_options.h"

#include <algorithm>
#include <charconv>
#include <filesystem>

#include "blysk/model.h"
#include "blysk/shapes.h"
#include "terminal.h"
#include "text.h"

namespace blysk::command {
namespace {

constexpr std::size_t kProblemsShown = 2;

Vec3d vec3d(const Value& value) { return {value.numbers[0], value.numbers[1], value.numbers[2]}; }
Vec3f vec3f(const Value& value) { return to_float(vec3d(value)); }

Status excludes(const Arguments& arguments, std::string_view option,
                std::initializer_list<const char*> others) {
  if (!arguments.has(option)) return Done{};
  for (const char* other : others) {
    if (!arguments.has(other)) continue;
    return usage_error("--" + std::string(option), "cannot stand beside --" + std::string(other));
  }
  return Done{};
}

template <class Enum>
Enum choice_of(const Arguments& arguments, std::string_view name) {
  const auto& choices = option(name).choices;
  return static_cast<Enum>(std::ranges::find(choices, arguments.text(name)) - choices.begin());
}

// Turns what is made with z up so that it stands: (x, y, z) goes to (x, z, -y).
void stand_up(Scene& scene) {
  const Mat4 turn{{{1, 0, 0, 0}, {0, 0, 1, 0}, {0, -1, 0, 0}, {0, 0, 0, 1}}};
  for (Instance& instance : scene.instances) instance.transform = turn * instance.transform;
  for (Light& light : scene.lights) light.vector = transform_direction(turn, light.vector);
  for (Camera& camera : scene.cameras) {
    camera.eye = transform_point(turn, camera.eye);
    camera.target = transform_point(turn, camera.target);
    camera.up = transform_direction(turn, camera.up);
  }
}

void override_materials(const Arguments& arguments, Scene& scene) {
  if (const Value* color = arguments.find("color")) {
    for (Mesh& mesh : scene.meshes) mesh.colors = {};
    for (Material& material : scene.materials) {
      material.color = vec3f(*color);
      material.color_texture = Material::kNoTexture;
    }
  }
  for (Material& material : scene.materials) {
    if (const Value* specular = arguments.find("specular")) material.specular = vec3f(*specular);
    if (const Value* shininess = arguments.find("shininess")) {
      material.shininess = static_cast<float>(shininess->numbers[0]);
    }
    if (const Value* opacity = arguments.find("opacity")) {
      material.opacity = static_cast<float>(opacity->numbers[0]);
      material.alpha_mode = AlphaMode::blend;
    }
  }
}

// Height of a parallel projection that shows all of the scene whichever way it is turned.
double fitting_height(const Scene& scene, double aspect) {
  return 2 * scene.bounds().radius() / std::min(aspect, 1.0);
}

Result<Camera> camera_of_file(const std::string& wanted, const Scene& scene) {
  const std::string source = "--camera " + wanted;
  if (scene.cameras.empty())
    return usage_error(source, "the model has no cameras; without --camera all of it is framed");
  std::vector<std::string> names;
  for (const Camera& camera : scene.cameras) {
    if (camera.name == wanted) return camera;
    names.push_back(camera.name);
  }
  std::size_t index = 0;
  const char* const end = wanted.data() + wanted.size();
  const auto parsed = std::from_chars(wanted.data(), end, index);
  if (parsed.ec == std::errc() && parsed.ptr == end && index < scene.cameras.size())
    return scene.cameras[index];
  return usage_error(source, "no such camera" + did_you_mean(wanted, names) + "; the model has 0 to " +
                                 std::to_string(names.size() - 1) + ", blysk info names them");
}

Result<Camera> camera_at_eye(const Arguments& arguments, const Scene& scene) {
  Camera camera;
  camera.eye = vec3d(*arguments.find("eye"));
  const Value* target = arguments.find("target");
  camera.target = target != nullptr ? vec3d(*target) : scene.bounds().center();
  camera.up = normalize(vec3d(arguments.value("up")));
  camera.fov_deg = arguments.number("fov");

  const Vec3d direction = camera.target - camera.eye;
  if (direction == Vec3d{}) {
    return usage_error("--eye", target != nullptr
                                    ? "is the same point as --target"
                                    : "is the middle of the model, which the camera looks at; give a "
                                      "--target");
  }
  constexpr double kParallel = 1e-9;  // sine of the angle under which a camera has no sideways
  if (length(cross(normalize(direction), camera.up)) < kParallel) {
    return usage_error("--up",
                       "is the direction that the camera looks in; give another, for example --up 0,0,1");
  }
  return camera;
}

Result<Camera> make_camera(const Arguments& arguments, const Scene& scene, double aspect) {
  const Value* parallel = arguments.find("orthographic");
  if (!arguments.has("eye") && !arguments.has("camera")) {
    Camera camera = frame_camera(scene, {.view = choice_of<View>(arguments, "view"),
                                         .aspect = aspect,
                                         .fov_deg = arguments.number("fov"),
                                         .zoom = arguments.number("zoom"),
                                         .orthographic = parallel != nullptr});
    if (parallel != nullptr && !parallel->numbers.empty()) camera.height = parallel->numbers[0];
    return camera;
  }
  Result<Camera> camera = arguments.has("eye") ? camera_at_eye(arguments, scene)
                                               : camera_of_file(arguments.text("camera"), scene);
  if (!camera) return camera;
  if (arguments.has("fov")) camera->fov_deg = arguments.number("fov");
  if (parallel != nullptr) {
    camera->height = parallel->numbers.empty() ? fitting_height(scene, aspect) : parallel->numbers[0];
  }
  return camera;
}

// Readers know the limit of one model; shapes and sums of models are held to it here.
Status check_triangles(std::uint64_t triangles, const std::string& path, const Arguments& arguments) {
  const std::uint64_t most = limits_of(arguments).max_triangles;
  if (triangles <= most) return Done{};
  return Error{.code = ErrorCode::limit,
               .message = "that makes " + counted(triangles, "triangle") + "; --max-triangles allows " +
                          count_text(most) + ", raise it if you mean it",
               .source = path};
}

std::vector<Light> lights_of(const Arguments& arguments) {
  std::vector<Light> lights;
  for (const Given& given : arguments.given()) {
    const Type type = given.option->type;
    if (type != Type::light && type != Type::point_light) continue;
    const std::vector<double>& n = given.value.numbers;
    Light light;
    light.kind = type == Type::light ? Light::Kind::directional : Light::Kind::point;
    light.vector = {n[0], n[1], n[2]};
    light.color = to_float({n[3], n[4], n[5]});
    lights.push_back(light);
  }
  return lights;
}

// For who writes "teapot", or mistypes "shape:", where no such file is.
std::string shape_meant(const std::string& path) {
  std::error_code ignored;
  if (std::filesystem::exists(path, ignored)) return "";
  const std::string name = path.substr(path.find(':') + 1);  // all of it where there is none
  for (const ShapeInfo& shape : shapes()) {
    if (name.substr(0, name.find('?')) == shape.name) return ", or did you mean shape:" + name + "?";
  }
  return "";
}

}  // namespace

Status check_scene_options(const Arguments& arguments) {
  if (const Status s = excludes(arguments, "eye", {"view", "zoom", "camera"}); !s) return s;
  if (const Status s = excludes(arguments, "camera", {"view", "zoom", "target", "up"}); !s) return s;
  for (const char* name : {"target", "up"}) {
    if (arguments.has(name) && !arguments.has("eye")) {
      return usage_error("--" + std::string(name), "needs --eye");
    }
  }
  const Value* parallel = arguments.find("orthographic");
  if (parallel != nullptr && !parallel->numbers.empty() && arguments.has("zoom")) {
    return usage_error("--zoom", "cannot stand beside a HEIGHT of --orthographic");
  }
  if (std::ranges::count(arguments.operands(), "-") > 1) {
    return usage_error("-", "standard input can be read only once");
  }
  if (const Result<Isa> isa = isa_of(arguments); !isa) return isa.error();
  return Done{};
}

Limits limits_of(const Arguments& arguments) {
  return {.max_triangles = static_cast<std::uint64_t>(arguments.number("max-triangles")),
          .max_memory = static_cast<std::uint64_t>(arguments.number("max-memory"))};
}

int threads_of(const Arguments& arguments) {
  const Value* threads = arguments.find("threads");
  return threads != nullptr ? static_cast<int>(threads->numbers[0]) : 0;
}

Result<Isa> isa_of(const Arguments& arguments) {
  if (!arguments.has("isa")) return Isa::best;
  const Isa wanted = choice_of<Isa>(arguments, "isa");
  const std::vector<Isa> available = available_isas();
  if (wanted == Isa::best || std::ranges::find(available, wanted) != available.end()) return wanted;
  std::vector<std::string> names;
  for (const Isa isa : available) names.emplace_back(isa_name(isa));
  return usage_error("--isa " + arguments.text("isa"),
                     "this processor or build does not run it; it runs " + join(names, ", "));
}

Result<Scene> load_within_limits(const std::string& path, bool may_be_empty, const Arguments& arguments) {
  ModelOptions options;
  if (arguments.has("crease")) options.crease_deg = arguments.number("crease");
  options.may_be_empty = may_be_empty;
  options.threads = threads_of(arguments);
  options.limits = limits_of(arguments);
  Result<Scene> scene = load_model(path, options);
  if (!scene && scene.error().code == ErrorCode::input) {
    Error error = scene.error();
    error.message += shape_meant(path);
    return error;
  }
  if (!scene) return scene;
  if (const Status status = check_triangles(scene->triangles(), path, arguments); !status)
    return status.error();
  return scene;
}

Result<Scene> load_models(const Arguments& arguments) {
  Scene scene;
  const bool several = arguments.operands().size() > 1;
  for (const std::string& path : arguments.operands()) {
    Result<Scene> model = load_within_limits(path, several, arguments);
    if (!model) return model.error();
    for (std::string& problem : model->problems) problem.insert(0, path + ": ");
    scene.append(std::move(*model));
    if (const Status s = check_triangles(scene.triangles(), path, arguments); !s) return s.error();
  }
  if (scene.triangles() == 0) {
    return Error{
        .code = ErrorCode::input,
        .message =
            "neither this nor the other models have triangles to draw; `blysk info` tells what is in a file",
        .source = arguments.operands().front()};
  }
  if (arguments.text("up-axis") == "z") stand_up(scene);
  override_materials(arguments, scene);
  return scene;
}

void warn_problems(const Scene& scene, const Arguments& arguments) {
  const std::vector<std::string>& problems = scene.problems;
  const std::size_t shown =
      arguments.has("verbose") ? problems.size() : std::min(problems.size(), kProblemsShown);
  for (std::size_t i = 0; i < shown; ++i) warn(problems[i]);
  if (shown < problems.size()) {
    warn(counted(problems.size() - shown, "more problem") + " in the models; --verbose tells them");
  }
}

Result<RenderOptions> render_options(const Arguments& arguments, const Scene& scene) {
  const std::vector<double> size = arguments.value("size").numbers;
  const std::vector<double> background = arguments.value("background").numbers;
  Result<Camera> camera = make_camera(arguments, scene, size[0] / size[1]);
  if (!camera) return camera.error();

  RenderOptions options;
  options.width = static_cast<int>(size[0]);
  options.height = static_cast<int>(size[1]);
  options.camera = std::move(*camera);
  options.lights = lights_of(arguments);
  options.ambient = static_cast<float>(arguments.number("ambient"));
  options.shading = arguments.text("shading");
  options.lighting = arguments.text("lighting");
  options.lobe = arguments.text("lobe");
  options.max_error = static_cast<float>(arguments.number("max-error"));
  options.antialias = arguments.text("antialias");
  options.interpolation = choice_of<Interpolation>(arguments, "interpolation");
  options.cull = choice_of<Cull>(arguments, "cull");
  options.transfer = choice_of<Transfer>(arguments, "transfer");
  options.background = {static_cast<float>(background[0]), static_cast<float>(background[1]),
                        static_cast<float>(background[2]), static_cast<float>(background[3])};
  options.limits = limits_of(arguments);
  return options;
}

}  // namespace blysk::command
