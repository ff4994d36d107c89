// Flat, Gouraud and Phong shading, through whole pictures, against the reference forms.
#include <gtest/gtest.h>

#include <functional>

#include "raster/coverage_reference.h"
#include "render/testing.h"
#include "render/view.h"
#include "shading/shading_reference.h"

namespace blysk {
namespace {

constexpr int kTrialWidth = 96, kTrialHeight = 72;

// A few triangles around the origin, what lights them, and a camera that looks at them.
struct Trial {
  Scene scene;
  RenderOptions options = center_options();
  LightingModel model = LightingModel::blinn;
  Projection projection{};
  reference::Viewpoint view;
};

Vec3f random_color(Random& random, float low, float high) {
  const auto channel = [&] { return low + (high - low) * random.unit(); };
  const float r = channel(), g = channel(), b = channel();
  return {r, g, b};
}

Mesh random_mesh(Random& random, bool colors) {
  Mesh mesh;
  for (std::uint32_t i = 0; i < 6; ++i) {
    const Vec3d middle = random_direction(random) * 0.7;
    const double size = std::pow(2.0, uniform(random, -2.5, 0.3));
    for (std::uint32_t k = 0; k < 3; ++k) {
      mesh.positions.push_back(to_float(middle + random_direction(random) * size));
      mesh.indices.push_back(3 * i + k);
    }
    const Vec3d a = to_double(mesh.positions[3 * i]), b = to_double(mesh.positions[3 * i + 1]),
                c = to_double(mesh.positions[3 * i + 2]);
    const Vec3d face = normalize(cross(b - a, c - a));
    for (int k = 0; k < 3; ++k)
      mesh.normals.push_back(to_float(normalize(face + random_direction(random) * 0.7)));
    for (int k = 0; k < 3 && colors; ++k) {
      const Vec3f color = random_color(random, 0, 1);
      mesh.colors.push_back({color.x, color.y, color.z, 1});
    }
  }
  return mesh;
}

enum class Where { outside, among };  // the eye, of the triangles

Trial random_trial(Random& random, Where where = Where::outside) {
  Trial t;
  Material m;
  m.color = random_color(random, 0, 0.5f);
  m.specular = random_color(random, 0, 0.3f);
  m.shininess = static_cast<float>(std::pow(2.0, uniform(random, 0, 8)));
  if (whole(random, 0, 1) == 0) m.shininess = std::round(m.shininess);
  if (whole(random, 0, 3) == 0) m.emission = random_color(random, 0, 0.1f);
  Mesh mesh = random_mesh(random, whole(random, 0, 1) == 0);
  if (whole(random, 0, 5) == 0) mesh.normals.clear();
  t.scene.add(std::move(mesh), m);

  RenderOptions& o = t.options;
  o.width = kTrialWidth;
  o.height = kTrialHeight;
  o.ambient = random.unit() * 0.4f;
  o.transfer = Transfer::none;
  o.cull = Cull::none;
  o.want_id = true;
  t.model = static_cast<LightingModel>(whole(random, 0, 2));
  o.lighting = t.model == LightingModel::blinn   ? "blinn"
               : t.model == LightingModel::phong ? "phong"
                                                 : "lambert";
  for (std::int64_t i = whole(random, 1, 3); i > 0; --i) {
    Light light;
    light.kind = whole(random, 0, 1) == 0 ? Light::Kind::point : Light::Kind::directional;
    light.vector = random_direction(random) * uniform(random, 3, 5);
    light.color = random_color(random, 0, 0.7f);
    o.lights.push_back(light);
  }
  Camera camera;
  camera.eye = random_direction(random) * (where == Where::outside ? uniform(random, 2.5, 5) : 0.4);
  camera.target = random_direction(random) * 0.3;
  camera.fov_deg = uniform(random, 20, 70);
  if (where == Where::outside && whole(random, 0, 2) == 0) camera.height = uniform(random, 1.5, 3);
  camera.near_distance = where == Where::outside ? 0.3 : 0.1;
  camera.far_distance = 10;
  o.camera = camera;
  o.interpolation = whole(random, 0, 2) == 0 ? Interpolation::screen : Interpolation::perspective;

  const Result<ViewFrame> view = make_view(camera, t.scene, kTrialWidth, kTrialHeight);
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) t.projection.row[i][j] = static_cast<float>(view->screen.m[i][j]);
  }
  t.view = {camera.height > 0, camera.eye, view->forward};
  return t;
}

