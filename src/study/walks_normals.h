// study/walks_normals.h - walks that light a normal at every pixel.
#pragma once

#include "lighting/lighting_reference.h"
#include "shading/normals_reference.h"
#include "study/walk.h"

namespace blysk::study {

/// Phong shading with the two dot products made unit instead of the vector (section 3.3).
template <Lit kLit, class T, class Out>
void walk_phong(const WalkTriangle<T>& t, Out& out) {
  using std::sqrt;
  out.begin(Step::triangle);
  const auto normals = reference::linear_normals<T>(t.corner, t.normal);
  each_row(t, out, [&](std::size_t r, const PixelRow& row) {
    Vec3<T> n = at_left(normals, row);
    out.begin(Step::pixel);
    for (int x = 0; x <= row.steps(); ++x) {
      out.put(r, x, light_scaled<kLit>(t, n, 1 / sqrt(dot(n, n))));
      n = n + normals.horizontal;
    }
  });
}

/// Phong shading as table 4.4 has it: normal, light and viewer interpolated, all vectors made unit, three
/// colours. Only the first of them is put.
template <class T, class Out>
void walk_phong_full(const WalkTriangle<T>& t, Out& out) {
  reference::Lighting lighting;
  lighting.ambient = 0.15;
  lighting.material.color = {0.75f, 0.7f, 0.65f};
  lighting.material.specular = {0.45f, 0.4f, 0.35f};
  lighting.material.shininess = kWalkShininess;
  lighting.lights = {Light{}};
  lighting.lights[0].color = {0.9f, 0.85f, 0.8f};
  lighting.lights[0].kind = Light::Kind::point;
  lighting.lights[0].vector = {0, 0, 0};  // the interpolated vector leads from the light: -L
  out.begin(Step::triangle);
  const Vec3<T> viewer = t.halfway * (2 * dot(t.halfway, t.light)) - t.light;
  const auto normals = reference::linear_normals<T>(t.corner, t.normal);
  const auto from_light = reference::linear_normals<T>(t.corner, {-t.light, -t.light, -t.light});
  const auto to_viewer = reference::linear_normals<T>(t.corner, {viewer, viewer, viewer});
  each_row(t, out, [&](std::size_t r, const PixelRow& row) {
    Vec3<T> n = at_left(normals, row), l = at_left(from_light, row), v = at_left(to_viewer, row);
    out.begin(Step::pixel);
    for (int x = 0; x <= row.steps(); ++x) {
      const auto i = reference::light_point<T>(lighting, l, n, v);
      const Vec3<T> sum = i.diffuse + i.specular;
      out.put(r, x, {sum.x, sum.y});
      n = n + normals.horizontal;
      l = l + from_light.horizontal;
      v = v + to_viewer.horizontal;
    }
  });
}

/// The paper's polynomial in the squared length, which is found by additions (relief specification 2.2, 2.3).
template <class T, class Out>
void walk_fast_normalize(const WalkTriangle<T>& t, Out& out) {
  out.begin(Step::triangle);
  const auto normals = reference::linear_normals<T>(t.corner, t.normal);
  each_row(t, out, [&](std::size_t r, const PixelRow& row) {
    Vec3<T> n = at_left(normals, row);
    reference::SquaredLengthsOf<T> k(n, normals.horizontal);
    out.begin(Step::pixel);
    for (int x = 0; x <= row.steps(); ++x) {
      out.put(r, x, light_scaled(t, n, reference::inverse_length<T>(kInverseLengthPaper, k.value())));
      n = n + normals.horizontal;
      k.next();
    }
  });
}

/// Odd pixels made unit by the polynomial, even ones half the sum of their neighbours (relief specification
/// 2.6 with 2.1, 2.2 and 2.3: the combined methods of unit vectors).
template <class T, class Out>
void walk_half_sum(const WalkTriangle<T>& t, Out& out) {
  out.begin(Step::triangle);
  const auto normals = reference::linear_normals<T>(t.corner, t.normal);
  const Vec3<T> two_steps = normals.horizontal * T(2);
  const auto unit = [&](const Vec3<T>& n, const T& k) {
    return n * reference::inverse_length<T>(kInverseLengthPaper, k);
  };
  const auto lit = [&](const Vec3<T>& n) { return clamped(light_unit(t, n)); };
  each_row(t, out, [&](std::size_t r, const PixelRow& row) {
    Vec3<T> raw = at_left(normals, row);
    reference::SquaredLengthsOf<T> k(raw, two_steps);
    out.begin(Step::pixel);
    Vec3<T> before = unit(raw, k.value());
    out.put(r, 0, lit(before));
    int x = 1;
    for (; x < row.steps(); x += 2) {
      raw = raw + two_steps;
      k.next();
      const Vec3<T> after = unit(raw, k.value());
      out.put(r, x, lit((before + after) * T(0.5)));
      out.put(r, x + 1, lit(after));
      before = after;
    }
    if (x == row.steps()) {  // no neighbour on the right
      raw = raw + normals.horizontal;
      out.put(r, x, lit(unit(raw, dot(raw, raw))));
    }
  });
}

/// Six additions a pixel: along a row the form of six vectors is a parabola (relief specification 2.4).
template <class T, class Out>
void walk_barycentric(const WalkTriangle<T>& t, Out& out) {
  out.begin(Step::triangle);
  const reference::SixVectorsOf<T> form(kMidVectorPaper, t.normal);
  // Barycentric coordinates of corners 0 and 1 are linear: those of vectors (1, 0, 0) and (0, 1, 0).
  const Vec3<T> axes[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const auto c = reference::linear_normals<T>(t.corner, axes);
  each_row(t, out, [&](std::size_t r, const PixelRow& row) {
    const Vec3<T> c0 = at_left(c, row);
    const Vec3<T> c1 = c0 + c.horizontal, c2 = c1 + c.horizontal;
    Vec3<T> n = form.at(c0.x, c0.y);
    const Vec3<T> second = form.at(c1.x, c1.y);
    Vec3<T> step = second - n;
    const Vec3<T> bend = form.at(c2.x, c2.y) - second - step;
    out.begin(Step::pixel);
    for (int x = 0; x <= row.steps(); ++x) {
      out.put(r, x, clamped(light_unit(t, n)));
      n = n + step;
      step = step + bend;
    }
  });
}

}  // namespace blysk::study
