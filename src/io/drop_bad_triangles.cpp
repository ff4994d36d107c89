#include <cmath>
#include <limits>

#include "io/reader.h"

namespace blysk::io {
namespace {

constexpr std::uint32_t kUnused = std::numeric_limits<std::uint32_t>::max();

enum class Verdict { good, out_of_range, not_finite, degenerate };

bool is_finite(Vec3f p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

Verdict judge(const Mesh& mesh, const std::uint32_t* corner) {
  const std::size_t vertices = mesh.positions.size();
  if (corner[0] >= vertices || corner[1] >= vertices || corner[2] >= vertices) return Verdict::out_of_range;
  const Vec3f& a = mesh.positions[corner[0]];
  const Vec3f& b = mesh.positions[corner[1]];
  const Vec3f& c = mesh.positions[corner[2]];
  if (!is_finite(a) || !is_finite(b) || !is_finite(c)) return Verdict::not_finite;
  return a == b || b == c || c == a ? Verdict::degenerate : Verdict::good;
}

struct Counts {
  std::size_t of[4] = {};
};

// Keeps the good triangles, in order, and marks their vertices.
Counts keep_good(Mesh& mesh, Array<std::uint32_t>& used) {
  Counts counts;
  std::size_t kept = 0;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const Verdict verdict = judge(mesh, &mesh.indices[i]);
    ++counts.of[static_cast<int>(verdict)];
    if (verdict != Verdict::good) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t vertex = mesh.indices[i + k];
      if (kept != i) mesh.indices[kept + k] = vertex;
      used[vertex] = 0;
    }
    kept += 3;
  }
  mesh.indices.resize(kept);
  return counts;
}

template <class T>
void keep_used(Array<T>& values, const Array<std::uint32_t>& used) {
  if (values.empty()) return;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (used[i] != kUnused) values[kept++] = values[i];
  }
  values.resize(kept);
}

void drop_unused(Mesh& mesh, Array<std::uint32_t>& used) {
  std::uint32_t next = 0;
  for (std::uint32_t& place : used) {
    if (place != kUnused) place = next++;
  }
  if (next == used.size()) return;
  keep_used(mesh.positions, used);
  keep_used(mesh.normals, used);
  keep_used(mesh.colors, used);
  keep_used(mesh.texcoords, used);
  keep_used(mesh.texcoords1, used);
  keep_used(mesh.tangents, used);
  for (std::uint32_t& vertex : mesh.indices) vertex = used[vertex];
}

std::string sentence(const Mesh& mesh, const Counts& counts) {
  constexpr const char* kKinds[] = {"", "out-of-range", "non-finite", "degenerate"};
  std::string text;
  for (const Verdict verdict : {Verdict::degenerate, Verdict::not_finite, Verdict::out_of_range}) {
    const std::size_t count = counts.of[static_cast<int>(verdict)];
    if (count == 0) continue;
    text += (text.empty() ? "" : " and ") + std::to_string(count) + " " + kKinds[static_cast<int>(verdict)];
  }
  if (text.empty()) return text;
  return "mesh" + (mesh.name.empty() ? "" : " " + mesh.name) + ": left out " + text + " triangles";
}

}  // namespace

void drop_bad_triangles(Mesh& mesh, std::vector<std::string>& problems) {
  Array<std::uint32_t> used;
  used.resize(mesh.positions.size(), kUnused);
  const Counts counts = keep_good(mesh, used);
  if (std::string text = sentence(mesh, counts); !text.empty()) problems.push_back(std::move(text));
  drop_unused(mesh, used);
}

}  // namespace blysk::io
