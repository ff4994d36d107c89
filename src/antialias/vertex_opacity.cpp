#include "antialias/vertex_opacity.h"

#include <algorithm>
#include <bit>

#include "antialias/sample_patterns.h"

namespace blysk {
namespace {

double unit(float v) { return v > 0 ? double{std::min(v, 1.0f)} : 0.0; }  // not a number: 0

// The mean place of samples from a pixel's centre, in subpixels.
Vec2<double> centroid(antialias::Mask mask) {
  const antialias::SamplePattern& grid = antialias::kGrid16;
  if (mask == grid.full() || mask == 0) return {0, 0};
  int x = 0, y = 0;
  for (antialias::Mask left = mask; left != 0; left &= left - 1) {
    const auto s = static_cast<std::size_t>(std::countr_zero(left));
    x += grid.x[s];
    y += grid.y[s];
  }
  const double count = antialias::samples_in(mask);
  return {x / count, y / count};
}

// Homogeneous corners, as a triangle has that is clipped.
void unplace(const VertexOpacity& draw, const std::uint32_t* corner, TriangleOpacity& t) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3f& p = draw.positions[corner[k]];
    const auto row = [&](int i) {
      const float* m = draw.projection.row[i];
      return double{m[0]} * double{p.x} + double{m[1]} * double{p.y} + double{m[2]} * double{p.z} +
             double{m[3]};
    };
    t.x[k] = row(0);
    t.y[k] = row(1);
    t.w[k] = row(3);
    t.q[k] = 1;
  }
}

}  // namespace

TriangleOpacity triangle_opacity(const VertexOpacity& draw, const ScreenVertex* vertices, std::uint32_t id) {
  const std::uint32_t* const corner = draw.indices + std::size_t{3} * (id - draw.id_base);
  TriangleOpacity t;
  bool placed = true;
  for (std::size_t k = 0; k < 3; ++k) {
    const ScreenVertex& v = vertices[std::size_t{draw.vertex_base} + corner[k]];
    placed = placed && v.x != kUnplaced;
    t.x[k] = v.x;
    t.y[k] = v.y;
    t.w[k] = 1;
    t.q[k] = draw.screen_linear ? 1 : double{v.q};
    t.alpha[k] = unit(draw.colors[corner[k]].w);
  }
  if (!placed) unplace(draw, corner, t);
  t.factor = draw.factor;
  t.cutoff = draw.cutoff;
  t.mask = draw.mask;
  return t;
}

float opacity_at(const TriangleOpacity& t, int column, int row, std::uint32_t mask) {
  const Vec2<double> from = centroid(mask);
  return opacity_at(t, {column * double{kSubpixels} + kSubpixels / 2.0 + from.x,
                        row * double{kSubpixels} + kSubpixels / 2.0 + from.y});
}

float opacity_at(const TriangleOpacity& t, Vec2<double> place) {
  double dx[3], dy[3];
  for (int k = 0; k < 3; ++k) {
    dx[k] = t.x[k] - t.w[k] * place.x;
    dy[k] = t.y[k] - t.w[k] * place.y;
  }
  double sum = 0, mixed = 0;
  for (int k = 0; k < 3; ++k) {
    const int a = (k + 1) % 3, b = (k + 2) % 3;
    const double weight = (dx[a] * dy[b] - dx[b] * dy[a]) * t.q[k];
    sum += weight;
    mixed += weight * t.alpha[k];
  }
  const auto [low, high] = std::minmax({t.alpha[0], t.alpha[1], t.alpha[2]});
  const double alpha = sum != 0 ? std::clamp(mixed / sum, low, high) : low;
  const float opacity = static_cast<float>(alpha * double{t.factor});
  if (t.mask) return opacity >= t.cutoff ? 1.0f : 0.0f;
  return opacity;
}

}  // namespace blysk
