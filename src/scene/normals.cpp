// Vertex normals in three passes over the triangles: sums of the area-weighted face normals; marks at the
// places where a face leans away from the sum by more than half the crease; normals of their own for the
// faces there.
//
// Vertices at the same position count as one place: a seam in the texture coordinates is no edge.
#include "scene/normals.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "math/trig.h"
#include "scene/weld.h"

namespace blysk {
namespace {

constexpr std::size_t kTrianglesPerPart = std::size_t{1} << 17;
constexpr std::size_t kMostParts = 8;
constexpr std::size_t kBlock = std::size_t{1} << 15;
constexpr std::size_t kMostFaces =
    512;  // at a place; beyond it faces keep their own normals, lest time be squared
constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

// A unit vector, or zero where there is none. In double, where squares of floats neither overflow nor vanish.
Vec3f unit_or_zero(Vec3f v) { return to_float(normalize(to_double(v), Vec3d{0, 0, 0})); }

bool is_zero(Vec3f v) { return v.x == 0 && v.y == 0 && v.z == 0; }

Vec3f or_up(Vec3f v) { return is_zero(v) ? Vec3f{0, 0, 1} : v; }

// A power of two that brings the positions near one, so that areas of areas neither overflow nor vanish.
float scale_of(const Array<Vec3f>& positions) {
  float largest = 0;
  for (const Vec3f& p : positions) {
    largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  }
  const int exponent = static_cast<int>(std::bit_cast<std::uint32_t>(largest) >> 23);
  return std::bit_cast<float>(static_cast<std::uint32_t>(std::clamp(254 - exponent, 1, 253)) << 23);
}

// What all passes look at.
struct Surface {
  const Mesh& mesh;
  Array<std::uint32_t> places;  // per vertex; empty: every vertex is its own place
  std::size_t place_count;
  float scale;

  Surface(const Mesh& m, ThreadPool& pool)
      : mesh(m), place_count(m.positions.size()), scale(scale_of(m.positions)) {
    const PackedPoints points{reinterpret_cast<const std::byte*>(m.positions.data()), m.positions.size()};
    WeldedIds welded = weld_ids(points, pool);
    if (welded.count == place_count) return;
    place_count = welded.count;
    places = std::move(welded.ids);
  }

  std::uint32_t place_of(std::size_t vertex) const {
    return places.empty() ? static_cast<std::uint32_t>(vertex) : places[vertex];
  }
  std::uint32_t place(std::size_t corner) const { return place_of(mesh.indices[corner]); }
  // Along the normal, as long as twice the triangle's scaled area.
  Vec3f face_normal(std::size_t triangle) const {
    const std::uint32_t* corner = mesh.indices.data() + 3 * triangle;
    const Vec3f a = mesh.positions[corner[0]] * scale;
    return cross(mesh.positions[corner[1]] * scale - a, mesh.positions[corner[2]] * scale - a);
  }
};

// Sums of a run of triangles, over the range of places they touch.
struct Part {
  std::size_t begin, end;  // triangles
  std::uint32_t first_place = kNone, last_place = 0;
  Array<Vec3f> sums;

