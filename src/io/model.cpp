#include "blysk/model.h"

#include <new>
#include <stdexcept>

#include "blysk/shapes.h"
#include "core/threads.h"
#include "io/format.h"
#include "io/reader.h"
#include "scene/normals.h"

namespace blysk {
namespace {

using io::Format;
using io::Source;

Result<Scene> read(Format format, const Source& source) {
  switch (format) {
    case Format::obj:
      return io::read_obj(source);
    case Format::stl:
      return io::read_stl(source);
    case Format::ply:
      return io::read_ply(source);
    case Format::off:
      return io::read_off(source);
    case Format::gltf:
      return io::read_gltf(source);
  }
  return Error{ErrorCode::internal, "a format without a reader", source.name};
}

template <class T>
std::uint64_t bytes_of(const Array<T>& array) {
  return array.size() * sizeof(T);
}

std::uint64_t bytes_of(const Scene& scene) {
  std::uint64_t bytes = 0;
  for (const Mesh& m : scene.meshes) {
    bytes += bytes_of(m.positions) + bytes_of(m.normals) + bytes_of(m.colors) + bytes_of(m.texcoords) +
             bytes_of(m.texcoords1) + bytes_of(m.tangents) + bytes_of(m.indices);
  }
  for (const TextureReference& t : scene.textures) bytes += bytes_of(t.bytes);
  return bytes;
}

void add_normals(Scene& scene, const ModelOptions& options) {
  std::size_t largest = 0;
  for (const Mesh& mesh : scene.meshes) largest = std::max(largest, mesh.triangles());
  ThreadPool pool(largest < kTrianglesWorthThreads ? 1 : options.threads);
  for (Mesh& mesh : scene.meshes) {
    if (mesh.normals.empty()) make_normals(mesh, options.crease_deg, pool);
  }
}

Result<Scene> load(const Source& source) {
  const Result<Format> format = io::find_format(source.bytes, source.name);
  if (!format) return format.error();
  Result<Scene> scene = read(*format, source);
  if (!scene) return scene;

  const std::uint64_t triangles = scene->triangles();
  if (triangles == 0) {
    const std::string why = scene->problems.empty() ? "" : " (" + scene->problems.front() + ")";
    return broken(source, "has no triangles, so there is nothing to draw" + why);
  }
  if (Status s = check_limits(source, triangles, bytes_of(*scene)); !s) return s.error();
  // The faces of STL and glTF without normals are flat by definition.
  if (*format != Format::stl && *format != Format::gltf) add_normals(*scene, source.options);
  return scene;
}

}  // namespace

Result<Scene> load_model(std::span<const std::byte> bytes, std::string_view name,
                         const std::filesystem::path& folder, const ModelOptions& options) {
  const Source source{bytes, std::string(name), folder, options};
  try {
    return load(source);
  } catch (const std::bad_alloc&) {
    return Error{ErrorCode::limit, "needs more memory than there is", source.name};
  } catch (const std::length_error&) {
    return Error{ErrorCode::limit, "needs more memory than there can be", source.name};
  }
}

Result<Scene> load_model(const std::string& path, const ModelOptions& options) {
  if (path.starts_with("shape:")) return make_shape(path);
  const Result<io::FileBytes> file = io::FileBytes::open(path, options.limits.max_memory);
  if (!file) return file.error();
  if (path == "-") return load_model(file->bytes(), "standard input", {}, options);
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  return load_model(file->bytes(), path, folder.empty() ? "." : folder, options);
}

}  // namespace blysk