// One triangle as the reference sees it, and what decides whether a comparison is fair.
struct Subject {
  reference::ShadedTriangle shaded;
  std::array<double, 3> q;  // 1 / w, whatever the interpolation
  double slenderness = 0;   // longest side over height
  bool clipped = false;
};

Subject subject_of(const Trial& t, std::size_t triangle) {
  Subject s;
  const Mesh& mesh = t.scene.meshes[0];
  s.shaded.lighting = {t.model, t.scene.materials[0], t.options.lights,
                       static_cast<double>(t.options.ambient)};
  s.shaded.view = t.view;
  double longest = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::uint32_t v = mesh.indices[3 * triangle + k];
    reference::Corner& c = s.shaded.corner[k];
    c.position = to_double(mesh.positions[v]);
    const auto place = reference::place(t.projection, mesh.positions[v]);
    const auto row = [&](int i) {
      const float* m = t.projection.row[i];
      return double{m[0]} * c.position.x + double{m[1]} * c.position.y + double{m[2]} * c.position.z +
             double{m[3]};
    };
    // A corner behind the eye has a place too, with a negative w: the weights stay right.
    s.q[k] = 1 / row(3);
    c.x = place ? static_cast<double>(place->x) : row(0) * s.q[k];
    c.y = place ? static_cast<double>(place->y) : row(1) * s.q[k];
    s.clipped = s.clipped || !place;
    c.q = s.q[k];
    if (!mesh.normals.empty()) c.normal = to_double(mesh.normals[v]);
    if (!mesh.colors.empty()) c.color = to_double({mesh.colors[v].x, mesh.colors[v].y, mesh.colors[v].z});
  }
  const auto& corner = s.shaded.corner;
  // A clipped triangle cannot be interpolated on the screen.
  for (reference::Corner& c : s.shaded.corner) {
    if (t.options.interpolation == Interpolation::screen && !s.clipped) c.q = 1;
  }
  for (reference::Corner& c : s.shaded.corner) {
    if (mesh.normals.empty()) c.normal = reference::face_normal(corner);
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const double dx = corner[k].x - corner[(k + 1) % 3].x, dy = corner[k].y - corner[(k + 1) % 3].y;
    longest = std::max(longest, dx * dx + dy * dy);
  }
  const double area = (corner[1].x - corner[0].x) * (corner[2].y - corner[0].y) -
                      (corner[2].x - corner[0].x) * (corner[1].y - corner[0].y);
  s.slenderness = longest / std::abs(area);
  return s;
}

Vec3d point_at(const Subject& s, double x, double y) {
  auto corner = s.shaded.corner;
  for (std::size_t k = 0; k < 3; ++k) corner[k].q = s.q[k];
  const auto w = reference::weights(corner, x, y);
  return corner[0].position * w[0] + corner[1].position * w[1] + corner[2].position * w[2];
}

// Light jumps where a normal turns away from the viewer, and specular light where it turns away from the
// lamp.
bool near_a_jump(const reference::ShadedTriangle& t, Vec3d position, Vec3d normal) {
  const Vec3d n = normalize(normal);
  if (std::abs(dot(n, normalize(t.view.towards_viewer(position)))) < 1e-3) return true;
  for (const Light& light : t.lighting.lights) {
    const Vec3d l = light.kind == Light::Kind::point ? light.vector - position : light.vector;
    if (std::abs(dot(n, normalize(l))) < 1e-3) return true;
  }
  return false;
}

