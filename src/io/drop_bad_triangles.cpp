// Blocks of triangles are judged in parallel; only where some are bad, the good ones move together.
#include <algorithm>
#include <iterator>
#include <limits>

#include "io/reader.h"
#include "math/float4.h"

namespace blysk::io {
namespace {

constexpr std::size_t kBlock = std::size_t{1} << 14;

enum class Verdict { good, not_finite, degenerate };

bool has_area(const Vec3f& a, const Vec3f& b, const Vec3f& c) {
  const Vec3d origin = to_double(a);
  return cross(to_double(b) - origin, to_double(c) - origin) != Vec3d{};
}

// Single precision settles nearly all: a component of the cross product beyond the rounding of its two
// products.
Verdict judge(const Vec3f* positions, const std::uint32_t* corner) {
  const Float4 a = load4(positions + corner[0]);
  const Float4 b = load4(positions + corner[1]);
  const Float4 c = load4(positions + corner[2]);
  const Mask4 finite = all3(a - a + (b - b) + (c - c) == Float4{});  // what is not finite gives NaN
  if (finite[0] == 0) return Verdict::not_finite;
  const Float4 u = b - a, v = c - a, p = u * rotate(v), q = rotate(u) * v;
  const Mask4 sure = magnitude(p - q) > 1e-6f * (magnitude(p) + magnitude(q)) + 1e-37f;
  if ((sure[0] | sure[1] | sure[2]) != 0) return Verdict::good;
  return has_area(positions[corner[0]], positions[corner[1]], positions[corner[2]]) ? Verdict::good
                                                                                    : Verdict::degenerate;
}

// What was found in some triangles.
struct Findings {
  std::size_t count[3] = {};  // of each verdict
  Array<std::size_t> bad;     // triangles, ascending
};

// Judges the triangles from `begin` to `end`; marks the vertices of the good ones.
Findings judge_block(const Mesh& mesh, std::size_t begin, std::size_t end, Array<std::uint8_t>& used) {
  Findings found;
  const Vec3f* positions =
      mesh.positions.data();  // here, lest every mark written below could have moved them
  std::uint8_t* marks = used.data();
  for (std::size_t triangle = begin; triangle < end; ++triangle) {
    const std::uint32_t* corner = mesh.indices.data() + 3 * triangle;
    const Verdict verdict = judge(positions, corner);
    if (verdict == Verdict::good) {
      marks[corner[0]] = marks[corner[1]] = marks[corner[2]] = 1;
    } else {
      ++found.count[static_cast<int>(verdict)];
      found.bad.push_back(triangle);
    }
  }
  return found;
}

// Judges all triangles; `used` becomes 1 for the vertices of good ones, and 0.
Findings judge_all(const Mesh& mesh, Array<std::uint8_t>& used, ThreadPool& pool) {
  const std::size_t triangles = mesh.triangles(), vertices = mesh.positions.size();
  std::vector<Findings> blocks((triangles + kBlock - 1) / kBlock);
  std::vector<Array<std::uint8_t>> used_by(static_cast<std::size_t>(pool.size()));
  pool.for_each(blocks.size(), [&](int worker, std::size_t block) {
    Array<std::uint8_t>& own = used_by[static_cast<std::size_t>(worker)];
    if (own.empty()) own.resize(vertices, std::uint8_t{0});
    blocks[block] = judge_block(mesh, block * kBlock, std::min(triangles, (block + 1) * kBlock), own);
  });

  Findings all;
  for (const Findings& block : blocks) {
    for (std::size_t v = 0; v < std::size(all.count); ++v) all.count[v] += block.count[v];
    all.bad.insert(all.bad.end(), block.bad.begin(), block.bad.end());
  }
  for (Array<std::uint8_t>& own : used_by) {
    if (own.empty()) continue;
    if (used.empty()) {
      used = std::move(own);
    } else {
      for (std::size_t i = 0; i < vertices; ++i) used[i] |= own[i];
    }
  }
  if (used.empty()) used.resize(vertices, std::uint8_t{0});
  return all;
}

void remove_triangles(Array<std::uint32_t>& indices, const Array<std::size_t>& bad) {
  if (bad.empty()) return;
  const auto corners_of = [&](std::size_t triangle) {
    return indices.begin() + 3 * static_cast<std::ptrdiff_t>(triangle);
  };
  auto to = corners_of(bad.front());
  for (std::size_t i = 0; i < bad.size(); ++i) {
    const std::size_t next = i + 1 < bad.size() ? bad[i + 1] : indices.size() / 3;
    to = std::copy(corners_of(bad[i] + 1), corners_of(next), to);
  }
  indices.erase(to, indices.end());
}

template <class T>
void keep_used(Array<T>& values, const Array<std::uint8_t>& used) {
  if (values.empty()) return;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (used[i] != 0) values[kept++] = values[i];
  }
  values.resize(kept);
}

void drop_unused(Mesh& mesh, const Array<std::uint8_t>& used) {
  if (std::find(used.begin(), used.end(), std::uint8_t{0}) == used.end()) return;
  Array<std::uint32_t> places(used.size());
  std::uint32_t next = 0;
  for (std::size_t i = 0; i < used.size(); ++i) {
    places[i] = next;
    next += used[i];
  }
  keep_used(mesh.positions, used);
  keep_used(mesh.normals, used);
  keep_used(mesh.colors, used);
  keep_used(mesh.texcoords, used);
  keep_used(mesh.texcoords1, used);
  keep_used(mesh.tangents, used);
  for (std::uint32_t& vertex : mesh.indices) vertex = places[vertex];
}

std::string sentence(const Mesh& mesh, const Findings& findings) {
  const std::size_t degenerate = findings.count[static_cast<int>(Verdict::degenerate)];
  const std::size_t not_finite = findings.count[static_cast<int>(Verdict::not_finite)];
  std::string text;
  if (degenerate > 0) text = std::to_string(degenerate) + " degenerate";
  if (not_finite > 0) text += (text.empty() ? "" : " and ") + std::to_string(not_finite) + " non-finite";
  if (text.empty()) return text;
  return "mesh" + (mesh.name.empty() ? "" : " " + mesh.name) + ": left out " + text +
         (degenerate + not_finite == 1 ? " triangle" : " triangles");
}

}  // namespace

void drop_bad_triangles(Mesh& mesh, std::vector<std::string>& problems, ThreadPool& pool) {
  Array<std::uint8_t> used;
  const Findings findings = judge_all(mesh, used, pool);
  if (std::string text = sentence(mesh, findings); !text.empty()) problems.push_back(std::move(text));
  remove_triangles(mesh.indices, findings.bad);
  drop_unused(mesh, used);
}

void drop_bad_triangles(Mesh& mesh, std::vector<std::string>& problems) {
  ThreadPool pool(1);
  drop_bad_triangles(mesh, problems, pool);
}

}  // namespace blysk::io
