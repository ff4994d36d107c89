#include "blysk/scene.h"

#include <algorithm>

namespace blysk {

void Scene::add(Mesh mesh, Material material, const Mat4& transform) {
  Instance instance;
  instance.mesh = static_cast<std::uint32_t>(meshes.size());
  instance.material = static_cast<std::uint32_t>(materials.size());
  instance.transform = transform;
  instance.name = mesh.name;
  meshes.push_back(std::move(mesh));
  materials.push_back(std::move(material));
  instances.push_back(std::move(instance));
}

void Scene::append(Scene other) {
  const auto mesh0 = static_cast<std::uint32_t>(meshes.size());
  const auto material0 = static_cast<std::uint32_t>(materials.size());
  const auto texture0 = static_cast<int>(textures.size());
  const auto move_all = [](auto& to, auto& from) {
    to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
  };
  for (Instance& i : other.instances) {
    i.mesh += mesh0;
    i.material += material0;
  }
  for (Material& m : other.materials) {
    if (m.color_texture >= 0) m.color_texture += texture0;
    if (m.normal_texture >= 0) m.normal_texture += texture0;
  }
  move_all(meshes, other.meshes);
  move_all(materials, other.materials);
  move_all(textures, other.textures);
  move_all(instances, other.instances);
  move_all(lights, other.lights);
  move_all(cameras, other.cameras);
  move_all(problems, other.problems);
}

Bounds Scene::bounds() const {
  std::vector<Bounds> local(meshes.size());
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    Vec3f lo{3e38f, 3e38f, 3e38f}, hi{-3e38f, -3e38f, -3e38f};
    for (const Vec3f& p : meshes[i].positions) {
      lo = {std::min(lo.x, p.x), std::min(lo.y, p.y), std::min(lo.z, p.z)};
      hi = {std::max(hi.x, p.x), std::max(hi.y, p.y), std::max(hi.z, p.z)};
    }
    if (!meshes[i].positions.empty()) {
      local[i].add(to_double(lo));
      local[i].add(to_double(hi));
    }
  }
  Bounds all;
  for (const Instance& instance : instances) {
    const Bounds& b = local[instance.mesh];
    if (b.empty()) continue;
    for (int corner = 0; corner < 8; ++corner) {
      all.add(transform_point(instance.transform,
                              {(corner & 1) != 0 ? b.hi.x : b.lo.x, (corner & 2) != 0 ? b.hi.y : b.lo.y,
                               (corner & 4) != 0 ? b.hi.z : b.lo.z}));
    }
  }
  return all;
}

std::uint64_t Scene::triangles() const {
  std::uint64_t n = 0;
  for (const Instance& i : instances) n += meshes[i.mesh].triangles();
  return n;
}

}  // namespace blysk
