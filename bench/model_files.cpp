#include "model_files.h"

#include <charconv>
#include <cstdint>
#include <cstring>
#include <random>
#include <string>
#include <utility>

namespace blysk::bench {
namespace {

// Little-endian, as all these formats and all processors we run on are.
class Bytes {
 public:
  void text(std::string_view s) { raw(s.data(), s.size()); }
  template <class T>
  void value(T v) {
    raw(&v, sizeof v);
  }
  void number(float v) {
    char digits[32];
    text({digits, std::to_chars(digits, digits + sizeof digits, v).ptr});
  }
  void number(std::uint32_t v) {
    char digits[16];
    text({digits, std::to_chars(digits, digits + sizeof digits, v).ptr});
  }
  void raw(const void* from, std::size_t count) {
    const std::size_t at = bytes.size();
    bytes.resize(at + count);
    std::memcpy(bytes.data() + at, from, count);
  }
  std::vector<std::byte> bytes;
};

void write_obj(const Mesh& mesh, Bytes& out) {
  for (const Vec3f& p : mesh.positions) {
    out.text("v ");
    out.number(p.x);
    out.text(" ");
    out.number(p.y);
    out.text(" ");
    out.number(p.z);
    out.text("\n");
  }
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
    out.text(i % 3 == 0 ? "f " : " ");
    out.number(mesh.indices[i] + 1);
    if (i % 3 == 2) out.text("\n");
  }
}

void write_stl(const Mesh& mesh, Bytes& out) {
  out.text(std::string(80, ' '));
  out.value(static_cast<std::uint32_t>(mesh.triangles()));
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
    if (i % 3 == 0) out.value(Vec3f{});
    out.value(mesh.positions[mesh.indices[i]]);
    if (i % 3 == 2) out.value(std::uint16_t{0});
  }
}

// Triangles in another order, as no exporter writes them: none that share a corner are near each other.
Mesh shuffled(Mesh mesh) {
  std::mt19937 random(1);
  for (std::size_t i = mesh.triangles(); i > 1; --i) {
    const std::size_t other = random() % i;
    for (std::size_t k = 0; k < 3; ++k) std::swap(mesh.indices[3 * i - 3 + k], mesh.indices[3 * other + k]);
  }
  return mesh;
}

// Every triangle moved a little by itself: no two corners are the same.
Mesh apart(const Mesh& mesh) {
  Mesh soup;
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
    const float step = static_cast<float>(i / 3 % 1000) * 1e-4f;
    soup.positions.push_back(mesh.positions[mesh.indices[i]] + Vec3f{step, step, step});
    soup.indices.push_back(static_cast<std::uint32_t>(i));
  }
  return soup;
}

// With `colors`, every hundred triangles have another one.
void write_ply(const Mesh& mesh, bool colors, Bytes& out) {
  out.text("ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(mesh.positions.size()) +
           "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
           std::to_string(mesh.triangles()) + "\nproperty list uchar int vertex_indices\n" +
           (colors ? "property uchar red\nproperty uchar green\nproperty uchar blue\n" : "") +
           "end_header\n");
  for (const Vec3f& p : mesh.positions) out.value(p);
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
    if (i % 3 == 0) out.value(std::uint8_t{3});
    out.value(mesh.indices[i]);
    if (colors && i % 3 == 2) {
      for (const std::size_t channel : {i / 300, i / 3000, i / 30000})
        out.value(static_cast<std::uint8_t>(channel));
    }
  }
}

void write_glb(const Mesh& mesh, Bytes& out) {
  const std::size_t positions = mesh.positions.size() * sizeof(Vec3f);
  const std::size_t indices = mesh.indices.size() * sizeof(std::uint32_t);
  const auto n = [](std::size_t v) { return std::to_string(v); };
  std::string json =
      R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],)"
      R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],)"
      R"("accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":)" +
      n(mesh.positions.size()) + R"(},{"bufferView":1,"componentType":5125,"type":"SCALAR","count":)" +
      n(mesh.indices.size()) + R"(}],"bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":)" +
      n(positions) + R"(},{"buffer":0,"byteOffset":)" + n(positions) + R"(,"byteLength":)" + n(indices) +
      R"(}],"buffers":[{"byteLength":)" + n(positions + indices) + "}]}";
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const auto word = [&](std::size_t v) { out.value(static_cast<std::uint32_t>(v)); };
  out.text("glTF");
  word(2);
  word(12 + 8 + json.size() + 8 + positions + indices);
  word(json.size());
  out.text("JSON" + json);
  word(positions + indices);
  out.text({"BIN\0", 4});
  out.raw(mesh.positions.data(), positions);
  out.raw(mesh.indices.data(), indices);
}

}  // namespace

std::vector<std::byte> model_file(const Mesh& mesh, std::string_view format) {
  Bytes out;
  if (format == "obj") write_obj(mesh, out);
  if (format == "stl") write_stl(mesh, out);
  if (format == "shuffled.stl") write_stl(shuffled(mesh), out);
  if (format == "apart.stl") write_stl(apart(mesh), out);
  if (format == "ply") write_ply(mesh, false, out);
  if (format == "colors.ply") write_ply(mesh, true, out);
  if (format == "glb") write_glb(mesh, out);
  return std::move(out.bytes);
}

}  // namespace blysk::bench