struct Method {
  const char* name;
  std::function<Vec3d(const Subject&, const std::array<double, 3>& weights, Vec3d point)> shade;
  std::function<bool(const Subject&, const std::array<double, 3>& weights, Vec3d point)> jumps;
};

const std::vector<Method>& methods_under_test() {
  static const std::vector<Method> all = {
      {"flat", [](const Subject& s, const auto& w, Vec3d) { return reference::flat(s.shaded, w); },
       [](const Subject& s, const auto&, Vec3d) {
         const auto& c = s.shaded.corner;
         const Vec3d centroid = (c[0].position + c[1].position + c[2].position) * (1.0 / 3);
         return near_a_jump(s.shaded, centroid, reference::face_normal(c));
       }},
      {"gouraud", [](const Subject& s, const auto& w, Vec3d) { return reference::gouraud(s.shaded, w); },
       [](const Subject& s, const auto&, Vec3d) {
         const auto& c = s.shaded.corner;
         return std::any_of(c.begin(), c.end(),
                            [&](const auto& v) { return near_a_jump(s.shaded, v.position, v.normal); });
       }},
      {"phong", [](const Subject& s, const auto& w, Vec3d p) { return reference::phong(s.shaded, w, p); },
       [](const Subject& s, const auto& w, Vec3d p) {
         const auto& c = s.shaded.corner;
         return near_a_jump(s.shaded, p, c[0].normal * w[0] + c[1].normal * w[1] + c[2].normal * w[2]);
       }},
  };
  return all;
}

struct PictureErrors {
  long pixels = 0, skipped = 0, values = 0, rounded_otherwise = 0;
  double worst = 0, sum = 0;

  void add(std::uint32_t color, Vec3d expected) {
    ++pixels;
    const double channel[3] = {expected.x, expected.y, expected.z};
    for (int k = 0; k < 3; ++k) {
      const double exact = 255 * std::clamp(channel[k], 0.0, 1.0), error = (color >> (8 * k) & 255) - exact;
      ++values;
      rounded_otherwise += std::abs(error) > 0.5 ? 1 : 0;
      worst = std::max(worst, std::abs(error));
      sum += error;
    }
  }
};

void compare_pictures(const Method& method, Where where, long pixels, PictureErrors& errors) {
  Random random(31);
  Frame frame;
  const std::vector<Isa> isas = available_isas();
  for (std::size_t round = 0; errors.pixels < pixels; ++round) {
    Trial t = random_trial(random, where);
    t.options.shading = method.name;
    render_to(frame, t.scene, t.options, isas[round % isas.size()]);
    std::vector<Subject> subjects;
    for (std::size_t i = 0; i < t.scene.meshes[0].triangles(); ++i) subjects.push_back(subject_of(t, i));
    for (std::size_t p = 0; p < frame.id.size(); ++p) {
      if (frame.id[p] == 0) continue;
      const Subject& s = subjects[frame.id[p] - 1];
      const double x = (static_cast<double>(p % kTrialWidth) + 0.5) * kSubpixels,
                   y = (static_cast<double>(p / kTrialWidth) + 0.5) * kSubpixels;
      const auto w = reference::weights(s.shaded.corner, x, y);
      const Vec3d point = point_at(s, x, y);
      if (where == Where::among && !s.clipped) continue;
      if (s.slenderness > 1000 || method.jumps(s, w, point)) {
        ++errors.skipped;
        continue;
      }
      errors.add(frame.image.pixels[p], method.shade(s, w, point));
    }
  }
}

