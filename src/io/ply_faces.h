// io/ply_faces.h - faces of binary files, converted in parallel.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/threads.h"
#include "io/faces.h"
#include "io/ply_header.h"

namespace blysk::io {

[[nodiscard]] bool is_index_list(const PlyProperty& property);

/// The properties that give a face its colour, in the order of the row; empty unless red,
/// green and blue are there.
[[nodiscard]] std::vector<std::size_t> face_color_properties(const PlyElement& element);

/// Rows whose one list is that of the face's vertices, in the types that programs write.
class PlyFaceRows {
 public:
  PlyFaceRows(const PlyElement& element, PlyFormat format, bool with_colors);

  [[nodiscard]] bool usable() const { return usable_; }

  /// Reads all rows from the first bytes of `rows` into `faces`, which must be empty; the number of bytes. 0,
  /// and nothing read, where the rows go on behind the end or a vertex is out of range: reading value by
  /// value tells.
  [[nodiscard]] std::size_t read(std::span<const std::byte> rows, std::uint64_t vertices, Faces& faces,
                                 ThreadPool& pool) const;

 private:
  struct Color {
    int channel;
    PlyType type;
    bool behind_list;
    std::size_t offset;  // from the row, or from the list's end
  };
  struct Plan;

  template <class Count, bool kSwap>
  bool guess(std::span<const std::byte> rows, Plan& plan) const;
  template <class Count, bool kSwap>
  bool scan(std::span<const std::byte> rows, Plan& plan) const;
  template <class Count, class Index, bool kSwap>
  bool fill(const Plan& plan, std::size_t block, const std::byte* rows, std::uint64_t vertices,
            Faces& faces) const;
  template <bool kSwap>
  [[nodiscard]] Vec4f color(const std::byte* row, const std::byte* list_end) const;
  template <class Count, class Index, bool kSwap>
  std::size_t read_as(std::span<const std::byte> rows, std::uint64_t vertices, Faces& faces,
                      ThreadPool& pool) const;

  std::uint64_t count_;
  PlyFormat format_;
  bool usable_ = false;
  PlyType count_type_ = PlyType::uint8, index_type_ = PlyType::int32;
  std::size_t before_ = 0, behind_ = 0;  // bytes of the row beside the list
  std::vector<Color> colors_;
};

}  // namespace blysk::io
