// io/reader.h - what every model reader is given and gives: one file per format.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "blysk/model.h"
#include "blysk/result.h"
#include "blysk/scene.h"
#include "core/threads.h"

namespace blysk::io {

/// A model file in memory.
struct Source {
  std::span<const std::byte> bytes;
  std::string name;              ///< for messages: the path as the user gave it
  std::filesystem::path folder;  ///< where files named by the model are looked for; empty: nowhere
  ModelOptions options;

  [[nodiscard]] std::string_view text() const {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
  }
};

// Readers leave normals empty where the file has none; load_model() makes them afterwards. A file without
// faces is no error to them: Scene::problems says what it has instead.
[[nodiscard]] Result<Scene> read_obj(const Source& source);
[[nodiscard]] Result<Scene> read_stl(const Source& source);
[[nodiscard]] Result<Scene> read_ply(const Source& source);
[[nodiscard]] Result<Scene> read_off(const Source& source);
[[nodiscard]] Result<Scene> read_gltf(const Source& source);  // .gltf and .glb

/// ErrorCode::limit where the caller's limits do not allow so much; asked before memory is taken.
[[nodiscard]] Status check_limits(const Source& source, std::uint64_t triangles, std::uint64_t bytes);

/// ErrorCode::limit where the corners of a mesh could not be numbered in 32 bits.
[[nodiscard]] Status check_index_width(const Source& source, std::uint64_t triangles);

/// "NAME: message", ErrorCode::input.
[[nodiscard]] Error broken(const Source& source, std::string message);
/// "NAME:LINE: message" with the line that `offset` lies in.
[[nodiscard]] Error broken_at(const Source& source, std::size_t offset, std::string message);

/// Bytes of a file, mapped where possible; lives as long as the object.
class FileBytes {
 public:
  FileBytes() = default;
  ~FileBytes();
  FileBytes(FileBytes&& other) noexcept;
  FileBytes& operator=(FileBytes&& other) noexcept;

  /// "-" reads standard input. Folders, missing and unreadable files are ErrorCode::input;
  /// more than max_bytes is ErrorCode::limit.
  [[nodiscard]] static Result<FileBytes> open(const std::string& path, std::uint64_t max_bytes);
  [[nodiscard]] std::span<const std::byte> bytes() const { return bytes_; }

 private:
  std::span<const std::byte> bytes_;
  std::size_t mapped_ = 0;  // length of the mapping that begins at bytes_.data()
};

/// Removes triangles whose area in double precision is zero, and those with a corner that is not finite, and
/// says so in `problems` ("mesh NAME: left out 12 degenerate and 1 non-finite triangles"). All indices must
/// be in range. Removes the vertices that no triangle uses, so that a stray point cannot push a model out of
/// its frame.
void drop_bad_triangles(Mesh& mesh, std::vector<std::string>& problems, ThreadPool& pool);
void drop_bad_triangles(Mesh& mesh, std::vector<std::string>& problems);  // in the caller's thread

}  // namespace blysk::io
