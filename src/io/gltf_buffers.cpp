#include "io/gltf_buffers.h"

#include <utility>

#include "io/uri.h"

namespace blysk::io::gltf {

Buffers::Buffers(Context& context, Json root, std::span<const std::byte> bin) : context_(context), bin_(bin) {
  read_buffers(root);
  if (!context_.failed()) read_views(root);
}

void Buffers::read_buffers(Json root) {
  for (const Json& json : context_.list(root, "buffers")) {
    Buffer buffer;
    buffer.json = json;
    context_.require(json, "byteLength");
    buffer.length = context_.whole(json, "byteLength", 0, kMaxWhole, 0);
    buffers_.push_back(std::move(buffer));
  }
}

void Buffers::read_views(Json root) {
  constexpr std::uint64_t kMaxStride = 65536;
  for (const Json& json : context_.list(root, "bufferViews")) {
    View view;
    view.json = json;
    context_.require(json, "buffer");
    context_.require(json, "byteLength");
    view.buffer = context_.index(json, "buffer", buffers_.size(), "buffer");
    view.offset = context_.whole(json, "byteOffset", 0, kMaxWhole, 0);
    view.length = context_.whole(json, "byteLength", 0, kMaxWhole, 0);
    view.stride = context_.whole(json, "byteStride", 0, kMaxStride, 0);
    if (context_.failed()) return;
    const std::uint64_t holds = buffers_[static_cast<std::size_t>(view.buffer)].length;
    if (view.offset + view.length > holds) {
      context_.fail(json, "reaches to byte " + std::to_string(view.offset + view.length) + " of buffers[" +
                              std::to_string(view.buffer) + "], which has " + std::to_string(holds));
      return;
    }
    views_.push_back(view);
  }
}

std::span<const std::byte> Buffers::bytes(int view_index) {
  const View& view = views_[static_cast<std::size_t>(view_index)];
  Buffer& buffer = buffers_[static_cast<std::size_t>(view.buffer)];
  if (!buffer.fetched && !context_.failed()) fetch(buffer);
  if (context_.failed()) return {};
  return buffer.bytes.subspan(view.offset, view.length);
}

void Buffers::fetch(Buffer& buffer) {
  buffer.fetched = true;
  const std::string_view uri = context_.text(buffer.json, "uri");
  if (is_data_uri(uri)) {
    fetch_data_uri(buffer, buffer.json["uri"]);
  } else if (buffer.json["uri"]) {
    fetch_file(buffer, buffer.json["uri"]);
  } else if (&buffer == buffers_.data() && !bin_.empty()) {
    buffer.bytes = bin_;
  } else {
    context_.fail(buffer.json, "has no uri, and there is no BIN chunk for it; export the model again");
  }
  if (!context_.failed() && buffer.bytes.size() < buffer.length) {
    context_.fail(buffer.json, "its data has " + std::to_string(buffer.bytes.size()) +
                                   " bytes, but byteLength says " + std::to_string(buffer.length) +
                                   "; the data is cut short");
  }
}

void Buffers::fetch_data_uri(Buffer& buffer, Json uri) {
  if (!context_.allow(data_uri_bound(uri.text()), uri)) return;
  Result<DataUri> data = decode_data_uri(uri.text());
  if (!data) return context_.fail(uri, data.error().message);
  buffer.decoded = std::move(data->bytes);
  buffer.bytes = std::as_bytes(std::span(buffer.decoded));
}

void Buffers::fetch_file(Buffer& buffer, Json uri) {
  const Source& source = context_.source();
  const Result<std::string> path = relative_path(uri.text());
  if (!path) return context_.fail(uri, path.error().message + ": " + in_quotes(uri.text()));
  if (source.folder.empty()) {
    return context_.fail(
        uri, "needs the file " + in_quotes(*path) +
                 ", but no folder is known to read it from; pass the model as a file, or as one .glb");
  }
  auto known = files_.find(*path);
  if (known == files_.end()) {
    Result<FileBytes> file =
        FileBytes::open((source.folder / *path).string(), source.options.limits.max_memory);
    if (!file) return context_.fail(uri, file.error().text(), file.error().code);
    context_.add_file_bytes(file->bytes().size());
    known = files_.emplace(*path, std::move(*file)).first;
  }
  buffer.bytes = known->second.bytes();
}

}  // namespace blysk::io::gltf
