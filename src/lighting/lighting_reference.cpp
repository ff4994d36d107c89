#include "lighting/lighting_reference.h"

#include <algorithm>

#include "lighting/lobe_reference.h"

namespace blysk::reference {
namespace {

Vec3d multiply(Vec3d a, Vec3d b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }

}  // namespace

double cos_reflected(const Directions& d) {
  const Vec3d reflected = d.normal * (2 * dot(d.normal, d.light)) - d.light;
  return dot(reflected, d.viewer);
}

double cos_halfway(const Directions& d) {
  const Vec3d sum = d.light + d.viewer;
  const double l = length(sum);
  return l > 1e-9 ? dot(d.normal, sum) / l : 0;
}

double specular(LightingModel model, const Directions& d, double n, Lobe lobe) {
  if (model == LightingModel::lambert || !(dot(d.normal, d.light) > 0)) return 0;
  const double c = model == LightingModel::blinn ? cos_halfway(d) : cos_reflected(d);
  return specular_lobe(lobe, std::min(c, 1.0), n);
}

Intensity light_point(const Lighting& lighting, Vec3d position, Vec3d normal, Vec3d viewer) {
  const Material& m = lighting.material;
  const Vec3d kd = to_double(m.color), ks = to_double(m.specular);
  if (m.unlit) return {kd, to_double(m.emission)};
  Directions d;
  d.viewer = normalize(viewer);
  d.normal = normalize(normal);
  if (dot(d.normal, d.viewer) < 0) d.normal = -d.normal;

  Intensity sum = {kd * lighting.ambient, to_double(m.emission)};
  for (const Light& light : lighting.lights) {
    d.light = normalize(light.kind == Light::Kind::point ? light.vector - position : light.vector);
    const Vec3d il = to_double(light.color);
    sum.diffuse = sum.diffuse + multiply(il, kd) * std::max(0.0, dot(d.normal, d.light));
    sum.specular =
        sum.specular +
        multiply(il, ks) * specular(lighting.model, d, static_cast<double>(m.shininess), lighting.lobe);
  }
  return sum;
}

}  // namespace blysk::reference
