// study/walks_intensity.h - walks that light some points of a triangle and interpolate what they found.
#pragma once

#include "shading/cubic_reference.h"
#include "shading/gouraud_constant_reference.h"
#include "shading/normals_reference.h"
#include "shading/quadratic_reference.h"
#include "study/walk.h"

namespace blysk::study {

template <class T, class Out>
void walk_flat(const WalkTriangle<T>& t, Out& out) {
  out.begin(Step::triangle);
  const Terms<T> lit = clamped(light_unit(t, normalize(t.normal[0] + t.normal[1] + t.normal[2])));
  out.begin(Step::pixel);
  for (std::size_t r = 0; r < t.rows.size(); ++r) {
    for (int x = 0; x <= t.rows[r].steps(); ++x) out.put(r, x, lit);
  }
}

/// Along the edges, then between them with a division for every row.
template <class T, class Out>
void walk_gouraud(const WalkTriangle<T>& t, Out& out) {
  struct Edge {
    Terms<T> at, step;
  };
  out.begin(Step::triangle);
  Terms<T> lit[3];
  for (int k = 0; k < 3; ++k) lit[k] = light_unit(t, t.normal[k]);
  const auto edge = [&](int from, int to) {
    const T rows = t.corner[to].y - t.corner[from].y;
    return Edge{
        lit[from],
        {(lit[to].diffuse - lit[from].diffuse) / rows, (lit[to].specular - lit[from].specular) / rows}};
  };
  Edge upper = edge(0, 1), lower = edge(1, 2), across = edge(0, 2);
  each_row(t, out, [&](std::size_t r, const PixelRow& row) {
    Edge& left = row.y < kAverageCorners[1][1] ? upper : lower;
    Terms<T> at = left.at, step{};
    if (row.steps() > 0) {
      const T steps = row_number<T>(row.steps());
      step = {(across.at.diffuse - at.diffuse) / steps, (across.at.specular - at.specular) / steps};
    }
    left.at += left.step;
    across.at += across.step;
    out.begin(Step::pixel);
    for (int x = 0; x <= row.steps(); ++x) {
      out.put(r, x, clamped(at));
      at += step;
    }
  });
}

/// The plane through the light of the corners: one increment for all rows.
template <class T, class Out>
void walk_planes(const WalkTriangle<T>& t, const Terms<T> (&lit)[3], Out& out) {
  std::array<reference::LitCornerOf<T>, 3> diffuse, specular;
  for (std::size_t k = 0; k < 3; ++k) {
    diffuse[k] = {t.corner[k].x, t.corner[k].y, lit[k].diffuse};
    specular[k] = {t.corner[k].x, t.corner[k].y, lit[k].specular};
  }
  const auto d = reference::constant_increments<T>(diffuse), s = reference::constant_increments<T>(specular);
  const Terms<T> step = {d.dx, s.dx}, down = {d.dy, s.dy};
  Terms<T> below_corner = lit[0];
  each_row(t, out, [&](std::size_t r, const PixelRow& row) {
    const T right = row_number<T>(row.left) - t.corner[0].x;
    Terms<T> at = {below_corner.diffuse + right * step.diffuse,
                   below_corner.specular + right * step.specular};
    below_corner += down;
    out.begin(Step::pixel);
    for (int x = 0; x <= row.steps(); ++x) {
      out.put(r, x, clamped(at));
      at += step;
    }
  });
}

template <class T, class Out>
void walk_gouraud_constant(const WalkTriangle<T>& t, Out& out) {
  out.begin(Step::triangle);
  walk_planes(t, {light_unit(t, t.normal[0]), light_unit(t, t.normal[1]), light_unit(t, t.normal[2])}, out);
}

/// Forward differences of the second-order surface (form fwd of section 4.3).
template <class T, class Out>
void walk_quadratic(const WalkTriangle<T>& t, Out& out) {
  out.begin(Step::triangle);
  const Vec3<T>* n = t.normal;
  const Terms<T> i1 = light_unit(t, n[0]), i2 = light_unit(t, n[1]), i3 = light_unit(t, n[2]);
  const Terms<T> i12 = light_unit(t, normalize(n[0] + n[1])), i13 = light_unit(t, normalize(n[0] + n[2])),
                 i23 = light_unit(t, normalize(n[1] + n[2]));
  const Vec2<T> p2 = {t.corner[1].x - t.corner[0].x, t.corner[1].y - t.corner[0].y};
  const Vec2<T> p3 = {t.corner[2].x - t.corner[0].x, t.corner[2].y - t.corner[0].y};
  const auto surface = [&](T Terms<T>::*term) {
    return reference::second_order_surface<T>(
        p2, p3, {i1.*term, i2.*term, i3.*term, i12.*term, i13.*term, i23.*term});
  };
  const auto diffuse = surface(&Terms<T>::diffuse), specular = surface(&Terms<T>::specular);
  const Terms<T> bend = {2 * diffuse.a, 2 * specular.a};
  each_row(t, out, [&](std::size_t r, const PixelRow& row) {
    const T x0 = row_number<T>(row.left) - t.corner[0].x, y0 = row_number<T>(row.y) - t.corner[0].y;
    Terms<T> at = {diffuse.at(x0, y0), specular.at(x0, y0)};
    Terms<T> step = {diffuse.difference(x0, y0), specular.difference(x0, y0)};
    out.begin(Step::pixel);
    for (int x = 0; x <= row.steps(); ++x) {
      out.put(r, x, clamped(at));
      at += step;
      step += bend;
    }
  });
}

/// What a row's two cubics are made of; the middle normals are made unit, as the row's ends are.
template <class T>
struct RowCubics {
  reference::RowCubicOf<T> diffuse, specular;

