#include "render/frame.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "lighting/set_lobe.h"
#include "math/srgb.h"

namespace blysk {
namespace {

constexpr int kLargestSide = 16384;
constexpr std::size_t kMostTriangles = std::size_t{1} << 31;  // ids are signed in the kernels
constexpr std::size_t kMostVertices = std::size_t{1} << 29;   // 4 * index is a signed 32-bit offset

Error failure(ErrorCode code, std::string message) { return {code, std::move(message), {}, 0}; }

Status check(const Scene& scene) {
  for (const Instance& i : scene.instances) {
    if (i.mesh >= scene.meshes.size() || i.material >= scene.materials.size()) {
      return failure(ErrorCode::usage,
                     "an instance refers to a mesh or material that the scene does not have");
    }
  }
  return Done{};
}

Status check(const RenderOptions& o) {
  if (o.width < 1 || o.height < 1 || o.width > kLargestSide || o.height > kLargestSide) {
    return failure(ErrorCode::usage, "the picture's sides must be 1 to 16384 pixels");
  }
  if (!(o.max_error >= 0 && o.max_error <= 1)) {
    return failure(ErrorCode::usage, "the largest error of shading must be 0 to 1");
  }
  const std::pair<MethodKind, const std::string*> chosen[] = {{MethodKind::shading, &o.shading},
                                                              {MethodKind::lighting, &o.lighting},
                                                              {MethodKind::lobe, &o.lobe},
                                                              {MethodKind::antialias, &o.antialias}};
  for (const auto& [kind, text] : chosen) {
    const Result<MethodChoice> choice = choose_method(kind, *text);
    if (!choice) return choice.error();
  }
  return Done{};
}

// The key light: from above the camera's left shoulder.
Light key_light(const ViewFrame& v) {
  Light light;
  light.vector = normalize(v.up * 0.6 - v.right * 0.4 - v.forward);
  light.color = {0.85f, 0.85f, 0.85f};
  return light;
}

void set(float* to, Vec3f v) {
  to[0] = v.x;
  to[1] = v.y;
  to[2] = v.z;
}

// Colours that reach a kernel are not negative and not infinite.
void set_color(float* to, Vec3f v) {
  const auto bounded = [](float c) { return c > 0 ? std::min(c, 1e6f) : 0.0f; };
  set(to, {bounded(v.x), bounded(v.y), bounded(v.z)});
}

struct NamedLobe {
  std::string_view name;
  Lobe lobe;
};

constexpr NamedLobe kLobes[] = {
    {"power", Lobe::power},
    {"schlick", Lobe::schlick},
    {"w3", Lobe::w3},
    {"w4", Lobe::w4},
    {"w7", Lobe::w7},
    {"w8", Lobe::w8},
    {"w15", Lobe::w15},
    {"w16", Lobe::w16},
    {"logarithmic", Lobe::logarithmic},
    {"quadratic", Lobe::quadratic},
    {"cosine-squared", Lobe::cosine_squared},
};

Surface make_surface(const Material& m, std::span<const Light> lights, const RenderOptions& o) {
  Surface s{};
  s.model = o.lighting == "blinn"   ? LightingModel::blinn
            : o.lighting == "phong" ? LightingModel::phong
                                    : LightingModel::lambert;
  s.shininess = std::clamp(m.shininess, 1.0f, 1000.0f);
  s.whole_shininess = s.shininess == std::floor(s.shininess) ? static_cast<int>(s.shininess) : 0;
  set_lobe(s, std::ranges::find(kLobes, std::string_view(o.lobe), &NamedLobe::name)->lobe);
  set_color(s.ambient, m.unlit ? m.color : m.color * o.ambient);
  set_color(s.emission, m.emission);
  for (const Light& light : m.unlit ? std::span<const Light>() : lights) {
    Lamp& lamp = s.lamp[s.lamps++];
    lamp.point = light.kind == Light::Kind::point;
    set(lamp.vector, to_float(lamp.point ? light.vector : normalize(light.vector)));
    set_color(lamp.diffuse,
              {light.color.x * m.color.x, light.color.y * m.color.y, light.color.z * m.color.z});
    set_color(lamp.specular,
              {light.color.x * m.specular.x, light.color.y * m.specular.y, light.color.z * m.specular.z});
  }
  return s;
}

float unit(float v) { return v > 0 ? std::min(v, 1.0f) : 0.0f; }  // not a number: 0

// The least and the largest alpha of a mesh's vertices.
std::pair<float, float> alpha_range(const Mesh& mesh) {
  if (mesh.colors.empty()) return {1.0f, 1.0f};
  float low = 1, high = 0;
  for (const Vec4f& c : mesh.colors) {
    low = std::min(low, unit(c.w));
    high = std::max(high, unit(c.w));
  }
  return {low, high};
}

// Where pixels are sampled; one sample shows everything as opaque.
void set_opacity(DrawPlan& p, const Mesh& mesh, const Material& m, Interpolation interpolation) {
  if (m.alpha_mode == AlphaMode::opaque) return;
  const bool mask = m.alpha_mode == AlphaMode::mask;
  const float factor = unit(m.opacity);
  const auto [low, high] = alpha_range(mesh);
  const auto shown = [&](float alpha) {
    const float opacity = factor * alpha;
    return !mask ? opacity : opacity >= m.alpha_cutoff ? 1.0f : 0.0f;
  };
  p.opacity = shown(high);
  p.varies = shown(low) != shown(high);
  if (!p.varies) return;
  const Draw& d = p.draw;
  p.varying = {.positions = d.positions,
               .indices = d.indices,
               .colors = d.colors,
               .projection = d.projection,
               .vertex_base = d.vertex_base,
               .id_base = d.id_base,
               .factor = factor,
               .cutoff = m.alpha_cutoff,
               .mask = mask,
               .screen_linear = interpolation == Interpolation::screen};
}

ListPlan list_plan(const MethodChoice& choice) {
  using antialias::Overflow;
  using Kind = ListPlan::Kind;
  const auto number = [&](std::size_t setting) { return static_cast<std::size_t>(choice.values[setting]); };
  const auto from = [](Overflow first, int step) {
    return static_cast<Overflow>(static_cast<int>(first) + step);
  };
  const std::string_view name = choice.method->name;
  ListPlan p;
  if (name == "abuffer-unlimited") {
    p.kind = Kind::lists;
  } else if (name == "abuffer-carpenter") {
    p.kind = Kind::carpenter;
  } else if (name == "abuffer-discard") {
    p = {.kind = Kind::lists, .overflow = from(Overflow::d1, choice.values[1]), .most = number(0)};
  } else if (name == "abuffer-merge") {
    p = {.kind = Kind::lists, .overflow = from(Overflow::m0, choice.values[1]), .most = number(0)};
  } else if (name == "abuffer-pool") {
    p = {.kind = Kind::pool,
         .overflow = from(Overflow::m0, choice.values[3]),
         .main = number(0),
         .extra = number(1),
         .pool = number(2)};
  }
  return p;
}

// Two halves of sixteen samples each are the eight columns of grid32.
Subpixels subpixels_of(const MethodChoice& choice) {
  const std::span<const MethodSetting> settings = choice.method->settings;
  for (std::size_t i = 0; i < settings.size(); ++i) {
    const int value = choice.values[i];
    if (settings[i].name == "samples" && value == 1) return {.across = 2, .down = 1, .centered = true};
    if (choice.method->name == "supersample") return {.across = 2 << value, .down = 2 << value};
  }
  return {};
}

Status plan_sampling(const RenderOptions& o, FramePlan& plan) {
  const MethodChoice antialias = *choose_method(MethodKind::antialias, o.antialias);
  plan.sampling = antialias.method->name == "none" ? Sampling::centers : Sampling::samples;
  plan.lists = list_plan(antialias);
  plan.subpixels = subpixels_of(antialias);
  const auto& [across, down, centered] = plan.subpixels;
  if (centered) plan.lists.pattern = &antialias::kGrid32;
  plan.width = o.width * across;
  plan.height = o.height * down;
  if (plan.width > kLargestSide || plan.height > kLargestSide) {
    return failure(ErrorCode::usage, "with --antialias " + o.antialias + " the picture may have at most " +
                                         std::to_string(kLargestSide / across) + "x" +
                                         std::to_string(kLargestSide / down) + " pixels");
  }
  return Done{};
}

DropArea drop_area(const Material& m, const Mat4& transform, Cull cull) {
  if (cull == Cull::none || (cull == Cull::material && m.double_sided)) return DropArea::none;
  // Seen from the front a triangle turns counter-clockwise, which is a negative area with row 0 at the top.
  return determinant3(transform) < 0 ? DropArea::negative : DropArea::positive;
}

// A power of two that brings the largest number of a 3x3 matrix near 1.
double unit_scale(const Mat4& m) {
  double largest = 0;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) largest = std::max(largest, std::abs(m.m[i][j]));
  }
  int exponent = 0;
  std::frexp(largest, &exponent);
  return std::ldexp(1.0, -exponent);
}

