// lighting/lighting_reference.h - the lighting models as the specification writes them.
//
// What the kernels are measured against: thesis, formula (2.1) and section 2.1 of the specification. The
// number type is double unless operations are counted.
#pragma once

#include <algorithm>
#include <vector>

#include "blysk/scene.h"
#include "lighting/lamp.h"
#include "lighting/lobe_reference.h"

namespace blysk::reference {

/// Unit vectors at a point.
template <class T>
struct DirectionsOf {
  Vec3<T> normal, light, viewer;
};
using Directions = DirectionsOf<double>;

/// R.V of R = 2(N.L)N - L.
template <class T = double>
T cos_reflected(const DirectionsOf<T>& d) {
  const Vec3<T> reflected = d.normal * (2 * dot(d.normal, d.light)) - d.light;
  return dot(reflected, d.viewer);
}

/// N.H of H = (L + V)/|L + V|; 0 where L + V is 0.
template <class T = double>
T cos_halfway(const DirectionsOf<T>& d) {
  const Vec3<T> sum = d.light + d.viewer;
  const T l = length(sum);
  return l > T(1e-9) ? dot(d.normal, sum) / l : T(0);
}

/// The lobe at the model's angle; 0 where the light is behind the surface.
template <class T = double>
T specular(LightingModel model, const DirectionsOf<T>& d, double n, Lobe lobe = Lobe::power) {
  if (model == LightingModel::lambert || !(dot(d.normal, d.light) > T(0))) return T(0);
  const T c = model == LightingModel::blinn ? cos_halfway(d) : cos_reflected(d);
  return specular_lobe(lobe, std::min(c, T(1)), n);
}

/// What lights a draw.
struct Lighting {
  LightingModel model = LightingModel::blinn;
  Material material;
  std::vector<Light> lights;
  double ambient = 0;  ///< Ia
  Lobe lobe = Lobe::power;
};

/// Light that leaves a point, apart: vertex colours multiply the diffuse part only.
template <class T>
struct IntensityOf {
  Vec3<T> diffuse;   ///< ambient and diffuse
  Vec3<T> specular;  ///< specular and emission
};
using Intensity = IntensityOf<double>;

template <class T>
Vec3<T> multiply(const Vec3<T>& a, const Vec3<T>& b) {
  return {a.x * b.x, a.y * b.y, a.z * b.z};
}

template <class T, class U>
Vec3<T> number_cast(const Vec3<U>& v) {
  return {T(double{v.x}), T(double{v.y}), T(double{v.z})};
}

/// `normal` and `viewer` (towards it) of any length; the side that faces the viewer is lit.
template <class T = double>
IntensityOf<T> light_point(const Lighting& lighting, const Vec3<T>& position, const Vec3<T>& normal,
                           const Vec3<T>& viewer) {
  const Material& m = lighting.material;
  const Vec3<T> kd = number_cast<T>(m.color), ks = number_cast<T>(m.specular);
  if (m.unlit) return {kd, number_cast<T>(m.emission)};
  DirectionsOf<T> d;
  d.viewer = normalize(viewer);
  d.normal = normalize(normal);
  if (dot(d.normal, d.viewer) < T(0)) d.normal = -d.normal;

  IntensityOf<T> sum = {kd * T(lighting.ambient), number_cast<T>(m.emission)};
  for (const Light& light : lighting.lights) {
    const Vec3<T> vector = number_cast<T>(light.vector);
    d.light = normalize(light.kind == Light::Kind::point ? vector - position : vector);
    const Vec3<T> il = number_cast<T>(light.color);
    sum.diffuse = sum.diffuse + multiply(il, kd) * std::max(T(0), dot(d.normal, d.light));
    sum.specular =
        sum.specular +
        multiply(il, ks) * specular(lighting.model, d, static_cast<double>(m.shininess), lighting.lobe);
  }
  return sum;
}

}  // namespace blysk::reference
