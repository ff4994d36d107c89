// io/gltf_testing.h - for tests: small glTF files written down by what matters.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <string>
#include <string_view>
#include <type_traits>

#include "io/reader.h"

namespace blysk::io::gltf_testing {

inline std::string base64(std::string_view bytes) {
  constexpr std::string_view kAlphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      group = group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    }
    for (std::size_t k = 0; k < 4; ++k)
      text += i + k > bytes.size() ? '=' : kAlphabet[group >> (18 - 6 * k) & 63];
  }
  return text;
}

template <class T>
constexpr int component_type() {
  if constexpr (std::is_same_v<T, std::int8_t>) return 5120;
  if constexpr (std::is_same_v<T, std::uint8_t>) return 5121;
  if constexpr (std::is_same_v<T, std::int16_t>) return 5122;
  if constexpr (std::is_same_v<T, std::uint16_t>) return 5123;
  if constexpr (std::is_same_v<T, std::uint32_t>) return 5125;
  return 5126;
}

/// A document of one buffer. `more` members follow what is made from the data.
struct Document {
  std::string bin, views, accessors, more;
  std::string asset = R"({"version":"2.0"})";
  int view_count = 0, accessor_count = 0;

  template <class T>
  std::size_t append(std::initializer_list<T> values) {
    bin.resize((bin.size() + 3) / 4 * 4);
    const std::size_t offset = bin.size();
    bin.resize(offset + values.size() * sizeof(T));
    std::memcpy(bin.data() + offset, values.begin(), values.size() * sizeof(T));
    return offset;
  }
  /// A view of these values; `extra` such as `,"byteStride":16`.
  template <class T>
  int view(std::initializer_list<T> values, const std::string& extra = "") {
    const std::size_t offset = append(values);
    views += std::string(view_count == 0 ? "" : ",") + R"({"buffer":0,"byteOffset":)" +
             std::to_string(offset) + R"(,"byteLength":)" + std::to_string(values.size() * sizeof(T)) +
             extra + "}";
    return view_count++;
  }
  int accessor(const std::string& members) {
    accessors += (accessor_count == 0 ? "{" : ",{") + members + "}";
    return accessor_count++;
  }
  /// A packed accessor of these values with a view of its own; `extra` such as `,"normalized":true`.
  template <class T>
  int array(const std::string& type, std::size_t components, std::initializer_list<T> values,
            const std::string& extra = "") {
    const int v = view(values);
    return accessor(R"("bufferView":)" + std::to_string(v) + R"(,"componentType":)" +
                    std::to_string(component_type<T>()) + R"(,"count":)" +
                    std::to_string(values.size() / components) + R"(,"type":")" + type + "\"" + extra);
  }
  /// One mesh of one primitive with these members, and a node that shows it.
  void primitive(const std::string& members) {
    more += R"(,"meshes":[{"primitives":[{)" + members + R"(}]}],"nodes":[{"mesh":0}])";
  }

  [[nodiscard]] std::string json(const std::string& uri) const {
    const std::string length = std::to_string(bin.size());
    return R"({"asset":)" + asset + R"(,"buffers":[{"byteLength":)" + length +
           (uri.empty() ? "" : R"(,"uri":")" + uri + "\"") + R"(}],"bufferViews":[)" + views +
           R"(],"accessors":[)" + accessors + "]" + more + "}";
  }
  [[nodiscard]] std::string gltf() const {
    return json("data:application/octet-stream;base64," + base64(bin));
  }
  [[nodiscard]] std::string glb() const;
};

inline void append_u32(std::string& to, std::size_t value) {
  for (int i = 0; i < 4; ++i) to += static_cast<char>(value >> (8 * i) & 255);
}

inline std::string make_glb(std::string json, std::string bin) {
  json.resize((json.size() + 3) / 4 * 4, ' ');
  bin.resize((bin.size() + 3) / 4 * 4);
  std::string file = "glTF";
  append_u32(file, 2);
  append_u32(file, 12 + 8 + json.size() + (bin.empty() ? 0 : 8 + bin.size()));
  append_u32(file, json.size());
  file += "JSON" + json;
  if (!bin.empty()) {
    append_u32(file, bin.size());
    file += std::string("BIN\0", 4) + bin;
  }
  return file;
}

inline std::string Document::glb() const { return make_glb(json(""), bin); }

inline Result<Scene> read(std::string_view file, const Limits& limits = {}) {
  Source source{std::as_bytes(std::span(file)), "test.gltf", {}, {}};
  source.options.limits = limits;
  return read_gltf(source);
}

/// The error's text, or "read" if there is none.
inline std::string error_of(std::string_view file) {
  const Result<Scene> scene = read(file);
  return scene ? "read" : scene.error().text();
}

inline void expect_near(Vec3d a, Vec3d b) {
  EXPECT_NEAR(a.x, b.x, 1e-12);
  EXPECT_NEAR(a.y, b.y, 1e-12);
  EXPECT_NEAR(a.z, b.z, 1e-12);
}

/// A triangle in the plane z = 0 as accessors 0 (positions) and 1 (indices).
inline Document triangle() {
  Document d;
  d.array<float>("VEC3", 3, {0, 0, 0, 1, 0, 0, 0, 1, 0});
  d.array<std::uint16_t>("SCALAR", 1, {0, 1, 2});
  return d;
}

/// The same as a whole model with one node; `more` members such as `,"materials":[...]`.
inline Document triangle_model(const std::string& primitive_extra = "", const std::string& more = "") {
  Document d = triangle();
  d.primitive(R"("attributes":{"POSITION":0},"indices":1)" + primitive_extra);
  d.more += more;
  return d;
}

}  // namespace blysk::io::gltf_testing
