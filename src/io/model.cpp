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

void add_normals(Scene& scene, double crease_deg, const ModelOptions& options) {
  std::size_t largest = 0;
  for (const Mesh& mesh : scene.meshes) largest = std::max(largest, mesh.triangles());
  ThreadPool pool(largest < kTrianglesWorthThreads ? 1 : options.threads);
  for (Mesh& mesh : scene.meshes) {
    if (mesh.normals.empty()) make_normals(mesh, crease_deg, pool);
  }
}

// Programs of Windows put one in front of any text. The header of a binary STL may begin with anything.
Source without_byte_order_mark(const Source& source) {
  constexpr std::string_view kMark = "\xef\xbb\xbf";
  constexpr std::size_t kBytesLooked = 512;
  const std::string_view start = source.text().substr(0, kBytesLooked);
  Source bare = source;
  if (start.starts_with(kMark) && start.find('\0') == std::string_view::npos)
    bare.bytes = bare.bytes.subspan(kMark.size());
  return bare;
}

Result<Scene> load(const Source& source) {
  const Result<Format> format = io::find_format(source.bytes, source.name);
  if (!format) return format.error();
  Result<Scene> scene = read(*format, source);
  if (!scene) return scene;

  const ModelOptions& options = source.options;
  const std::uint64_t triangles = scene->triangles();
  if (triangles == 0 && !options.may_be_empty) {
    constexpr std::size_t kMostReasons = 3;
    std::string why;
    for (std::size_t i = 0; i < std::min(kMostReasons, scene->problems.size()); ++i) {
      why += (i == 0 ? ": " : "; ") + scene->problems[i];
    }
    return broken(source, "has no triangles to draw" + why + "; `blysk info` tells what is in it");
  }
  if (Status s = check_limits(source, triangles, bytes_of(*scene)); !s) return s.error();
  const bool flat = *format == Format::stl || *format == Format::gltf;
  add_normals(*scene, options.crease_deg.value_or(flat ? 0 : ModelOptions::kCreaseDeg), options);
  return scene;
}

}  // namespace

Result<Scene> load_model(std::span<const std::byte> bytes, std::string_view name,
                         const std::filesystem::path& folder, const ModelOptions& options) {
  const Source source{bytes, std::string(name), folder, options};
  try {
    return load(without_byte_order_mark(source));
  } catch (const std::bad_alloc&) {
    return Error{ErrorCode::limit, "needs more memory than there is; free some, or take a smaller model",
                 source.name};
  } catch (const std::length_error&) {
    return Error{ErrorCode::limit, "needs more memory than there can be; take a smaller model", source.name};
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
