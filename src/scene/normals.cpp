// Vertex normals in three passes over the triangles: sums of the area-weighted face normals; marks at the
// places where a face leans away from the sum by more than half the crease; normals of their own for the
// faces there.
//
// Vertices at the same position count as one place, named after the first of them: a seam in the texture
// coordinates is no edge.
#include "scene/normals.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "math/float4.h"
#include "math/trig.h"
#include "scene/first_equals.h"

namespace blysk {
namespace {

constexpr std::size_t kTrianglesPerPart = std::size_t{1} << 17;
constexpr std::size_t kMostSlabs = 8;
constexpr std::size_t kBlock = std::size_t{1} << 15;
constexpr std::size_t kAhead = 32;  // triangles whose positions are asked for
constexpr std::size_t kMostFaces =
    512;  // at a place; beyond it faces keep their own normals, lest time be squared
constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

// A unit vector, or zero where there is none. In double, where squares of floats neither overflow nor vanish.
Vec3f unit_or_zero(Vec3f v) { return to_float(normalize(to_double(v), Vec3d{0, 0, 0})); }

bool is_zero(Vec3f v) { return v.x == 0 && v.y == 0 && v.z == 0; }

Vec3f or_up(Vec3f v) { return is_zero(v) ? Vec3f{0, 0, 1} : v; }

// A power of two that brings the positions near one, so that areas of areas neither overflow nor vanish.
float scale_of(const Array<Vec3f>& positions) {
  std::uint32_t largest = 0;  // of the values' bits without sign, which are in the order of the values
  for (const Vec3f& p : positions) {
    for (const float value : {p.x, p.y, p.z})
      largest = std::max(largest, std::bit_cast<std::uint32_t>(value) & 0x7fffffff);
  }
  const int exponent = static_cast<int>(largest >> 23);
  return std::bit_cast<float>(static_cast<std::uint32_t>(std::clamp(254 - exponent, 1, 253)) << 23);
}

// What all passes look at. Loops take a copy of their own: of others the compiler must think that what they
// write could change it.
struct MeshView {
  const std::uint32_t* indices;
  std::size_t triangles;
  const Vec3f* positions;
  std::size_t vertices;
  const std::uint32_t* places;  // per vertex; null: every vertex is its own place
  float scale;

  MeshView(const Mesh& mesh, const Array<std::uint32_t>& firsts)
      : indices(mesh.indices.data()),
        triangles(mesh.triangles()),
        positions(mesh.positions.data()),
        vertices(mesh.positions.size()),
        places(firsts.empty() ? nullptr : firsts.data()),
        scale(scale_of(mesh.positions)) {}

  std::uint32_t place(std::size_t corner) const {
    const std::uint32_t vertex = indices[corner];
    return places == nullptr ? vertex : places[vertex];
  }
  // Asks for the positions of a later triangle: indices say where, before anything else can know.
  void expect(std::size_t triangle) const {
    if (triangle >= triangles) return;
    const std::uint32_t* corner = indices + 3 * triangle;
    for (int k = 0; k < 3; ++k) __builtin_prefetch(positions + corner[k]);
  }
  // Along the normal, as long as twice the triangle's scaled area.
  Float4 face_normal(std::size_t triangle) const {
    const std::uint32_t* corner = indices + 3 * triangle;
    const Float4 a = load4(positions + corner[0]) * scale;
    return cross(load4(positions + corner[1]) * scale - a, load4(positions + corner[2]) * scale - a);
  }
};

// Memory for the sums of a block of places, many blocks an allocation.
class Slabs {
 public:
  static constexpr std::size_t kPlaces = 256;

  explicit Slabs(std::size_t places) : blocks_(std::min(places / kPlaces + 1, kMostBlocks)) {}

  Float4* take() {
    if (left_ == 0) {
      slabs_.emplace_back(blocks_ * kPlaces);
      left_ = blocks_;
    }
    Float4* block = slabs_.back().data() + (blocks_ - left_--) * kPlaces;
    std::fill_n(block, kPlaces, Float4{});
    return block;
  }

 private:
  static constexpr std::size_t kMostBlocks = 512;  // two megabytes: a huge page
  std::size_t blocks_;
  std::vector<Array<Float4>> slabs_;
  std::size_t left_ = 0;
};

// Sums of a run of triangles, in blocks where it has places: a few far away must not cost memory for all
// between.
struct SlabPart {
  std::size_t begin, end;       // triangles
  std::vector<Float4*> blocks;  // null: no triangle of the part has a place there

