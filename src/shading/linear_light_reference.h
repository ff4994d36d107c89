// shading/linear_light_reference.h - the bound of docs/auto.md where light and viewer are at infinity and the
// picture is linear on the screen: perspective and the viewer's turn add nothing there. In double precision
// unless operations are counted.
#pragma once

#include <algorithm>

#include "blysk/vector.h"

namespace blysk::reference {

template <class T>
T least_of(const T (&v)[3]) {
  return std::min(std::min(v[0], v[1]), v[2]);
}
template <class T>
T most_of(const T (&v)[3]) {
  return std::max(std::max(v[0], v[1]), v[2]);
}

/// How much interpolation shortens the normals of a triangle at most, of its length: `normal` are unit.
template <class T>
T largest_bow(const Vec3<T> (&normal)[3]) {
  const Vec3<T> d01 = normal[1] - normal[0], d12 = normal[2] - normal[1], d20 = normal[0] - normal[2];
  const T chords[3] = {dot(d01, d01), dot(d12, d12), dot(d20, d20)};
  return T(0.18) * most_of(chords);
}

/// What two reciprocal roots in single precision turn a cosine by.
inline constexpr double kRootShift = 2.5e-6;

/// Of linear N.L between its values at the corners, all of them positive.
template <class T>
T diffuse_bound(const T (&n_l)[3], const T& bow) {
  return bow * most_of(n_l);
}

/// Of a linear lobe between its values at the corners, whose N.H are given: base^exponent, base = 1 -
/// scale * (1 - N.H). `power(b)` is b^exponent.
template <class Power, class T>
T specular_bound(const T (&n_h)[3], const T& bow, const T& exponent, const T& scale, Power power) {
  const T range = most_of(n_h) - least_of(n_h);
  const T highest = std::min((most_of(n_h) + T(kRootShift)) * (1 + bow), T(1));
  const T base = std::max(1 - scale * (1 - highest), T(0.25));
  const T bend = T(0.125) * (exponent - 1) * scale * (range * range);
  return power(base) * (exponent * scale) / (base * base) * (std::max(bow, bend) + T(1.1) * T(kRootShift));
}

}  // namespace blysk::reference