  void add_up(const Surface& surface) {
    if (begin == end) return;
    for (std::size_t corner = 3 * begin; corner < 3 * end; ++corner) {
      first_place = std::min(first_place, surface.place(corner));
      last_place = std::max(last_place, surface.place(corner));
    }
    sums.resize(std::size_t{last_place} - first_place + 1, Vec3f{});
    for (std::size_t triangle = begin; triangle < end; ++triangle) {
      const Vec3f normal = surface.face_normal(triangle);
      for (std::size_t corner = 3 * triangle; corner < 3 * triangle + 3; ++corner) {
        Vec3f& sum = sums[surface.place(corner) - first_place];
        sum = sum + normal;
      }
    }
  }
};

// The unit normal of every place; zero where its faces cancel out or there are none. The parts, and with them
// the order of the additions, depend on the mesh alone.
Array<Vec3f> place_normals(const Surface& surface, ThreadPool& pool) {
  const std::size_t triangles = surface.mesh.triangles();
  const std::size_t count = std::clamp<std::size_t>(triangles / kTrianglesPerPart, 1, kMostParts);
  std::vector<Part> parts(count);
  for (std::size_t i = 0; i < count; ++i) {
    parts[i].begin = triangles * i / count;
    parts[i].end = triangles * (i + 1) / count;
  }
  pool.for_each(count, [&](int, std::size_t i) { parts[i].add_up(surface); });

  Array<Vec3f> normals;
  normals.resize(surface.place_count);
  pool.for_each((normals.size() + kBlock - 1) / kBlock, [&](int, std::size_t block) {
    const std::size_t end = std::min(normals.size(), (block + 1) * kBlock);
    for (std::size_t place = block * kBlock; place < end; ++place) {
      Vec3f sum;
      for (const Part& part : parts) {
        if (place >= part.first_place && place <= part.last_place)
          sum = sum + part.sums[place - part.first_place];
      }
      normals[place] = unit_or_zero(sum);
    }
  });
  return normals;
}

// Marks the places where a face leans away from the normal by more than half the crease.
Array<std::uint8_t> find_creases(const Surface& surface, const Array<Vec3f>& normals, double crease_deg,
                                 ThreadPool& pool) {
  Array<std::uint8_t> marks;
  marks.resize(normals.size(), std::uint8_t{0});
  const auto cosine_half = static_cast<float>(cosine(radians(crease_deg / 2)));
  const float limit = cosine_half * cosine_half;
  const std::size_t triangles = surface.mesh.triangles();
  pool.for_each((triangles + kBlock - 1) / kBlock, [&](int, std::size_t block) {
    const std::size_t end = std::min(triangles, (block + 1) * kBlock);
    for (std::size_t triangle = block * kBlock; triangle < end; ++triangle) {
      const Vec3f face = surface.face_normal(triangle);
      const float least = limit * dot(face, face);
      for (std::size_t corner = 3 * triangle; corner < 3 * triangle + 3; ++corner) {
        const std::uint32_t place = surface.place(corner);
        const float d = dot(face, normals[place]);
        if (d * std::abs(d) < least) std::atomic_ref(marks[place]).store(1, std::memory_order_relaxed);
      }
    }
  });
  return marks;
}

// Gives the corners at marked places normals and vertices of their own.
class Splitter {
 public:
  Splitter(Mesh& mesh, const Surface& surface, const Array<Vec3f>& normals, double crease_deg)
      : mesh_(mesh),
        surface_(surface),
        normals_(normals),
        cosine_crease_(static_cast<float>(cosine(radians(crease_deg)))) {}

  void run(const Array<std::uint8_t>& marks) {
    collect_corners(marks);
    for (std::size_t i = 0; i + 1 < starts_.size(); ++i) {
      split_place({corners_.data() + starts_[i], corners_.data() + starts_[i + 1]});
    }
    // Only now: until here the triangles are looked at as they were.
    for (const Change& change : changes_) mesh_.indices[change.corner] = change.index;
    append_copies(mesh_.positions);
    append_copies(mesh_.colors);
    append_copies(mesh_.texcoords);
    append_copies(mesh_.texcoords1);
    append_copies(mesh_.tangents);
    mesh_.normals.insert(mesh_.normals.end(), copy_normals_.begin(), copy_normals_.end());
  }

 private:
  struct Given {
    std::uint32_t vertex;
    Vec3f normal;
    std::uint32_t index;
  };
  struct Change {
    std::uint32_t corner, index;
  };

  // The corners of each marked place, ascending.
  void collect_corners(const Array<std::uint8_t>& marks) {
    Array<std::uint32_t> marked;
    for (std::size_t corner = 0; corner < mesh_.indices.size(); ++corner) {
      if (marks[surface_.place(corner)] != 0) marked.push_back(static_cast<std::uint32_t>(corner));
    }
    Array<std::uint32_t> numbers;  // of marked places
    numbers.resize(marks.size());
    std::uint32_t places = 0;
    for (std::size_t place = 0; place < marks.size(); ++place) {
      numbers[place] = places;
      places += marks[place];
    }
    // starts_[i + 1] is first the count, then the start, then the end of place i.
    starts_.assign(std::size_t{places} + 2, 0);
    for (const std::uint32_t corner : marked) ++starts_[numbers[surface_.place(corner)] + 2];
    for (std::size_t i = 2; i < starts_.size(); ++i) starts_[i] += starts_[i - 1];
    corners_.resize(marked.size());
    for (const std::uint32_t corner : marked)
      corners_[starts_[numbers[surface_.place(corner)] + 1]++] = corner;
    starts_.pop_back();
  }

  void split_place(std::span<const std::uint32_t> corners) {
    faces_.clear();
    units_.clear();
    given_.clear();
    for (const std::uint32_t corner : corners) {
      faces_.push_back(surface_.face_normal(corner / 3));
      units_.push_back(unit_or_zero(faces_.back()));
    }
    for (std::size_t i = 0; i < corners.size(); ++i) {
      assign(corners[i], corner_normal(i, surface_.place(corners[i])));
    }
  }

