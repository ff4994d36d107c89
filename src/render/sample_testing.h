// render/sample_testing.h - random triangles whose samples are known to the last bit of coverage.
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

#include "raster/coverage_reference.h"
#include "render/testing.h"

namespace blysk {

inline constexpr int kCrowdWidth = 90, kCrowdHeight = 75;

inline RenderOptions sample_options(int scale = 1) {
  RenderOptions o;
  o.width = kCrowdWidth * scale;
  o.height = kCrowdHeight * scale;
  o.camera = pixel_camera(kCrowdHeight);
  o.cull = Cull::none;
  o.transfer = Transfer::none;
  o.antialias = scale == 1 ? "abuffer" : "none";
  o.background = {0.25f, 0.5f, 0.125f, 1};
  o.want_id = o.want_depth = true;
  return o;
}

// Corners in 1/1024 pixel, multiples of 4: samples of the picture are pixel centres of one four times as
// large, in whose 1/256 pixels all is given.
struct Crowd {
  Scene scene;
  std::vector<reference::Triangle> triangles;
  std::vector<Vec3f> colors;
};

inline reference::Place random_place(Random& random, Vec2<double> around, double reach) {
  const auto move = [&] { return uniform(random, -reach, reach); };
  const auto snap = [](double v) { return std::llrint(v / 4) * 4; };
  const std::int64_t x = snap(around.x + move()), y = snap(around.y + move());
  return {x, y, static_cast<float>(whole(random, 1, 1 << 20)) * 0x1p-20f};
}

inline Vec3f position_of(const reference::Place& p) {
  return {static_cast<float>(p.x - kCrowdWidth * 512) / 1024,
          static_cast<float>(kCrowdHeight * 512 - p.y) / 1024, p.nearness * 2 - 1};
}

// Of a size between two binary orders, in 1/1024 pixel.
inline reference::Triangle random_triangle(Random& random, double least, double most) {
  const Vec2<double> c = {uniform(random, 0, kCrowdWidth * 1024), uniform(random, 0, kCrowdHeight * 1024)};
  const double reach = std::pow(2.0, uniform(random, least, most));  // deterministic: any size will do
  const reference::Place a = random_place(random, c, reach), b = random_place(random, c, reach);
  return {{a, b, random_place(random, c, reach)}};
}

inline void add_triangle(Crowd& crowd, Mesh& mesh, const reference::Triangle& t, Vec3f color) {
  for (const reference::Place& p : t.corner) {
    mesh.indices.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
    mesh.positions.push_back(position_of(p));
    mesh.colors.push_back(Vec4f{color.x, color.y, color.z, 1});
  }
  crowd.triangles.push_back(t);
  crowd.colors.push_back(color);
}

inline Crowd random_crowd(Random& random, int count, double least, double most) {
  Crowd crowd;
  Mesh mesh;
  for (int i = 0; i < count; ++i) {
    const auto channel = [&] { return static_cast<float>(uniform(random, 0, 1)); };
    const Vec3f color = {channel(), channel(), channel()};
    add_triangle(crowd, mesh, random_triangle(random, least, most), color);
  }
  Material plain;
  plain.color = {1, 1, 1};
  plain.unlit = true;
  crowd.scene.add(std::move(mesh), plain);
  return crowd;
}

inline double channel(std::uint32_t pixel, int c) { return (pixel >> 8 * c & 255) / 255.0; }

}  // namespace blysk
