// io/reader.h - what every model reader is given and gives: one file per format.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "blysk/model.h"
#include "blysk/result.h"
#include "blysk/scene.h"

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

// Readers leave normals empty where the file has none; load_model() makes them afterwards with
// make_normals(mesh, crease_deg), except for STL and glTF, whose faces are flat by definition.
[[nodiscard]] Result<Scene> read_obj(const Source& source);
[[nodiscard]] Result<Scene> read_stl(const Source& source);
[[nodiscard]] Result<Scene> read_ply(const Source& source);
[[nodiscard]] Result<Scene> read_off(const Source& source);
[[nodiscard]] Result<Scene> read_gltf(const Source& source);  // .gltf and .glb

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
  bool mapped_ = false;
};

/// Removes triangles with an index out of range, a repeated or coinciding corner, or a corner that is not finite, and
/// says so in `problems` ("mesh NAME: left out 12 degenerate and 1 non-finite triangles").
void drop_bad_triangles(Mesh& mesh, std::vector<std::string>& problems);

}  // namespace blysk::io
