#include "shading/shading_reference.h"

namespace blysk::reference {
namespace {

template <class Value>
auto mix(const std::array<double, 3>& w, Value value) {
  return value(0) * w[0] + value(1) * w[1] + value(2) * w[2];
}

Vec3d compose(const ShadedTriangle& t, const std::array<double, 3>& w, const Intensity& i) {
  const Vec3d color = mix(w, [&](std::size_t k) { return t.corner[k].color; });
  return Vec3d{i.diffuse.x * color.x, i.diffuse.y * color.y, i.diffuse.z * color.z} + i.specular;
}

}  // namespace

std::array<double, 3> weights(const std::array<Corner, 3>& corner, double x, double y) {
  std::array<double, 3> w;
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Corner &a = corner[(k + 1) % 3], &b = corner[(k + 2) % 3];
    w[k] = ((a.x - x) * (b.y - y) - (b.x - x) * (a.y - y)) * corner[k].q;
    sum += w[k];
  }
  for (double& weight : w) weight /= sum;
  return w;
}

Vec3d face_normal(const std::array<Corner, 3>& corner) {
  return cross(corner[1].position - corner[0].position, corner[2].position - corner[0].position);
}

Vec3d flat(const ShadedTriangle& t, const std::array<double, 3>& w) {
  const Vec3d centroid = (t.corner[0].position + t.corner[1].position + t.corner[2].position) * (1.0 / 3);
  return compose(t, w,
                 light_point(t.lighting, centroid, face_normal(t.corner), t.view.towards_viewer(centroid)));
}

Vec3d gouraud(const ShadedTriangle& t, const std::array<double, 3>& w) {
  std::array<Intensity, 3> lit;
  for (std::size_t k = 0; k < 3; ++k) {
    const Corner& c = t.corner[k];
    lit[k] = light_point(t.lighting, c.position, c.normal, t.view.towards_viewer(c.position));
  }
  return compose(t, w, {mix(w, [&](std::size_t k) { return lit[k].diffuse; }), mix(w, [&](std::size_t k) {
                          return lit[k].specular;
                        })});
}

Vec3d phong(const ShadedTriangle& t, const std::array<double, 3>& w, Vec3d position) {
  const Vec3d normal = mix(w, [&](std::size_t k) { return t.corner[k].normal; });
  return compose(t, w, light_point(t.lighting, position, normal, t.view.towards_viewer(position)));
}

}  // namespace blysk::reference