  void add_up(const MeshView surface, Slabs& slabs) {
    blocks.assign(surface.vertices / Slabs::kPlaces + 1, nullptr);
    for (std::size_t triangle = begin; triangle < end; ++triangle) {
      surface.expect(triangle + kAhead);
      const Float4 normal = surface.face_normal(triangle);
      for (std::size_t corner = 3 * triangle; corner < 3 * triangle + 3; ++corner) {
        const std::uint32_t place = surface.place(corner);
        Float4*& block = blocks[place / Slabs::kPlaces];
        if (block == nullptr) block = slabs.take();
        block[place % Slabs::kPlaces] += normal;
      }
    }
  }
};

// The unit normal of every place, at its first vertex; zero where its faces cancel out or there are none. The
// parts, and with them the order of the additions, depend on the mesh alone.
Array<Vec3f> place_normals(const MeshView& surface, ThreadPool& pool) {
  const std::size_t triangles = surface.triangles;
  const std::size_t count = std::clamp<std::size_t>(triangles / kTrianglesPerPart, 1, kMostSlabs);
  std::vector<SlabPart> parts(count);
  std::vector<Slabs> slabs(static_cast<std::size_t>(pool.size()), Slabs(surface.vertices));
  pool.for_each(count, [&](int worker, std::size_t i) {
    parts[i].begin = triangles * i / count;
    parts[i].end = triangles * (i + 1) / count;
    parts[i].add_up(surface, slabs[static_cast<std::size_t>(worker)]);
  });

  Array<Vec3f> normals;
  normals.reserve(with_room_for_creases(surface.vertices));
  normals.resize(surface.vertices);
  pool.for_each((normals.size() + Slabs::kPlaces - 1) / Slabs::kPlaces, [&](int, std::size_t block) {
    const std::size_t first = block * Slabs::kPlaces, end = std::min(normals.size(), first + Slabs::kPlaces);
    for (std::size_t place = first; place < end; ++place) {
      Float4 sum = {};
      for (const SlabPart& part : parts) {
        if (part.blocks[block] != nullptr) sum += part.blocks[block][place - first];
      }
      normals[place] = unit_or_zero(to_vector(sum));
    }
  });
  return normals;
}

// Marks the places where a face leans away from the normal by more than half the crease.
Array<std::uint8_t> find_creases(const MeshView& whole, const Array<Vec3f>& normals, double crease_deg,
                                 ThreadPool& pool) {
  Array<std::uint8_t> marks;
  marks.resize(normals.size(), std::uint8_t{0});
  const auto cosine_half = static_cast<float>(cosine(radians(crease_deg / 2)));
  const float limit = cosine_half * cosine_half;
  pool.for_each((whole.triangles + kBlock - 1) / kBlock, [&](int, std::size_t block) {
    const MeshView surface = whole;
    const Vec3f* normal = normals.data();
    const std::size_t end = std::min(surface.triangles, (block + 1) * kBlock);
    for (std::size_t triangle = block * kBlock; triangle < end; ++triangle) {
      const std::uint32_t place[3] = {surface.place(3 * triangle), surface.place(3 * triangle + 1),
                                      surface.place(3 * triangle + 2)};
      surface.expect(triangle + kAhead);
      const Float4 face = surface.face_normal(triangle);
      const Float4 d =
          dots(face, load4(normal + place[0]), load4(normal + place[1]), load4(normal + place[2]));
      const Mask4 leans = d * magnitude(d) < limit * d[3];
      if (none4(leans)) continue;
      for (int k = 0; k < 3; ++k) {
        if (leans[k] != 0) std::atomic_ref(marks[place[k]]).store(1, std::memory_order_relaxed);
      }
    }
  });
  return marks;
}

// Gives the corners at marked places normals and vertices of their own.
class Splitter {
 public:
  Splitter(Mesh& mesh, const MeshView& surface, double crease_deg)
      : mesh_(mesh), surface_(surface), cosine_crease_(static_cast<float>(cosine(radians(crease_deg)))) {}

