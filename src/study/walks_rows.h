// study/walks_rows.h - walks along a row between its two unit end normals: chapters 3.1 and 3.2 of the
// thesis, and the per-fragment paper's rows.
#pragma once

#include "shading/normals_reference.h"
#include "shading/row_normals_reference.h"
#include "shading/symmetric_reference.h"
#include "study/walk.h"

namespace blysk::study {

/// 1 / sqrt(1 + m) for m in -0.5..0 (section 6.3).
enum class Root { exact, taylor, chebyshev, shift };

template <Root kRoot, class T>
T inverse_root(const T& m) {
  if constexpr (kRoot == Root::exact) return reference::exact_root_of(m);
  if constexpr (kRoot == Root::taylor) return reference::taylor_root_of(m);
  if constexpr (kRoot == Root::chebyshev) return reference::chebyshev_root_of(m);
  if constexpr (kRoot == Root::shift) return reference::shift_root_of(m);
}

/// Rows from their unit end normals; those of one pixel are lit at once.
template <class T, class Out, class Row>
void each_row_between(const WalkTriangle<T>& t, Out& out, const Row& between) {
  out.begin(Step::triangle);
  const auto normals = reference::linear_normals<T>(t.corner, t.normal);
  each_row(t, out, [&](std::size_t r, const PixelRow& row) {
    const Vec3<T> a = normalize(at_left(normals, row));
    if (row.steps() == 0) {
      out.put(r, 0, clamped(light_unit(t, a)));
      return;
    }
    between(r, row, a, normalize(at_right(normals, row)));
  });
}

/// A dot product with the row's linear normals, from both ends.
template <class T>
struct Numerator {
  T left{}, right{}, step{};

  Numerator() = default;
  Numerator(const Vec3<T>& a, const Vec3<T>& b, const Vec3<T>& with, const T& steps)
      : left(dot(a, with)), right(dot(b, with)), step((right - left) / steps) {}
  void next() {
    left += step;
    right -= step;
  }
};

template <Lit kLit = Lit::both, class T>
Terms<T> from_dots(const T& diffuse, const T& specular) {
  if constexpr (kLit == Lit::diffuse) return {std::max(T(0), diffuse), T(0)};
  return {std::max(T(0), diffuse), reference::fixed_power<kWalkShininess>(std::max(T(0), specular))};
}

/// Two pixels from one root, no division in the loop (section 6.2).
template <Root kRoot, Lit kLit, class T, class Out>
void walk_symmetric(const WalkTriangle<T>& t, Out& out) {
  each_row_between(t, out, [&](std::size_t r, const PixelRow& row, const Vec3<T>& a, const Vec3<T>& b) {
    const T steps = row_number<T>(row.steps());
    const T s = (2 * dot(a, b) - 2) / steps, c = -s / steps;
    const T bend = 2 * c;
    T m = T(0), step = c + s;
    Numerator<T> diffuse(a, b, t.light, steps), specular{};
    if constexpr (kLit == Lit::both) specular = Numerator<T>(a, b, t.halfway, steps);
    out.begin(Step::pixel);
    for (int x = 0; 2 * x <= row.steps(); ++x) {
      const T root = inverse_root<kRoot>(m);
      const auto lit = [&](const T& with_light, const T& with_halfway) {
        if constexpr (kLit == Lit::diffuse) return from_dots<kLit>(with_light * root, T(0));
        return from_dots(with_light * root, with_halfway * root);
      };
      out.put(r, x, lit(diffuse.left, specular.left));
      if (2 * x < row.steps()) out.put(r, row.steps() - x, lit(diffuse.right, specular.right));
      m += step;
      step += bend;
      diffuse.next();
      if constexpr (kLit == Lit::both) specular.next();
    }
  });
}

/// sin and cos of a small angle.
template <class T>
struct SmallAngle {
  T sine, cosine;

  explicit SmallAngle(const T& angle) {
    const T q = angle * angle;
    sine = angle * (1 - q * T(1.0 / 6) * (1 - q * T(1.0 / 20) * (1 - q * T(1.0 / 42))));
    cosine = 1 - q / 2 * (1 - q * T(1.0 / 12) * (1 - q * T(1.0 / 30) * (1 - q * T(1.0 / 56))));
  }
};

/// cos v along an arc of equal angle steps: C(t + 1) = 2 cos(step) C(t) - C(t - 1).
template <class T>
struct ArcCosine {
  T at, next_at;

