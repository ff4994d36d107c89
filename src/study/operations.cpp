#include "study/operations.h"

#include <algorithm>

#include "math/trig.h"
#include "study/walks_intensity.h"
#include "study/walks_normals.h"
#include "study/walks_points.h"
#include "study/walks_rows.h"

namespace blysk::study {
namespace {

template <class F>
constexpr Walk walk(std::string_view name, std::string_view method, std::string_view title, F) {
  return {name,
          method,
          title,
          [](const WalkTriangle<Counted>& t, CountedPixels& out) { F{}(t, out); },
          [](const WalkTriangle<float>& t, Pixels<float>& out) { F{}(t, out); },
          [](const WalkTriangle<double>& t, Pixels<double>& out) { F{}(t, out); }};
}

constexpr Walk kWalks[] = {
    walk("phong", "phong", "dot products made unit, one root and one division",
         [](const auto& t, auto& out) { walk_phong<Lit::both>(t, out); }),
    walk("phong-diffuse", "phong", "the diffuse term alone",
         [](const auto& t, auto& out) { walk_phong<Lit::diffuse>(t, out); }),
    walk("phong-full", "phong", "all vectors made unit at every pixel, three colours",
         [](const auto& t, auto& out) { walk_phong_full(t, out); }),
    walk("flat", "flat", "", [](const auto& t, auto& out) { walk_flat(t, out); }),
    walk("gouraud", "gouraud", "a division for every row and term",
         [](const auto& t, auto& out) { walk_gouraud(t, out); }),
    walk("gouraud-constant", "gouraud-constant", "one increment for all rows",
         [](const auto& t, auto& out) { walk_gouraud_constant(t, out); }),
    walk("quadratic", "quadratic", "forward differences",
         [](const auto& t, auto& out) { walk_quadratic(t, out); }),
    walk("cubic", "cubic", "forward differences",
         [](const auto& t, auto& out) { walk_cubic<CubicForm::differences>(t, out); }),
    walk("cubic-horner", "cubic", "Horner's form",
         [](const auto& t, auto& out) { walk_cubic<CubicForm::horner>(t, out); }),
    walk("symmetric", "symmetric", "two pixels from one root by shifts",
         [](const auto& t, auto& out) { walk_symmetric<Root::shift, Lit::both>(t, out); }),
    walk("symmetric-diffuse", "symmetric", "the diffuse term alone, by shifts",
         [](const auto& t, auto& out) { walk_symmetric<Root::shift, Lit::diffuse>(t, out); }),
    walk("symmetric-exact", "symmetric", "two pixels from one exact root",
         [](const auto& t, auto& out) { walk_symmetric<Root::exact, Lit::both>(t, out); }),
    walk("symmetric-chebyshev", "symmetric", "two pixels from the printed Chebyshev parabola",
         [](const auto& t, auto& out) { walk_symmetric<Root::chebyshev, Lit::both>(t, out); }),
    walk("angular", "angular", "cosines by Chebyshev's recurrence",
         [](const auto& t, auto& out) { walk_angular(t, out); }),
    walk("fast-normalize", "fast-normalize", "squared length by additions, then the parabola",
         [](const auto& t, auto& out) { walk_fast_normalize(t, out); }),
    walk("dichotomy-half-sum", "dichotomy",
         "odd pixels by the parabola, even ones half the sum of their neighbours",
         [](const auto& t, auto& out) { walk_half_sum(t, out); }),
    walk("barycentric", "barycentric", "a parabola of vectors along the row",
         [](const auto& t, auto& out) { walk_barycentric(t, out); }),
    walk("parallel", "parallel", "one polynomial for a row",
         [](const auto& t, auto& out) { walk_parallel(t, out); }),
    walk("parallel-nines", "parallel", "nine pixels at a time by the printed Chebyshev polynomials",
         [](const auto& t, auto& out) { walk_nines(t, out); }),
    walk("lighting-texture", "lighting-texture", "6 points: 4 pixels apart, as the default has it",
         [](const auto& t, auto& out) { walk_lighting_texture(t, out); }),
    walk("lighting-texture-17", "lighting-texture", "153 points by three blocks of 9 x 9, as printed",
         [](const auto& t, auto& out) { walk_printed_texture(t, out); }),
    walk("auto", "auto", "the bound, then phong: a triangle that does not fit",
         [](const auto& t, auto& out) { walk_auto(t, kLargestError, out); }),
    walk("auto-planes", "auto", "the bound, then planes: a triangle that fits",
         [](const auto& t, auto& out) { walk_auto(t, kAnyError, out); }),
};

template <class T>
Vec3<T> inputs(const Vec3d& v) {
  return {input<T>(v.x), input<T>(v.y), input<T>(v.z)};
}

template <class T>
WalkTriangle<T> make_triangle(double turn) {
  WalkTriangle<T> t;
  t.rows = kAverageRows;
  for (int k = 0; k < 3; ++k) {
    t.corner[k] = {input<T>(kAverageCorners[k][0]), input<T>(kAverageCorners[k][1])};
    const double angle = radians(360) * (turn + k / 3.0), tilt = radians(11.5);
    t.normal[k] = inputs<T>(
        normalize(Vec3d{sine(tilt) * cosine(angle) + 0.1, sine(tilt) * sine(angle) - 0.05, cosine(tilt)}));
  }
  const Vec3d light = normalize(Vec3d{0.3, 0.5, 1});
  t.light = inputs<T>(light);
  t.halfway = inputs<T>(normalize(light + Vec3d{0, 0, 1}));
  return t;
}

}  // namespace

std::span<const Walk> walks() { return kWalks; }

const Walk& find_walk(std::string_view name) {
  return *std::find_if(std::begin(kWalks), std::end(kWalks), [&](const Walk& w) { return w.name == name; });
}

template <>
WalkTriangle<double> average_triangle<double>(double turn) {
  return make_triangle<double>(turn);
}
template <>
WalkTriangle<float> average_triangle<float>(double turn) {
  return make_triangle<float>(turn);
}
template <>
WalkTriangle<Counted> average_triangle<Counted>(double turn) {
  return make_triangle<Counted>(turn);
}

StepCounts count_operations(const Walk& walk) {
  const WalkTriangle<Counted> t = average_triangle<Counted>();
  CountedPixels out(t.rows);
  walk.count(t, out);
  return out.counts();
}

Operations count_two_pixels(const Walk& walk) {
  // Rows that differ by two pixels differ by two passes of the loop; odd ones end in no pixel of its own.
  const auto of_row = [&](int steps) {
    WalkTriangle<Counted> t = average_triangle<Counted>();
    const PixelRow row[] = {{8, 0, steps}};
    t.rows = row;
    CountedPixels out(t.rows);
    walk.count(t, out);
    return out.counts().pixel;
  };
  return of_row(13) - of_row(11);
}

Operations count_row(QuadraticForm form, std::size_t pixels) {
  const auto in = [](double v) { return Counted::input(v); };
  const reference::SecondOrderSurfaceOf<Counted> surface = {in(-0.0022), in(-0.0015), in(0.0011),
                                                            in(0.013),   in(0.021),   in(0.45)};
  std::vector<Counted> row(pixels);
  const Operations before = operations_so_far();
  reference::quadratic_row<Counted>(form, surface, in(-5), in(6), row);
  return operations_so_far() - before;
}

Operations count_normalisation(Normalisation way) {
  const Vec3<Counted> n = inputs<Counted>({0.52, 0.31, 0.63});
  const Vec3<Counted> step = inputs<Counted>({0.01, 0.02, -0.01});
  reference::SquaredLengthsOf<Counted> k(n, step);
  const Operations before = operations_so_far();
  switch (way) {
    case Normalisation::root:
      static_cast<void>(normalize(n));
      break;
    case Normalisation::three_divisions: {
      const Counted l = length(n);
      const Vec3<Counted> unit = {n.x / l, n.y / l, n.z / l};
      static_cast<void>(unit);
      break;
    }
    case Normalisation::polynomial:
      static_cast<void>(reference::normalize_fast(kInverseLengthPaper, n));
      break;
    case Normalisation::recurrence:
      k.next();
      static_cast<void>(n * reference::inverse_length(kInverseLengthPaper, k.value()));
      break;
  }
  return operations_so_far() - before;
}

Operations count_unit_vectors(UnitVectors way) {
  const Vec3<Counted> n = inputs<Counted>({0.52, 0.31, 0.63}), step = inputs<Counted>({0.01, 0.02, -0.01});
  const Vec3<Counted> before = inputs<Counted>({0.6, 0.3, 0.7});
  const Operations start = operations_so_far();
  if (way == UnitVectors::combined) {
    static_cast<void>(n + step);
    static_cast<void>((before + n) * Counted(0.5));
    Operations sum = operations_so_far() - start;
    sum += count_normalisation(Normalisation::recurrence);
    return sum;
  }
  for (int pixel = 0; pixel < 2; ++pixel) static_cast<void>(n + step);
  Operations sum = operations_so_far() - start;
  for (int pixel = 0; pixel < 2; ++pixel) sum += count_normalisation(Normalisation::three_divisions);
  return sum;
}

Operations count_lobe(CountedLobe lobe) {
  const Counted c = Counted::input(0.97);
  constexpr int n = 50;  // no power of two, which would make shifts of products
  const Operations before = operations_so_far();
  switch (lobe) {
    case CountedLobe::power:
      static_cast<void>(reference::fixed_power<n>(c));
      break;
    case CountedLobe::schlick:
      static_cast<void>(reference::schlick_lobe(c, n));
      break;
    case CountedLobe::w16:
      static_cast<void>(reference::fixed_w_lobe<16>(c, reference::w_shift_scale(n, 16)));
      break;
  }
  return operations_so_far() - before;
}

}  // namespace blysk::study
