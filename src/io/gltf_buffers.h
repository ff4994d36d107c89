// io/gltf_buffers.h - buffers and buffer views: from the GLB's BIN chunk, data: URIs and files beside the
// model.
#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "blysk/array.h"
#include "io/gltf_context.h"

namespace blysk::io::gltf {

/// Buffers are fetched when the first view of theirs is asked for, so that what is not drawn need not be
/// there.
class Buffers {
 public:
  /// Checks what the document says of buffers and views against each other. `bin`: the BIN chunk, empty if
  /// none.
  Buffers(Context& context, Json root, std::span<const std::byte> bin);

  [[nodiscard]] std::size_t views() const { return views_.size(); }
  /// All bytes of a view; empty after a failure. They live as long as this object or the source.
  [[nodiscard]] std::span<const std::byte> bytes(int view);
  /// Distance of elements that the view asks for; 0: they are packed.
  [[nodiscard]] std::uint64_t stride(int view) const { return views_[static_cast<std::size_t>(view)].stride; }

 private:
  struct Buffer {
    Json json;
    std::uint64_t length = 0;
    bool fetched = false;
    std::span<const std::byte> bytes;
    Array<std::uint8_t> decoded;  // of a data: URI
  };
  struct View {
    Json json;
    int buffer = kNone;
    std::uint64_t offset = 0, length = 0, stride = 0;
  };

  void read_buffers(Json root);
  void read_views(Json root);
  void fetch(Buffer& buffer);
  void fetch_data_uri(Buffer& buffer, Json uri);
  void fetch_file(Buffer& buffer, Json uri);

  Context& context_;
  std::span<const std::byte> bin_;
  std::vector<Buffer> buffers_;
  std::vector<View> views_;
  std::map<std::string, FileBytes> files_;  // by path: buffers may share one
};

}  // namespace blysk::io::gltf