// Section 13, R2: A = (0, 0), B = (-7, 8), C = (9, 12), intensities 0.2, 0.9, 0.5, normals as below.
TEST(shading, reference_has_the_specifications_numbers) {
  std::array<reference::Corner, 3> corner;
  const double x[3] = {0, -7, 9}, y[3] = {0, 8, 12}, intensity[3] = {0.2, 0.9, 0.5};
  const Vec3d normal[3] = {{0.1, 0.2, 1}, {-0.5, 0.1, 1}, {0.3, -0.4, 1}};
  for (std::size_t k = 0; k < 3; ++k) {
    corner[k].x = x[k];
    corner[k].y = y[k];
    corner[k].normal = normalize(normal[k]);
  }
  const struct {
    double x, y, u, v, intensity;
    Vec3d normal;
  } rows[] = {{0, 0, 0, 0, 0.2, {0.0975900073, 0.195180015, 0.975900073}},
              {0, 4, 0.230769231, 0.179487179, 0.415384615, {0.00309388557, 0.0756586347, 0.997128978}},
              {-3, 7, 0.634615385, 0.16025641, 0.692307692, {-0.234711793, 0.0419265101, 0.97116041}},
              {3, 8, 0.230769231, 0.512820513, 0.515384615, {0.0647996608, -0.122233502, 0.990383751}},
              {5, 10, 0.192307692, 0.705128205, 0.546153846, {0.121536704, -0.230246005, 0.965513131}}};
  for (const auto& row : rows) {
    const auto w = reference::weights(corner, row.x, row.y);
    EXPECT_NEAR(w[1], row.u, 1e-9);
    EXPECT_NEAR(w[2], row.v, 1e-9);
    EXPECT_NEAR(w[0] * intensity[0] + w[1] * intensity[1] + w[2] * intensity[2], row.intensity, 1e-9);
    const Vec3d n = normalize(corner[0].normal * w[0] + corner[1].normal * w[1] + corner[2].normal * w[2]);
    EXPECT_LT(length(n - row.normal), 1e-8);
  }
}

TEST(shading, a_million_pixels_of_each_method_agree_with_the_reference) {
  for (const Method& method : methods_under_test()) {
    SCOPED_TRACE(method.name);
    PictureErrors e;
    compare_pictures(method, Where::outside, 1'000'000, e);
    EXPECT_LT(e.worst, 1);
    EXPECT_LT(e.rounded_otherwise, e.values / 500);
    EXPECT_LT(std::abs(e.sum / static_cast<double>(e.values)), 0.01);
    EXPECT_LT(e.skipped, e.pixels / 20);
  }
}