  // The sum of the faces within the crease of face `i`.
  Vec3f corner_normal(std::size_t i, std::uint32_t place) const {
    if (is_zero(units_[i])) return or_up(normals_[place]);
    if (faces_.size() > kMostFaces) return units_[i];
    Vec3f sum;
    for (std::size_t j = 0; j < faces_.size(); ++j) {
      if (j == i || dot(units_[i], units_[j]) >= cosine_crease_) sum = sum + faces_[j];
    }
    const Vec3f unit = unit_or_zero(sum);
    return is_zero(unit) ? units_[i] : unit;
  }

  // The first normal of a vertex stays with it; further ones get a copy of it.
  void assign(std::uint32_t corner, Vec3f normal) {
    const std::uint32_t vertex = mesh_.indices[corner];
    bool seen = false;
    const std::size_t first = given_.size() > kMostFaces ? given_.size() - kMostFaces : 0;
    for (std::size_t g = first; g < given_.size(); ++g) {
      if (given_[g].vertex != vertex) continue;
      seen = true;
      if (given_[g].normal == normal) {
        change(corner, given_[g].index);
        return;
      }
    }
    std::uint32_t index = vertex;
    if (seen || first > 0) {
      index = static_cast<std::uint32_t>(mesh_.positions.size() + copies_.size());
      copies_.push_back(vertex);
      copy_normals_.push_back(normal);
    } else {
      mesh_.normals[vertex] = normal;
    }
    given_.push_back({vertex, normal, index});
    change(corner, index);
  }

  void change(std::uint32_t corner, std::uint32_t index) {
    if (mesh_.indices[corner] != index) changes_.push_back({corner, index});
  }

  template <class T>
  void append_copies(Array<T>& values) const {
    if (values.empty()) return;
    const std::size_t before = values.size();
    values.resize(before + copies_.size());
    for (std::size_t i = 0; i < copies_.size(); ++i) values[before + i] = values[copies_[i]];
  }

  Mesh& mesh_;
  const Surface& surface_;
  const Array<Vec3f>& normals_;
  float cosine_crease_;
  std::vector<std::size_t> starts_;
  Array<std::uint32_t> corners_;
  std::vector<Vec3f> faces_, units_;
  std::vector<Given> given_;
  std::vector<Change> changes_;
  Array<std::uint32_t> copies_;  // vertices to copy, in the order of their new indices
  Array<Vec3f> copy_normals_;
};

void split_creases(Mesh& mesh, const Surface& surface, const Array<Vec3f>& normals, double crease_deg,
                   ThreadPool& pool) {
  const Array<std::uint8_t> marks = find_creases(surface, normals, crease_deg, pool);
  if (std::find(marks.begin(), marks.end(), std::uint8_t{1}) == marks.end()) return;
  Splitter(mesh, surface, normals, crease_deg).run(marks);
}

}  // namespace

void make_normals(Mesh& mesh, double crease_deg, ThreadPool& pool) {
  mesh.normals = {};
  if (!(crease_deg > 0) || mesh.indices.empty()) return;
  const Surface surface(mesh, pool);
  const Array<Vec3f> normals = place_normals(surface, pool);
  const std::size_t vertices = mesh.positions.size();
  mesh.normals.resize(vertices);
  pool.for_each((vertices + kBlock - 1) / kBlock, [&](int, std::size_t block) {
    const std::size_t end = std::min(vertices, (block + 1) * kBlock);
    for (std::size_t vertex = block * kBlock; vertex < end; ++vertex) {
      mesh.normals[vertex] = or_up(normals[surface.place_of(vertex)]);
    }
  });
  if (crease_deg < 180) split_creases(mesh, surface, normals, crease_deg, pool);
}

void make_normals(Mesh& mesh, double crease_deg) {
  ThreadPool pool(mesh.triangles() < kTrianglesWorthThreads ? 1 : 0);
  make_normals(mesh, crease_deg, pool);
}

void mend_normals(Mesh& mesh) {
  Array<Vec3f> made;
  for (std::size_t vertex = 0; vertex < mesh.normals.size(); ++vertex) {
    Vec3f& normal = mesh.normals[vertex];
    if (std::abs(dot(normal, normal) - 1) <= 2e-3f) continue;
    normal = unit_or_zero(normal);
    if (!is_zero(normal)) continue;
    if (made.empty()) {
      ThreadPool pool(1);
      const Surface surface(mesh, pool);
      const Array<Vec3f> normals = place_normals(surface, pool);
      made.resize(mesh.positions.size());
      for (std::size_t v = 0; v < made.size(); ++v) made[v] = or_up(normals[surface.place_of(v)]);
    }
    normal = made[vertex];
  }
}

}  // namespace blysk
