// STL, binary and ASCII. Corners at the same position become one vertex; faces stay flat.
#include <algorithm>
#include <vector>

#include "core/threads.h"
#include "io/polygon.h"
#include "io/reader.h"
#include "io/stl_layout.h"
#include "io/text.h"
#include "scene/weld.h"

namespace blysk::io {
namespace {

constexpr std::size_t kPointsWorthThreads = 60000;

// Memory of a mesh of n triangles, welded: indices, and at worst every corner a vertex and a slot of the
// table.
std::uint64_t memory_for(std::uint64_t triangles) { return triangles * 3 * (4 + 12 + 12 + 32); }

Mesh weld_corners(const PackedPoints& corners, int threads) {
  ThreadPool pool(corners.size() < kPointsWorthThreads ? 1 : threads);
  Welded welded = weld(corners, pool);
  Mesh mesh;
  mesh.positions = std::move(welded.positions);
  mesh.indices = std::move(welded.ids);
  return mesh;
}

void add_mesh(Scene& scene, Mesh mesh) {
  drop_bad_triangles(mesh, scene.problems);
  if (mesh.indices.empty()) return;
  if (scene.materials.empty()) scene.materials.emplace_back();
  Instance instance;
  instance.mesh = static_cast<std::uint32_t>(scene.meshes.size());
  instance.name = mesh.name;
  scene.meshes.push_back(std::move(mesh));
  scene.instances.push_back(std::move(instance));
}

Result<Scene> read_binary(const Source& source) {
  const std::span<const std::byte> bytes = source.bytes;
  if (bytes.size() < kStlHeader)
    return broken(source, "is cut short: a binary STL has 84 bytes before its triangles");
  const std::uint64_t count = stl_count(bytes), held = (bytes.size() - kStlHeader) / kStlTriangle;
  if (count > held) {
    return broken(source, "is cut short: it announces " + std::to_string(count) + " triangles and holds " +
                              std::to_string(held));
  }
  if (Status s = check_limits(source, count, memory_for(count)); !s) return s.error();

  Scene scene;
  if (bytes.size() != kStlHeader + kStlTriangle * count) {
    scene.problems.push_back("ignored " + std::to_string(bytes.size() - kStlHeader - kStlTriangle * count) +
                             " bytes after the last of " + std::to_string(count) + " triangles");
  }
  const PackedPoints corners{bytes.data() + kStlHeader + sizeof(Vec3f), count, 3, kStlTriangle};
  add_mesh(scene, weld_corners(corners, source.options.threads));
  return scene;
}

}  // namespace

Result<Scene> read_stl(const Source& source) { return read_binary(source); }

}  // namespace blysk::io