DrawPlan plan_draw(const Scene& scene, const Instance& instance, const ViewFrame& view) {
  const Mesh& mesh = scene.meshes[instance.mesh];
  DrawPlan p;
  Draw& d = p.draw;
  d = Draw{};
  d.positions = mesh.positions.data();
  d.normals = mesh.normals.empty() ? nullptr : mesh.normals.data();
  d.colors = mesh.colors.empty() ? nullptr : mesh.colors.data();
  d.indices = mesh.indices.data();
  d.moved = !(instance.transform == Mat4{});
  const Mat4 normals = normal_matrix(instance.transform);
  const double scale = unit_scale(normals);  // only their direction counts
  const Mat4 projection = view.screen * instance.transform;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      if (i < 3 && j < 3) d.normal_matrix[3 * i + j] = static_cast<float>(normals.m[i][j] * scale);
      if (i < 3) d.matrix[4 * i + j] = static_cast<float>(instance.transform.m[i][j]);
      d.projection.row[i][j] = static_cast<float>(projection.m[i][j]);
    }
  }
  p.vertices = mesh.positions.size();
  p.triangles = mesh.triangles();
  return p;
}

std::uint32_t pack_background(Vec4f c) {
  const auto code = [](float v) {
    return static_cast<std::uint32_t>(std::clamp(v, 0.0f, 1.0f) * 255.0f + 0.5f);
  };
  return code(c.x) | code(c.y) << 8 | code(c.z) << 16 | code(c.w) << 24;
}