  RowCubics(const WalkTriangle<T>& t, const Vec3<T>& a, const Vec3<T>& b) {
    const Vec3<T> way = b - a;
    const Terms<T> i1 = light_unit(t, normalize(a)), i2 = light_unit(t, normalize(b)),
                   i3 = light_unit(t, normalize(a + way * T(0.5))),
                   i4 = light_unit(t, normalize(a + way * T(0.25)));
    diffuse = reference::row_cubic<T>({i1.diffuse, i2.diffuse, i3.diffuse, i4.diffuse});
    specular = reference::row_cubic<T>({i1.specular, i2.specular, i3.specular, i4.specular});
  }
};

/// Three differences of a cubic over steps of h.
template <class T>
struct CubicSteps {
  T at, first, second, third;

  CubicSteps(const reference::RowCubicOf<T>& i, const T& h) : at(i.d) {
    const T cube = i.a * h * h * h, square = i.b * h * h;
    third = 6 * cube;
    first = cube + square + i.c * h;
    second = third + 2 * square;
  }
  void next() {
    at += first;
    first += second;
    second += third;
  }
};

enum class CubicForm { differences, horner };

/// A cubic through the light of four points of a row; rows of up to four pixels are lit pixel by pixel.
template <CubicForm kForm, class T, class Out>
void walk_cubic(const WalkTriangle<T>& t, Out& out) {
  out.begin(Step::triangle);
  const auto normals = reference::linear_normals<T>(t.corner, t.normal);
  each_row(t, out, [&](std::size_t r, const PixelRow& row) {
    if (row.steps() < 4) {
      Vec3<T> n = at_left(normals, row);
      out.begin(Step::pixel);
      for (int x = 0; x <= row.steps(); ++x) {
        out.put(r, x, clamped(light_unit(t, normalize(n))));
        n = n + normals.horizontal;
      }
      return;
    }
    const RowCubics<T> i(t, at_left(normals, row), at_right(normals, row));
    const T h = 1 / row_number<T>(row.steps());
    if constexpr (kForm == CubicForm::horner) {
      T p = T(0);
      out.begin(Step::pixel);
      for (int x = 0; x <= row.steps(); ++x) {
        out.put(r, x, clamped<T>({i.diffuse.at(p), i.specular.at(p)}));
        p += h;
      }
    } else {
      CubicSteps<T> diffuse(i.diffuse, h), specular(i.specular, h);
      out.begin(Step::pixel);
      for (int x = 0; x <= row.steps(); ++x) {
        out.put(r, x, clamped<T>({diffuse.at, specular.at}));
        diffuse.next();
        specular.next();
      }
    }
  });
}

}  // namespace blysk::study
