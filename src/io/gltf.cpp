// glTF 2.0 and its binary form GLB, after the Khronos specification 2.0.1.
//
// Differs in: morph targets are left at their base and skins in the pose they were modelled in; pictures are
// kept but not read; points and lines are left out.
#include <algorithm>
#include <array>
#include <cstring>
#include <new>
#include <optional>
#include <utility>

#include "io/gltf_accessor.h"
#include "io/gltf_buffers.h"
#include "io/gltf_cameras.h"
#include "io/gltf_context.h"
#include "io/gltf_materials.h"
#include "io/gltf_meshes.h"
#include "io/gltf_nodes.h"
#include "io/gltf_skins.h"
#include "io/json.h"
#include "io/reader.h"

namespace blysk::io {
namespace {

using gltf::Context;

// The parts of a file.
struct Container {
  std::string_view json;
  std::span<const std::byte> bin;
};

std::uint32_t little_endian(std::span<const std::byte> bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value |= std::to_integer<std::uint32_t>(bytes[at + i]) << (8 * i);
  return value;
}

bool is_glb(const Source& source) { return source.text().starts_with("glTF"); }

// Header of 12 bytes, then chunks of a length, a type and their data; the first is JSON, the second may be
// BIN.
Result<Container> split_glb(const Source& source) {
  constexpr std::uint32_t kJson = 0x4e4f534a, kBin = 0x004e4942;
  constexpr std::size_t kHeader = 12, kChunkHeader = 8;
  std::span<const std::byte> bytes = source.bytes;
  const auto cut_short = [&](std::uint64_t wanted) {
    return broken(source, "the GLB file is cut short: " + std::to_string(wanted) + " bytes are announced, " +
                              std::to_string(source.bytes.size()) + " are there; fetch it again");
  };
  if (bytes.size() < kHeader + kChunkHeader) return cut_short(kHeader + kChunkHeader);
  const std::uint32_t version = little_endian(bytes, 4), length = little_endian(bytes, 8);
  if (version != 2) {
    return broken(source,
                  "GLB version " + std::to_string(version) + " is not read, only 2; export as glTF 2.0");
  }
  if (length > bytes.size()) return cut_short(length);
  if (length < kHeader + kChunkHeader)
    return broken(source,
                  "the GLB header gives a length of " + std::to_string(length) + "; export the model again");
  bytes = bytes.first(length);

  Container container;
  for (std::size_t at = kHeader, number = 0; at + kChunkHeader <= length; ++number) {
    const std::uint32_t size = little_endian(bytes, at), type = little_endian(bytes, at + 4);
    const std::size_t data = at + kChunkHeader;
    if (size > length - data) {
      return broken(source, "the GLB chunk at byte " + std::to_string(at) + " has " + std::to_string(size) +
                                " bytes, but only " + std::to_string(length - data) +
                                " follow; fetch or export it again");
    }
    if (number == 0) {
      if (type != kJson)
        return broken(source, "the first chunk of the GLB file is not JSON; export the model again");
      container.json = source.text().substr(data, size);
    } else if (type == kBin && container.bin.empty()) {
      container.bin = bytes.subspan(data, size);
    }
    at = data + size;
  }
  // Chunks are padded with spaces, by some exporters with zeros.
  const std::size_t last = container.json.find_last_not_of('\0');
  container.json = container.json.substr(0, last == std::string_view::npos ? 0 : last + 1);
  return container;
}

void check_version(Context& context, Json root) {
  if (root.kind() != Json::Kind::object || !root["asset"]) {
    return context.fail(root, "the file has no \"asset\" object, which every glTF file begins with");
  }
  const Json asset = context.object(root, "asset");
  context.require(asset, "version");
  const std::string_view version = context.text(asset, "version");
  if (!context.failed() && !version.starts_with("2.")) {
    context.fail(asset["version"],
                 "glTF " + gltf::in_quotes(version) + " is not read, only 2.0; export as glTF 2.0");
  }
  const std::string_view least = context.text(asset, "minVersion");
  if (!least.empty() && least != "2.0") {
    context.fail(asset["minVersion"],
                 "the file needs a reader of glTF " + gltf::in_quotes(least) + "; this one reads 2.0");
  }
}

// Extensions of looks change no shape: without them a picture is still right in its outlines.
bool is_about_looks(std::string_view name) {
  return name.starts_with("KHR_materials_") || name.starts_with("KHR_texture_") ||
         name.starts_with("EXT_texture_");
}

void check_extensions(Context& context, Json root) {
  constexpr std::array<std::string_view, 4> kKnown{"KHR_lights_punctual", "KHR_materials_unlit",
                                                   "KHR_mesh_quantization", "KHR_texture_transform"};
  std::string missing;
  for (const Json& json : context.list(root, "extensionsRequired")) {
    const std::string_view name = json.text();
    if (std::find(kKnown.begin(), kKnown.end(), name) != kKnown.end()) continue;
    if (is_about_looks(name)) {
      context.problem(json, gltf::in_quotes(name) + " is not supported; surfaces may look different");
    } else if (missing.size() < 200) {
      missing += (missing.empty() ? "" : ", ") + gltf::in_quotes(name);
    }
  }
  if (!missing.empty()) {
    context.fail(root["extensionsRequired"], "the file cannot be read without " + missing +
                                                 "; export it without compression and required extensions");
  }
}

// What a file without meshes has: "nodes: 2, cameras: 1".
std::string list_of_contents(Context& context, Json root) {
  std::string text;
  for (const char* what : {"nodes", "cameras", "skins", "animations", "materials", "images", "accessors"}) {
    const std::size_t count = context.list(root, what).size();
    if (count > 0) text += (text.empty() ? "" : ", ") + std::string(what) + ": " + std::to_string(count);
  }
  return text.empty() ? "nothing else" : text;
}

std::string_view name_of(const gltf::Placement& placement, const gltf::Primitive& primitive) {
  return placement.name.empty() ? std::string_view(primitive.name) : placement.name;
}

// What the placements ask for, before any of it is read.
void check_size(Context& context, gltf::Meshes& meshes, const std::vector<gltf::Placement>& placements) {
  std::uint64_t triangles = 0;
  for (const gltf::Placement& placement : placements) {
    if (placement.mesh == gltf::kNone) continue;
    for (const gltf::Primitive& primitive : meshes.primitives(placement.mesh)) {
      triangles += std::min(primitive.triangles, gltf::kMaxWhole - std::min(triangles, gltf::kMaxWhole));
      if (!context.allow(sizeof(Instance) + name_of(placement, primitive).size(), placement.json)) return;
    }
    if (context.failed()) return;
  }
  if (const Status status = check_limits(context.source(), triangles, 0); !status)
    context.fail(status.error());
}

void add_instances(Context& context, gltf::Meshes& meshes, const std::vector<gltf::Placement>& placements,
                   Scene& scene) {
  std::optional<std::uint32_t> default_index;
  for (const gltf::Placement& placement : placements) {
    if (placement.mesh == gltf::kNone) continue;
    for (const gltf::Primitive& primitive : meshes.primitives(placement.mesh)) {
      Instance instance;
      instance.mesh = meshes.geometry(primitive, scene.meshes);
      if (context.failed()) return;
      if (scene.meshes[instance.mesh].indices.empty()) continue;
      if (primitive.material == gltf::kNone && !default_index) {
        default_index = static_cast<std::uint32_t>(scene.materials.size());
        scene.materials.push_back(gltf::default_material());
      }
      instance.material =
          primitive.material == gltf::kNone ? *default_index : static_cast<std::uint32_t>(primitive.material);
      instance.transform = placement.mesh_to_world;
      instance.name = name_of(placement, primitive);
      scene.instances.push_back(std::move(instance));
    }
  }
}

Result<Scene> read_document(const Source& source, Json root, std::span<const std::byte> bin) {
  Context context(source);
  Scene scene;
  check_version(context, root);
  if (!context.failed()) check_extensions(context, root);
  if (context.failed()) return context.error();
  gltf::Buffers buffers(context, root, bin);
  gltf::Accessors accessors(context, root, buffers);
  gltf::Meshes meshes(context, root, accessors);
  const gltf::NodeTargets targets{meshes.size(), context.list(root, "cameras").size(),
                                  gltf::light_list(context, root).size()};
  gltf::NodePlaces places = gltf::place_nodes(context, root, targets);
  gltf::place_skinned_meshes(context, root, accessors, places);
  const std::vector<gltf::Placement>& placements = places.placements;
  gltf::read_materials(context, root, buffers, scene);
  if (!context.failed()) check_size(context, meshes, placements);
  if (!context.failed()) add_instances(context, meshes, placements, scene);
  if (!context.failed()) gltf::add_cameras(context, root, placements, scene);
  if (!context.failed()) gltf::add_lights(context, root, placements, scene);
  if (context.failed()) return context.error();
  meshes.report();
  if (scene.instances.empty() && meshes.size() > 0) {
    context.problem("the scene's nodes show none of the file's " + std::to_string(meshes.size()) +
                    (meshes.size() == 1 ? " mesh" : " meshes"));
  } else if (scene.instances.empty()) {
    context.problem("the file has no meshes; it lists " + list_of_contents(context, root));
  }
  scene.problems = context.take_problems();
  return scene;
}

}  // namespace

Result<Scene> read_gltf(const Source& source) {
  // Nothing of ours throws; the standard library does where memory ends.
  try {
    Container container{source.text(), {}};
    if (is_glb(source)) {
      Result<Container> parts = split_glb(source);
      if (!parts) return parts.error();
      container = *parts;
    }
    const Result<JsonDocument> document = JsonDocument::parse(container.json);
    if (!document) {
      Error error = document.error();
      error.source = source.name;
      if (is_glb(source)) error.line = 0;
      return error;
    }
    return read_document(source, document->root(), container.bin);
  } catch (const std::bad_alloc&) {
    return Error{ErrorCode::limit, "there is not enough memory for the model", source.name, 0};
  } catch (const std::exception& error) {
    return Error{ErrorCode::internal, std::string("the reader failed: ") + error.what(), source.name, 0};
  }
}

}  // namespace blysk::io