Vec4f linear_background(Vec4f c, Transfer transfer) {
  const float alpha = std::clamp(c.w, 0.0f, 1.0f);
  const auto linear = [&](float v) {
    return alpha * (transfer == Transfer::srgb ? srgb_to_linear(v) : std::clamp(v, 0.0f, 1.0f));
  };
  return {linear(c.x), linear(c.y), linear(c.z), alpha};
}

}  // namespace

Status plan_frame(const Scene& scene, const RenderOptions& options, FramePlan& plan) {
  if (const Status s = check(options); !s) return s.error();
  if (const Status s = check(scene); !s) return s.error();
  Camera camera;
  if (options.camera) {
    camera = *options.camera;
  } else {
    camera = frame_camera(scene, {.aspect = double(options.width) / options.height});
  }
  Result<ViewFrame> view = make_view(camera, scene, options.width, options.height);
  if (!view) return view.error();
  if (const Status s = plan_sampling(options, plan); !s) return s.error();
  plan.view = in_subpixels(*view, plan.subpixels);

  const Light key = key_light(plan.view);
  std::span<const Light> lights = !options.lights.empty() ? options.lights : scene.lights;
  if (lights.empty()) lights = {&key, 1};
  if (lights.size() > kMaxLamps) {
    return failure(ErrorCode::limit, "a picture may have at most 16 lights");
  }

  plan.draws.clear();
  plan.glass = false;
  plan.vertices = plan.triangles = 0;
  plan.shading = *choose_method(MethodKind::shading, options.shading);
  plan.background = pack_background(options.background);
  plan.linear_background = linear_background(options.background, options.transfer);
  plan.want_nearness = options.want_depth || std::ranges::any_of(lights, [](const Light& l) {
                         return l.kind == Light::Kind::point;
                       });
  for (const Instance& instance : scene.instances) {
    if (scene.meshes[instance.mesh].indices.size() < 3) continue;
    DrawPlan p = plan_draw(scene, instance, plan.view);
    const Material& material = scene.materials[instance.material];
    p.draw.surface = make_surface(material, lights, options);
    p.drop = drop_area(material, instance.transform, options.cull);
    p.draw.vertex_base = static_cast<std::uint32_t>(plan.vertices);
    p.draw.id_base = static_cast<std::uint32_t>(plan.triangles);
    p.draw.id_count = static_cast<std::uint32_t>(p.triangles);
    plan.vertices += p.vertices;
    plan.triangles += p.triangles;
    if (plan.triangles > options.limits.max_triangles || plan.triangles >= kMostTriangles ||
        plan.vertices >= kMostVertices) {
      return failure(ErrorCode::limit, "the scene has more triangles or vertices than the limits allow (" +
                                           std::to_string(options.limits.max_triangles) + " triangles)");
    }
    p.draw.in_samples = plan.sampling == Sampling::samples;
    if (p.draw.in_samples) {
      set_opacity(p, scene.meshes[instance.mesh], material, options.interpolation);
    }
    plan.glass = plan.glass || (p.opacity > 0 && p.transparent());
    if (p.opacity == 0) p.triangles = 0;  // they keep their ids
    plan.draws.push_back(p);
  }
  return Done{};
}

}  // namespace blysk
