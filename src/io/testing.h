// io/testing.h - model files made in tests.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <span>
#include <string>
#include <string_view>

#include "blysk/model.h"

namespace blysk::io {

inline std::span<const std::byte> as_bytes(std::string_view text) {
  return {reinterpret_cast<const std::byte*>(text.data()), text.size()};
}

inline Result<Scene> load_text(std::string_view text, std::string_view name,
                               const ModelOptions& options = {}) {
  return load_model(as_bytes(text), name, {}, options);
}

/// A message without what every reader says to do about a broken file, which must be there.
inline std::string less_remedy(const std::string& text) {
  const std::size_t end = text.rfind("; ");
  EXPECT_NE(end, std::string::npos) << text << " does not say what to do";
  const std::string remedy = text.substr(std::min(end, text.size()));
  for (const char* usual :
       {"; mend the line or export the model again", "; mend the header or export the model again",
        "; mend it or export the model again", "; export the model again", "; fetch or export it again"}) {
    if (remedy == usual) return text.substr(0, end);
  }
  return text;
}

/// The bytes of numbers one after the other, low byte first, or high byte first.
template <class... T>
std::string packed(T... values) {
  std::string bytes;
  (bytes.append(reinterpret_cast<const char*>(&values), sizeof values), ...);
  return bytes;
}
template <class... T>
std::string packed_big(T... values) {
  std::string bytes;
  const auto append = [&](auto value) {
    const auto* first = reinterpret_cast<const char*>(&value);
    for (std::size_t i = sizeof value; i-- > 0;) bytes += first[i];
  };
  (append(values), ...);
  return bytes;
}

/// What scene.h promises of a mesh.
inline void expect_sound(const Mesh& mesh) {
  const std::size_t vertices = mesh.positions.size();
  EXPECT_EQ(mesh.indices.size() % 3, 0u);
  for (const std::uint32_t index : mesh.indices) ASSERT_LT(index, vertices);
  for (const Vec3f& p : mesh.positions) {
    ASSERT_TRUE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
  }
  for (const Vec3f& n : mesh.normals) ASSERT_NEAR(dot(n, n), 1.0f, 1e-3f);
  EXPECT_TRUE(mesh.normals.empty() || mesh.normals.size() == vertices);
  EXPECT_TRUE(mesh.colors.empty() || mesh.colors.size() == vertices);
  EXPECT_TRUE(mesh.texcoords.empty() || mesh.texcoords.size() == vertices);
}

/// Loads every beginning of a file: each is an error with a sentence, or a sound scene.
inline void expect_all_prefixes_survive(std::string_view file, std::string_view name) {
  for (std::size_t length = 0; length <= file.size(); ++length) {
    // A copy of its own size, so that a sanitizer sees a step beyond the end.
    const std::string part(file.substr(0, length));
    const Result<Scene> scene = load_text(part, name);
    if (scene) {
      for (const Mesh& mesh : scene->meshes) expect_sound(mesh);
    } else {
      EXPECT_FALSE(scene.error().message.empty()) << length;
      EXPECT_EQ(scene.error().message.find('\n'), std::string::npos) << length;
    }
  }
}

/// Corners of the unit square, a row each.
inline const std::string kSquareRows = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

inline double area(const Mesh& mesh) {
  double sum = 0;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const Vec3d a = to_double(mesh.positions[mesh.indices[i]]);
    const Vec3d b = to_double(mesh.positions[mesh.indices[i + 1]]);
    const Vec3d c = to_double(mesh.positions[mesh.indices[i + 2]]);
    sum += length(cross(b - a, c - a)) / 2;
  }
  return sum;
}

}  // namespace blysk::io