// Triangles that go on behind the eye: attributes are never clipped.
TEST(shading, clipped_triangles_agree_with_the_reference) {
  for (const Method& method : methods_under_test()) {
    SCOPED_TRACE(method.name);
    PictureErrors e;
    compare_pictures(method, Where::among, 200'000, e);
    EXPECT_LT(e.worst, 0.6);
    EXPECT_LT(e.rounded_otherwise, e.values / 500);
    EXPECT_LT(e.skipped, e.pixels / 20);
  }
}

// Metres or millimetres: the same scene in another unit is the same picture, bit for bit.
TEST(shading, the_unit_of_length_does_not_show) {
  Random random(32);
  for (int round = 0; round < 60; ++round) {
    const Trial t = random_trial(random);
    for (const Method& method : methods_under_test()) {
      RenderOptions o = t.options;
      o.shading = method.name;
      o.want_normal = true;
      const Frame expected = render_frame(t.scene, o);
      for (const int power : {-40, -20, -10, 10, 20, 40}) {
        const double unit = std::ldexp(1.0, power);
        Trial other = t;
        for (Vec3f& p : other.scene.meshes[0].positions) p = p * static_cast<float>(unit);
        RenderOptions q = o;
        q.camera->eye = o.camera->eye * unit;
        q.camera->target = o.camera->target * unit;
        q.camera->height *= unit;
        q.camera->near_distance *= unit;
        q.camera->far_distance *= unit;
        for (Light& light : q.lights) light.vector = light.vector * unit;
        const Frame frame = render_frame(other.scene, q);
        EXPECT_TRUE(frame.image.pixels == expected.image.pixels &&
                    frame.normal.values == expected.normal.values)
            << method.name << ", 2^" << power << (t.scene.meshes[0].normals.empty() ? ", no normals" : "");
      }
    }
  }
}

// The same for the scale of an instance, which its normals do not feel.
TEST(shading, the_scale_of_an_instance_does_not_show) {
  Random random(34);
  for (int round = 0; round < 30; ++round) {
    const Trial t = random_trial(random);
    for (const Method& method : methods_under_test()) {
      RenderOptions o = t.options;
      o.shading = method.name;
      o.want_normal = true;
      const Frame expected = render_frame(t.scene, o);
      for (const int power : {-40, -20, -10, 10, 20, 40}) {
        Trial other = t;
        for (Vec3f& p : other.scene.meshes[0].positions) p = p * std::ldexp(1.0f, power);
        const double back = std::ldexp(1.0, -power);
        other.scene.instances[0].transform = scaling({back, back, back});
        const Frame frame = render_frame(other.scene, o);
        EXPECT_TRUE(frame.image.pixels == expected.image.pixels &&
                    frame.normal.values == expected.normal.values)
            << method.name << ", 2^" << power << (t.scene.meshes[0].normals.empty() ? ", no normals" : "");
      }
    }
  }
}

// However thin a triangle is, rounding must not carry its colours beyond those of its corners.
TEST(shading, slivers_stay_between_their_corners) {
  Random random(33);
  int pixels = 0;
  for (int round = 0; round < 4000; ++round) {
    Mesh mesh;
    const double reach = std::pow(2.0, uniform(random, 5, 13));
    const Vec3d from = {uniform(random, -reach, 40), uniform(random, -reach, 30), 0},
                to = {uniform(random, -40, reach), uniform(random, -30, reach), 0};
    const double along = uniform(random, 0, 1);
    const Vec3d middle =
        from + (to - from) * along +
        Vec3d{uniform(random, -1, 1), uniform(random, -1, 1), 0} * std::pow(2.0, uniform(random, -9, 0));
    for (const Vec3d& p : {from, to, middle}) mesh.positions.push_back(to_float(p));
    mesh.indices = {0, 1, 2};
    mesh.normals.assign(3, Vec3f{0, 0, 1});
    mesh.colors.assign(3, Vec4f{});
    for (Vec4f& c : mesh.colors) c = {random.unit(), random.unit(), random.unit(), 1};
    RenderOptions o;
    o.antialias = "none";
    o.width = kTrialWidth;
    o.height = kTrialHeight;
    o.camera = pixel_camera(kTrialHeight);
    o.transfer = Transfer::none;
    o.want_id = true;
    o.shading = methods_under_test()[static_cast<std::size_t>(round % 3)].name;
    Material white;
    white.color = {1, 1, 1};
    white.unlit = true;
    const Frame frame = render_frame(scene_of(mesh, white), o);
    const auto& c = mesh.colors;
    const float lowest[3] = {std::min({c[0].x, c[1].x, c[2].x}), std::min({c[0].y, c[1].y, c[2].y}),
                             std::min({c[0].z, c[1].z, c[2].z})};
    const float highest[3] = {std::max({c[0].x, c[1].x, c[2].x}), std::max({c[0].y, c[1].y, c[2].y}),
                              std::max({c[0].z, c[1].z, c[2].z})};
    for (std::size_t p = 0; p < frame.id.size(); ++p) {
      if (frame.id[p] == 0) continue;
      ++pixels;
      for (std::size_t k = 0; k < 3; ++k) {
        const double v = frame.image.pixels[p] >> (8 * k) & 255;
        ASSERT_GT(v, 255 * static_cast<double>(lowest[k]) - 1) << round;
        ASSERT_LT(v, 255 * static_cast<double>(highest[k]) + 1) << round;
      }
    }
  }
  EXPECT_GT(pixels, 2000);
}

}  // namespace
}  // namespace blysk