  /// `a` and `b` are its values at the arc's ends.
  ArcCosine(const T& a, const T& b, const T& cosine, const T& sine, const SmallAngle<T>& step)
      : at(a), next_at(a * step.cosine + (b - a * cosine) / sine * step.sine) {}
  void next(const T& twice_cosine) {
    const T after = twice_cosine * next_at - at;
    at = next_at;
    next_at = after;
  }
};

/// Angular interpolation, form cheb of section 7.4. Where the ends are parallel the dots are linear.
template <class T, class Out>
void walk_angular(const WalkTriangle<T>& t, Out& out) {
  using std::sqrt;
  each_row_between(t, out, [&](std::size_t r, const PixelRow& row, const Vec3<T>& a, const Vec3<T>& b) {
    const T steps = row_number<T>(row.steps()), cosine = dot(a, b);
    const T square = 1 - cosine * cosine;
    if (square <= T(1e-7)) {
      Numerator<T> diffuse(a, b, t.light, steps), specular(a, b, t.halfway, steps);
      out.begin(Step::pixel);
      for (int x = 0; x <= row.steps(); ++x) {
        out.put(r, x, from_dots(diffuse.left, specular.left));
        diffuse.next();
        specular.next();
      }
      return;
    }
    // arccos without loss of digits for small angles (section 8.1)
    const T z = 2 - 2 * cosine;
    const T phi =
        sqrt(z) * (T(0.999954859) + z * (T(0.042325762) + z * (T(0.003225090) + z * T(0.001645482))));
    const SmallAngle<T> step(phi / steps);
    const T sine = sqrt(square), twice = 2 * step.cosine;
    ArcCosine<T> diffuse(dot(a, t.light), dot(b, t.light), cosine, sine, step);
    ArcCosine<T> specular(dot(a, t.halfway), dot(b, t.halfway), cosine, sine, step);
    out.begin(Step::pixel);
    for (int x = 0; x <= row.steps(); ++x) {
      out.put(r, x, from_dots(diffuse.at, specular.at));
      diffuse.next(twice);
      specular.next(twice);
    }
  });
}

/// One polynomial of the place between the ends of a row (ours, for the per-fragment paper's of nine pixels).
template <class T, class Out>
void walk_parallel(const WalkTriangle<T>& t, Out& out) {
  each_row_between(t, out, [&](std::size_t r, const PixelRow& row, const Vec3<T>& a, const Vec3<T>& b) {
    const reference::ArcOf<T> arc(a, b);
    const T step = 2 / row_number<T>(row.steps());
    T place = T(-1);
    out.begin(Step::pixel);
    for (int x = 0; x <= row.steps(); ++x) {
      out.put(r, x, clamped(light_unit(t, arc.at(place))));
      place += step;
    }
  });
}

/// Nine pixels at a time by the printed Chebyshev polynomials; what is left of a row by the general form.
template <class T, class Out>
void walk_nines(const WalkTriangle<T>& t, Out& out) {
  out.begin(Step::triangle);
  const auto normals = reference::linear_normals<T>(t.corner, t.normal);
  const Vec3<T> eight_steps = normals.horizontal * T(8);
  each_row(t, out, [&](std::size_t r, const PixelRow& row) {
    Vec3<T> raw = at_left(normals, row);
    Vec3<T> a = normalize(raw);
    out.begin(Step::pixel);
    out.put(r, 0, clamped(light_unit(t, a)));
    for (int x = 0; x < row.steps(); x += 8) {
      const int rest = std::min(row.steps() - x, 8);
      out.begin(Step::row);
      raw = rest == 8 ? raw + eight_steps : raw + normals.horizontal * row_number<T>(rest);
      const Vec3<T> b = normalize(raw);
      if (rest == 8) {
        const auto nine = reference::chebyshev_row(kChebyshevPaper, a, b);
        out.begin(Step::pixel);
        for (int k = 1; k <= 8; ++k) out.put(r, x + k, clamped(light_unit(t, nine[std::size_t(k)])));
      } else {
        const reference::ArcOf<T> arc(a, b);
        const T step = 2 / row_number<T>(rest);
        T place = T(-1);
        out.begin(Step::pixel);
        for (int k = 1; k <= rest; ++k) {
          place += step;
          out.put(r, x + k, clamped(light_unit(t, arc.at(place))));
        }
      }
      a = b;
    }
  });
}

}  // namespace blysk::study
