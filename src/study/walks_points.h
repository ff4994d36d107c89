// study/walks_points.h - walks that decide for a whole triangle how to light it: lighting textures and auto.
#pragma once

#include "shading/lighting_texture_reference.h"
#include "shading/linear_light_reference.h"
#include "shading/row_normals_reference.h"
#include "study/walks_intensity.h"
#include "study/walks_normals.h"

namespace blysk::study {

/// The light of a triangle's points, i steps towards corner 1 and j towards corner 2.
template <class T>
class TexturePoints {
 public:
  /// `normal(i, j)` gives the unit normals.
  template <class Normal>
  TexturePoints(const WalkTriangle<T>& t, int steps, const Normal& normal) : steps_(steps) {
    points_.resize(static_cast<std::size_t>((steps + 1) * (steps + 1)));
    for (int j = 0; j <= steps; ++j) {
      for (int i = 0; i + j <= steps; ++i) points_[index(i, j)] = light_unit(t, normal(i, j));
    }
  }
  [[nodiscard]] int steps() const { return steps_; }
  [[nodiscard]] auto of(T Terms<T>::*term) const {
    return [this, term](int i, int j) { return points_[index(i, j)].*term; };
  }

 private:
  [[nodiscard]] std::size_t index(int i, int j) const {
    return static_cast<std::size_t>(j * (steps_ + 1) + i);
  }

  int steps_;
  std::vector<Terms<T>> points_;
};

/// Pixels of a texture (A-buffer specification, C.7): the diffuse term is clamped when it is fetched.
template <class T, class Out>
void walk_texels(const WalkTriangle<T>& t, const TexturePoints<T>& texture, Out& out) {
  // Shares of corners 1 and 2 are linear: those of vectors (1, 0, 0) and (0, 1, 0).
  const Vec3<T> axes[3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const auto shares = reference::linear_normals<T>(t.corner, axes);
  each_row(t, out, [&](std::size_t r, const PixelRow& row) {
    const Vec3<T> first = at_left(shares, row);
    T u = first.x, v = first.y;
    out.begin(Step::pixel);
    for (int x = 0; x <= row.steps(); ++x) {
      const reference::TextureCellOf<T> cell(texture.steps(), u, v);
      out.put(
          r, x,
          clamped<T>({cell.of(texture.of(&Terms<T>::diffuse)), cell.of(texture.of(&Terms<T>::specular))}));
      u += shares.horizontal.x;
      v += shares.horizontal.y;
    }
  });
}

/// Steps of an edge that the default setting gives the average triangle; the kernel would not take a texture
/// where it does not hold the highlight.
inline constexpr int kAverageSteps = 2;

template <class T, class Out>
void walk_lighting_texture(const WalkTriangle<T>& t, Out& out) {
  out.begin(Step::triangle);
  const reference::TriangleNodesOf<T> nodes(t.normal[0], t.normal[1], t.normal[2], kAverageSteps);
  const TexturePoints<T> texture(t, kAverageSteps, [&](int i, int j) { return nodes.at(i, j); });
  walk_texels(t, texture, out);
}

/// The polygon-shading processor (C.6 - C.8): 17 points an edge, normals by the printed polynomials.
template <class T, class Out>
void walk_printed_texture(const WalkTriangle<T>& t, Out& out) {
  out.begin(Step::triangle);
  const auto make = [](const Vec3<T>& a, const Vec3<T>& b) {
    return reference::chebyshev_row(kChebyshevPaper, a, b);
  };
  const auto block = reference::triangle_block(make, t.normal[0], t.normal[1], t.normal[2]);
  const TexturePoints<T> texture(t, kTextureSteps, [&](int i, int j) {
    return block.node[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
  });
  walk_texels(t, texture, out);
}

/// Errors that auto may make: the default, and any.
inline constexpr double kLargestError = 1.0 / 512, kAnyError = 1e9;

/// docs/auto.md: planes of both terms where they are near enough to Phong shading, which is taken else.
template <class T, class Out>
void walk_auto(const WalkTriangle<T>& t, double max_error, Out& out) {
  out.begin(Step::triangle);
  T n_l[3], n_h[3];
  for (int k = 0; k < 3; ++k) {
    n_l[k] = dot(t.normal[k], t.light);
    n_h[k] = dot(t.normal[k], t.halfway);
  }
  const T bow = reference::largest_bow(t.normal);
  const auto power = [](const T& b) { return reference::fixed_power<kWalkShininess>(b); };
  const T error = reference::diffuse_bound(n_l, bow) +
                  reference::specular_bound(n_h, bow, T(kWalkShininess), T(1), power);
  if (reference::least_of(n_l) <= T(0) || error > T(max_error)) return walk_phong<Lit::both>(t, out);
  walk_planes(t, {{n_l[0], power(n_h[0])}, {n_l[1], power(n_h[1])}, {n_l[2], power(n_h[2])}}, out);
}

}  // namespace blysk::study
