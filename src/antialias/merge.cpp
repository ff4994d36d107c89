#include "antialias/merge.h"

#include <algorithm>
#include <cmath>

namespace blysk::antialias {
namespace {

struct Paint {
  Vec3d rgb;
  double alpha = 1;
};

// The mean colour over the union where each covers what is behind it by its opacity.
Paint mixed(const Fragment& a, const Fragment& b, const SamplePattern& pattern) {
  const Vec3d ca = to_double(a.rgb), cb = to_double(b.rgb);
  const double all = samples_in(a.mask | b.mask);
  if (a.opaque() && b.opaque() && (a.mask & b.mask) == 0) {
    return {(ca * samples_in(a.mask) + cb * samples_in(b.mask)) * (1 / all), 1};
  }
  const double oa = double{a.alpha}, ob = double{b.alpha};
  const Mask both = a.mask & b.mask, a_first = both == 0 ? 0 : visibility(a, b, pattern) & both;
  const double only_a = samples_in(a.mask & ~both), only_b = samples_in(b.mask & ~both),
               a_over_b = samples_in(a_first), b_over_a = samples_in(both & ~a_first);
  const double weight_a = oa * (only_a + a_over_b + b_over_a * (1 - ob)),
               weight_b = ob * (only_b + b_over_a + a_over_b * (1 - oa));
  const double through = only_a * (1 - oa) + only_b * (1 - ob) + (a_over_b + b_over_a) * (1 - oa) * (1 - ob);
  const double alpha = 1 - through / all;
  if (!(alpha > 0)) return {{}, 0};
  return {(ca * weight_a + cb * weight_b) * (1 / (all * alpha)), alpha};
}

PixelPlane by_coverage(const Fragment& a, const Fragment& b, double weight_of_b, bool larger) {
  const double z = double{a.z} + (double{b.z} - double{a.z}) * weight_of_b;
  if (larger) {
    const Fragment& most = samples_in(b.mask) > samples_in(a.mask) ? b : a;
    return {z, double{most.zx}, double{most.zy}};
  }
  return {z, double{std::abs(a.zx) >= std::abs(b.zx) ? b.zx : a.zx},
          double{std::abs(a.zy) >= std::abs(b.zy) ? b.zy : a.zy}};
}

PixelPlane plane_of(const Fragment& a, const Fragment& b, MergedPlane plane, const SamplePattern& pattern) {
  if (plane == MergedPlane::least_squares) return least_squares_plane(a, b, pattern);
  const double ka = samples_in(a.mask), kb = samples_in(b.mask);
  const double out_of = plane == MergedPlane::printed ? static_cast<double>(pattern.count) : ka + kb;
  return by_coverage(a, b, kb / out_of, plane == MergedPlane::larger);
}

}  // namespace

PixelPlane least_squares_plane(const Fragment& f, const Fragment& g, const SamplePattern& pattern) {
  double k = 0, a = 0, b = 0, aa = 0, bb = 0, ab = 0, z = 0, az = 0, bz = 0;
  for (const Fragment* one : {&f, &g}) {
    for (Mask left = one->mask; left != 0; left &= left - 1) {
      const auto s = static_cast<std::size_t>(std::countr_zero(left));
      const double sa = double{pattern.a[s]}, sb = double{pattern.b[s]};
      const double depth = double{one->z} + sa * double{one->zx} + sb * double{one->zy};
      k += 1;
      a += sa;
      b += sb;
      aa += sa * sa;
      bb += sb * sb;
      ab += sa * sb;
      z += depth;
      az += sa * depth;
      bz += sb * depth;
    }
  }
  constexpr double kRidge = 0.001;  // one sample, or samples in a line, have a plane too
  const double a11 = aa + kRidge - a * a / k, a22 = bb + kRidge - b * b / k, a12 = ab - a * b / k;
  const double b1 = az - a * z / k, b2 = bz - b * z / k, d = a11 * a22 - a12 * a12;
  const double zx = (b1 * a22 - b2 * a12) / d, zy = (a11 * b2 - a12 * b1) / d;
  return {(z - zx * a - zy * b) / k, zx, zy};
}

double ward_cost(const Fragment& a, const Fragment& b, const SamplePattern& pattern) {
  const double ka = samples_in(a.mask), kb = samples_in(b.mask);
  const double dz = double{a.z} - double{b.z}, dzx = double{a.zx} - double{b.zx},
               dzy = double{a.zy} - double{b.zy};
  double sum = 0;
  const Mask either = a.mask | b.mask;
  for (Mask left = either; left != 0; left &= left - 1) {
    const auto s = static_cast<std::size_t>(std::countr_zero(left));
    const double apart = dz + double{pattern.a[s]} * dzx + double{pattern.b[s]} * dzy;
    sum += apart * apart;
  }
  return ka * kb / (ka + kb) * (sum / samples_in(either));
}

Fragment merge(const Fragment& a, const Fragment& b, MergedPlane plane, const SamplePattern& pattern) {
  const PixelPlane p = plane_of(a, b, plane, pattern);
  Paint paint = mixed(a, b, pattern);
  if (plane == MergedPlane::printed) {
    const double share = static_cast<double>(samples_in(a.mask | b.mask));
    paint.rgb = paint.rgb * (share / static_cast<double>(pattern.count));
  }
  return {.mask = a.mask | b.mask,
          .rgb = to_float(paint.rgb),
          .z = static_cast<float>(p.z),
          .zx = static_cast<float>(p.zx),
          .zy = static_cast<float>(p.zy),
          .alpha = static_cast<float>(paint.alpha),
          .id = std::min(a.id, b.id),
          .object = a.object,
          .lit = true};
}

}  // namespace blysk::antialias