  void run(const Array<std::uint8_t>& marks, ThreadPool& pool) {
    collect_corners(marks, pool);
    make_corner_normals(pool);
    for (std::size_t i = 0; i + 1 < starts_.size(); ++i) {
      given_.clear();
      for (std::size_t k = starts_[i]; k < starts_[i + 1]; ++k) assign(corners_[k], corner_normals_[k]);
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
  // Of one place: normals as long as the faces are large, and of length one.
  struct Faces {
    std::vector<Vec3f> normals, units;

    void clear() {
      normals.clear();
      units.clear();
    }
    void add(Vec3f normal) {
      normals.push_back(normal);
      units.push_back(unit_or_zero(normal));
    }
  };

  // All corners at marked places, ascending.
  Array<std::uint32_t> marked_corners(const Array<std::uint8_t>& marks, ThreadPool& pool) const {
    const std::size_t triangles = mesh_.triangles();
    std::vector<Array<std::uint32_t>> found((triangles + kBlock - 1) / kBlock);
    pool.for_each(found.size(), [&](int, std::size_t block) {
      const std::size_t end = std::min(triangles, (block + 1) * kBlock);
      for (std::size_t corner = 3 * block * kBlock; corner < 3 * end; corner += 3) {
        const std::uint8_t at[3] = {marks[surface_.place(corner)], marks[surface_.place(corner + 1)],
                                    marks[surface_.place(corner + 2)]};
        if ((at[0] | at[1] | at[2]) == 0) continue;
        for (std::size_t k = 0; k < 3; ++k) {
          if (at[k] != 0) found[block].push_back(static_cast<std::uint32_t>(corner + k));
        }
      }
    });
    Array<std::uint32_t> all;
    for (const Array<std::uint32_t>& some : found) all.insert(all.end(), some.begin(), some.end());
    return all;
  }

  // The corners of each marked place, ascending.
  void collect_corners(const Array<std::uint8_t>& marks, ThreadPool& pool) {
    const Array<std::uint32_t> marked = marked_corners(marks, pool);
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

  void make_corner_normals(ThreadPool& pool) {
    constexpr std::size_t kPlaces = 256;
    corner_normals_.resize(corners_.size());
    const std::size_t places = starts_.size() - 1;
    pool.for_each((places + kPlaces - 1) / kPlaces, [&](int, std::size_t block) {
      Faces faces;
      for (std::size_t i = block * kPlaces; i < std::min(places, (block + 1) * kPlaces); ++i) {
        const std::span corners(corners_.data() + starts_[i], corners_.data() + starts_[i + 1]);
        faces.clear();
        for (const std::uint32_t corner : corners) faces.add(to_vector(surface_.face_normal(corner / 3)));
        for (std::size_t k = 0; k < corners.size(); ++k) {
          corner_normals_[starts_[i] + k] =
              corner_normal(faces, k, mesh_.normals[surface_.place(corners[k])]);
        }
      }
    });
  }

  // The sum of the faces within the crease of face `i`; `average` where that has no direction.
  Vec3f corner_normal(const Faces& faces, std::size_t i, Vec3f average) const {
    const std::vector<Vec3f>& units = faces.units;
    if (is_zero(units[i])) return average;
    if (units.size() > kMostFaces) return units[i];
    Vec3f sum;
    for (std::size_t j = 0; j < units.size(); ++j) {
      if (j == i || dot(units[i], units[j]) >= cosine_crease_) sum = sum + faces.normals[j];
    }
    const Vec3f unit = unit_or_zero(sum);
    return is_zero(unit) ? units[i] : unit;
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
  const MeshView& surface_;
  float cosine_crease_;
  std::vector<std::size_t> starts_;
  Array<std::uint32_t> corners_;
  Array<Vec3f> corner_normals_;
  std::vector<Given> given_;  // at the place that is looked at
  std::vector<Change> changes_;
  Array<std::uint32_t> copies_;  // vertices to copy, in the order of their new indices
  Array<Vec3f> copy_normals_;
};

// From the normals of places to those of all vertices.
void give_all_vertices(Array<Vec3f>& normals, const MeshView& surface, ThreadPool& pool) {
  const std::size_t blocks = (normals.size() + kBlock - 1) / kBlock;
  const auto each = [&](const auto& change) {
    pool.for_each(blocks, [&](int, std::size_t block) {
      const std::size_t end = std::min(normals.size(), (block + 1) * kBlock);
      for (std::size_t vertex = block * kBlock; vertex < end; ++vertex) change(vertex);
    });
  };
  each([&](std::size_t vertex) { normals[vertex] = or_up(normals[vertex]); });
  if (surface.places == nullptr) return;
  each([&](std::size_t vertex) {
    const std::uint32_t place = surface.places[vertex];
    if (place != vertex) normals[vertex] = normals[place];
  });
}

}  // namespace

void make_normals(Mesh& mesh, double crease_deg, ThreadPool& pool) {
  mesh.normals = {};
  if (!(crease_deg > 0) || mesh.indices.empty()) return;
  const Array<std::uint32_t> firsts = first_equals(mesh.positions, pool);
  const MeshView surface(mesh, firsts);
  mesh.normals = place_normals(surface, pool);
  Array<std::uint8_t> marks;
  if (crease_deg < 180) marks = find_creases(surface, mesh.normals, crease_deg, pool);
  give_all_vertices(mesh.normals, surface, pool);
  if (std::find(marks.begin(), marks.end(), std::uint8_t{1}) == marks.end()) return;
  Splitter(mesh, surface, crease_deg).run(marks, pool);
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
      const Array<std::uint32_t> firsts = first_equals(mesh.positions, pool);
      const MeshView surface(mesh, firsts);
      made = place_normals(surface, pool);
      give_all_vertices(made, surface, pool);
    }
    normal = made[vertex];
  }
}

}  // namespace blysk
