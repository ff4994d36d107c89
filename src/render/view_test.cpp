// Cameras: framing, matrices, rays, and what is refused.
#include "render/view.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "blysk/shapes.h"
#include "render/testing.h"

namespace blysk {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// All vertices of a scene, in the world.
std::vector<Vec3d> points_of(const Scene& scene) {
  std::vector<Vec3d> points;
  for (const Instance& instance : scene.instances) {
    for (const Vec3f& p : scene.meshes[instance.mesh].positions) {
      points.push_back(transform_point(instance.transform, to_double(p)));
    }
  }
  return points;
}

// Where a picture of the scene ends, in parts of its half sides: -1..1 is inside.
struct Extent {
  double left = 1e9, right = -1e9, bottom = 1e9, top = -1e9, nearest = 1e9, farthest = -1e9;

  [[nodiscard]] double fill() const { return std::max({-left, right, -bottom, top}); }
};

Extent extent_of(const Scene& scene, const Camera& camera, int width, int height) {
  Extent e;
  const Result<ViewFrame> view = make_view(camera, scene, width, height);
  EXPECT_TRUE(view) << view.error().text();
  if (!view) return e;
  for (const Vec3d& p : points_of(scene)) {
    const Vec4d v = transform(view->screen, {p.x, p.y, p.z, 1});
    const double x = v.x / v.w / (128.0 * width) - 1, y = 1 - v.y / v.w / (128.0 * height),
                 nearness = v.z / v.w;
    e.left = std::min(e.left, x);
    e.right = std::max(e.right, x);
    e.bottom = std::min(e.bottom, y);
    e.top = std::max(e.top, y);
    e.nearest = std::min(e.nearest, 1 - nearness);
    e.farthest = std::max(e.farthest, 1 - nearness);
    EXPECT_GT(v.w, 0);
  }
  return e;
}

struct NamedScene {
  std::string name;
  Scene scene;
};

std::vector<NamedScene> scenes() {
  std::vector<NamedScene> all;
  const auto shape = [](const char* text) { return std::move(*make_shape(text)); };
  all.push_back({"teapot", shape("teapot?detail=3")});
  all.push_back({"plane", shape("plane")});
  all.push_back({"terrain", shape("terrain?detail=20")});
  Scene far_away = shape("torus?detail=9");
  far_away.instances[0].transform = translation({3e4, -2e4, 5e4}) * scaling({3, 1, 0.2});
  all.push_back({"far away", far_away});
  Scene tiny = shape("cube");
  tiny.instances[0].transform = scaling({1e-6, 2e-6, 5e-7});
  all.push_back({"tiny", tiny});
  Scene huge = shape("cylinder");
  huge.instances[0].transform = scaling({1e7, 1e8, 1e7});
  all.push_back({"huge", huge});
  Scene two = shape("cube");
  two.append(shape("sphere?detail=4"));
  two.instances[1].transform = translation({5, 0.5, -2}) * rotation({0, 0, 1}, 0.5) * scaling({-1, 2, 1});
  all.push_back({"two", two});
  all.push_back({"needle", scene_of(mesh_of({{0, 0, 0}, {0, 9, 0}, {0.001f, 9, 0.001f}}, {0, 1, 2}))});
  return all;
}

constexpr View kViews[] = {View::iso,   View::front, View::back,  View::left,
                           View::right, View::top,   View::bottom};

TEST(frame_camera, keeps_all_of_the_scene_in_the_picture) {
  const struct { int width, height; } sizes[] = {{640, 480}, {100, 700}, {1600, 200}, {64, 64}};
  for (const auto& [name, scene] : scenes()) {
    for (const View view : kViews) {
      for (const auto& [width, height] : sizes) {
        for (const double fov : {5.0, 30.0, 90.0, 150.0}) {
          for (const bool orthographic : {false, true}) {
            const Framing framing = {
                .view = view, .aspect = double(width) / height, .fov_deg = fov, .orthographic = orthographic};
            const Extent e = extent_of(scene, frame_camera(scene, framing), width, height);
            const auto what = [&] {
              return name + ", view " + std::to_string(static_cast<int>(view)) + ", " +
                     std::to_string(width) + "x" + std::to_string(height) + ", fov " + std::to_string(fov) +
                     (orthographic ? ", orthographic" : "");
            };
            EXPECT_LE(e.fill(), 1) << what();
            // And it is not lost in it. In a wide field of view the eye would have to enter it to come
            // nearer.
            EXPECT_GE(e.fill(), (fov < 60 && name != "needle") || orthographic ? 0.9 : 0) << what();
            EXPECT_GE(e.nearest, 0) << what();
            EXPECT_LE(e.farthest, 1) << what();
          }
        }
      }
    }
  }
}

TEST(frame_camera, centres_the_scene) {
  for (const auto& [name, scene] : scenes()) {
    for (const View view : kViews) {
      for (const bool orthographic : {false, true}) {
        const Extent e =
            extent_of(scene, frame_camera(scene, {.view = view, .aspect = 1.5, .orthographic = orthographic}),
                      300, 200);
        // In perspective only the direction in which it fills the picture.
        const bool wide = e.right - e.left > e.top - e.bottom;
        EXPECT_NEAR(e.left + e.right, 0, orthographic || wide ? 0.02 : 1) << name;
        EXPECT_NEAR(e.bottom + e.top, 0, orthographic || !wide ? 0.02 : 1) << name;
      }
    }
  }
}

TEST(frame_camera, zoom_enlarges) {
  for (const auto& [name, scene] : scenes()) {
    for (const bool orthographic : {false, true}) {
      Framing framing = {.aspect = 1.5, .orthographic = orthographic};
      const double plain = extent_of(scene, frame_camera(scene, framing), 300, 200).fill();
      for (const double zoom : {0.5, 2.0, 8.0}) {
        framing.zoom = zoom;
        const double zoomed = extent_of(scene, frame_camera(scene, framing), 300, 200).fill();
        EXPECT_NEAR(zoomed / plain, zoom, 0.01 * zoom) << name << ", " << zoom;
      }
    }
  }
}

TEST(frame_camera, looks_from_where_it_says) {
  const Scene scene = std::move(*make_shape("cube"));
  const Vec3d from[] = {
      normalize(Vec3d{1, 0.8, 1.4}), {0, 0, 1}, {0, 0, -1}, {-1, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}};
  for (std::size_t i = 0; i < std::size(kViews); ++i) {
    const Camera c = frame_camera(scene, {.view = kViews[i]});
    EXPECT_LT(length(normalize(c.eye - c.target) - from[i]), 1e-9) << i;
    EXPECT_LT(std::abs(dot(c.up, c.eye - c.target)), 0.9 * length(c.eye - c.target)) << i;
  }
}

TEST(frame_camera, takes_scenes_without_extent) {
  for (const Scene& scene :
       {Scene{}, scene_of(Mesh{}), scene_of(mesh_of({{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, {0, 1, 2}))}) {
    for (const bool orthographic : {false, true}) {
      const Camera c = frame_camera(scene, {.orthographic = orthographic});
      EXPECT_TRUE(make_view(c, scene, 64, 48));
    }
  }
}

Camera looking(Vec3d eye, Vec3d target, Vec3d up = {0, 1, 0}) {
  Camera c;
  c.eye = eye;
  c.target = target;
  c.up = up;
  c.near_distance = 0.5;
  c.far_distance = 40;
  return c;
}

// A pixel's ray at the depth of a point leads back to the point.
TEST(make_view, matrices_and_rays_agree) {
  Random random(51);
  for (int i = 0; i < 2000; ++i) {
    Camera c = looking(random_direction(random) * 5, random_direction(random), random_direction(random));
    c.fov_deg = uniform(random, 2, 150);
    if (i % 2 == 0) c.height = uniform(random, 0.1, 9);
    const int width = static_cast<int>(whole(random, 1, 2000)),
              height = static_cast<int>(whole(random, 1, 2000));
    const Result<ViewFrame> view = make_view(c, Scene{}, width, height);
    ASSERT_TRUE(view);
    EXPECT_NEAR(length(view->right), 1, 1e-12);
    EXPECT_LT(length(cross(view->right, view->forward) - view->up), 1e-12);
    EXPECT_LT(length(view->forward - normalize(c.target - c.eye)), 1e-12);

    const double depth = uniform(random, 0.6, 30),
                 reach = c.height > 0 ? c.height / 2 : depth * std::tan(c.fov_deg * 3.14159265358979 / 360);
    const Vec3d p = c.eye + view->forward * depth +
                    view->right * (uniform(random, -1, 1) * reach * width / height) +
                    view->up * (uniform(random, -1, 1) * reach);
    const Vec4d v = transform(view->screen, {p.x, p.y, p.z, 1});
    const double x = v.x / v.w, y = v.y / v.w, nearness = v.z / v.w;
    EXPECT_GE(x, -1e-6 * width);
    EXPECT_LE(x, 256.000001 * width);
    const ViewRays& r = view->rays;
    const double d = r.orthographic ? double{r.depth_a} + double{r.depth_b} * nearness
                                    : double{r.depth_a} / (1 + double{r.depth_b} * nearness);
    EXPECT_NEAR(d, depth, 1e-5 * depth);
    const auto along = [&](int k) {
      return double{r.direction[k]} + x * double{r.direction_x[k]} + y * double{r.direction_y[k]};
    };
    const auto from = [&](int k) {
      return double{r.origin[k]} + x * double{r.origin_x[k]} + y * double{r.origin_y[k]};
    };
    const Vec3d back = {from(0) + d * along(0), from(1) + d * along(1), from(2) + d * along(2)};
    EXPECT_LT(length(back - p), 2e-5 * (reach * (1 + double(width) / height) + depth)) << i;
  }
}

TEST(make_view, depth_is_0_near_and_1_far) {
  for (const double height : {0.0, 3.0}) {
    Camera c = looking({0, 0, 5}, {0, 0, 0});
    c.height = height;
    const Result<ViewFrame> view = make_view(c, Scene{}, 100, 100);
    ASSERT_TRUE(view);
    const auto depth = [&](double distance) {
      const Vec4d v = transform(view->screen, {0.1, 0.2, 5 - distance, 1});
      return 1 - v.z / v.w;
    };
    EXPECT_NEAR(depth(0.5), 0, 1e-12);
    EXPECT_NEAR(depth(40), 1, 1e-12);
    EXPECT_GT(depth(20), depth(10));
  }
}

TEST(make_view, up_may_be_anything) {
  for (const Vec3d& up : {Vec3d{0, 0, 1}, Vec3d{0, 0, 0}, Vec3d{0, 0, -7}, Vec3d{kNan, 0, 0}}) {
    const Result<ViewFrame> view = make_view(looking({0, 0, 5}, {0, 0, 0}, up), Scene{}, 10, 10);
    ASSERT_TRUE(view);
    EXPECT_NEAR(length(view->right), 1, 1e-12);
    EXPECT_NEAR(dot(view->right, view->forward), 0, 1e-12);
    EXPECT_NEAR(length(view->up), 1, 1e-12);
  }
}

TEST(make_view, open_planes_enclose_the_scene) {
  const Scene scene = std::move(*make_shape("teapot?detail=3"));
  for (const double height : {0.0, 4.0}) {
    Camera c = looking({3, 4, 5}, {0, 0, 0});
    c.near_distance = c.far_distance = 0;
    c.height = height;
    const Result<ViewFrame> view = make_view(c, scene, 100, 100);
    ASSERT_TRUE(view);
    for (const Vec3d& p : points_of(scene)) {
      const double d = dot(p - c.eye, view->forward);
      EXPECT_LT(view->near_distance, d);
      EXPECT_GT(view->far_distance, d);
    }
  }
  // From the middle of the scene: the near plane still is in front of the eye.
  Camera inside = looking({0, 0, 0}, {1, 0, 0});
  inside.near_distance = inside.far_distance = 0;
  const Result<ViewFrame> view = make_view(inside, scene, 100, 100);
  ASSERT_TRUE(view);
  EXPECT_GT(view->near_distance, 0);
  EXPECT_LT(view->near_distance, 0.01 * view->far_distance);
}

void expect_usage(const Camera& camera, const char* word) {
  const Result<ViewFrame> view = make_view(camera, Scene{}, 10, 10);
  ASSERT_FALSE(view) << word;
  EXPECT_EQ(view.error().code, ErrorCode::usage);
  EXPECT_NE(view.error().text().find(word), std::string::npos) << view.error().text();
}

TEST(make_view, refuses_what_makes_no_sense) {
  const Camera good = looking({0, 0, 5}, {0, 0, 0});
  EXPECT_TRUE(make_view(good, Scene{}, 10, 10));
  expect_usage(looking({1, 2, 3}, {1, 2, 3}), "eye");
  expect_usage(looking({kNan, 2, 3}, {1, 2, 3}), "eye");
  expect_usage(looking({1, 2, 3}, {1, kInfinity, 3}), "target");
  for (const double fov : {0.0, -30.0, 0.99, 170.01, 180.0, kNan}) {
    Camera c = good;
    c.fov_deg = fov;
    expect_usage(c, "field of view");
    c.height = 2;  // unused when orthographic
    EXPECT_TRUE(make_view(c, Scene{}, 10, 10));
  }
  Camera c = good;
  c.near_distance = 40;
  expect_usage(c, "far plane");
  c.far_distance = 3;
  expect_usage(c, "far plane");
}

}  // namespace
}  // namespace blysk
