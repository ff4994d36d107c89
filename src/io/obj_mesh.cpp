#include "io/obj_mesh.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "io/polygon.h"
#include "scene/normals.h"

namespace blysk::io {
namespace {

constexpr std::uint32_t kNone = ObjFile::kNone;

// Numbers combinations of three indices in the order of their first appearance.
class VertexTable {
 public:
  struct Entry {
    std::uint32_t position, texcoord, normal;
    std::uint32_t next;  // with the same position
  };

  explicit VertexTable(std::size_t positions) { heads_.resize(positions, kNone); }

  const Array<Entry>& entries() const { return entries_; }

  std::uint32_t number(std::uint32_t position, std::uint32_t texcoord, std::uint32_t normal) {
    int steps = 0;
    std::uint32_t* head = &heads_[position];
    for (std::uint32_t i = *head; i != kNone && steps < kLongestChain; i = entries_[i].next, ++steps) {
      if (entries_[i].texcoord == texcoord && entries_[i].normal == normal) return i;
    }
    const auto next = static_cast<std::uint32_t>(entries_.size());
    if (steps == kLongestChain) {
      const auto [known, is_new] = rest_.try_emplace({position, texcoord, normal}, next);
      if (is_new) entries_.push_back({position, texcoord, normal, kNone});
      return known->second;
    }
    entries_.push_back({position, texcoord, normal, *head});
    *head = next;
    return next;
  }

  void clear() {
    for (const Entry& e : entries_) heads_[e.position] = kNone;
    entries_.clear();
    rest_.clear();
  }

 private:
  // A position rarely has ten combinations; a file made to have a million finds them in the map.
  static constexpr int kLongestChain = 64;

  Array<std::uint32_t> heads_;
  Array<Entry> entries_;
  std::map<std::array<std::uint32_t, 3>, std::uint32_t> rest_;
};

// Calls work(first corner, corners) for every face of a run.
template <class Work>
void for_each_face(const ObjFile& file, const ObjRun& run, Work&& work) {
  std::size_t corner = run.first_corner;
  for (std::size_t face = run.first_face; face < run.end_face; ++face) {
    const std::size_t corners = file.face_sizes.empty() ? 3 : file.face_sizes[face];
    work(corner, corners);
    corner += corners;
  }
}

// Calls work(corner, corner, corner) for every triangle of a part, polygons being cut.
template <class Work>
void for_each_triangle(const ObjFile& file, const ObjPart& part, Work&& work) {
  std::vector<Vec3f> polygon;
  Array<std::uint32_t> cut;
  for (const ObjRun& run : part.runs) {
    for_each_face(file, run, [&](std::size_t first, std::size_t corners) {
      if (corners == 3) {
        work(first, first + 1, first + 2);
        return;
      }
      polygon.clear();
      for (std::size_t i = first; i < first + corners; ++i) {
        polygon.push_back(file.positions[file.corner_positions[i]]);
      }
      cut.clear();
      triangulate(polygon, cut);
      for (std::size_t i = 0; i < cut.size(); i += 3)
        work(first + cut[i], first + cut[i + 1], first + cut[i + 2]);
    });
  }
}

std::size_t index_count(const ObjPart& part) {
  std::size_t count = 0;
  for (const ObjRun& run : part.runs) {
    count += 3 * (run.end_corner - run.first_corner - 2 * (run.end_face - run.first_face));
  }
  return count;
}

// Corners name the same index in a list as among the positions, so that the lists are those of a mesh.
template <class T>
bool runs_along(const Array<std::uint32_t>& corners, const Array<T>& list, const ObjFile& file) {
  return corners.empty() || (list.size() == file.positions.size() && corners == file.corner_positions);
}

bool is_one_mesh(const ObjFile& file, const std::vector<ObjPart>& parts) {
  return parts.size() == 1 && runs_along(file.corner_texcoords, file.texcoords, file) &&
         runs_along(file.corner_normals, file.normals, file);
}

Mesh take_whole(ObjFile&& file, const ObjPart& part) {
  Mesh mesh;
  if (file.face_sizes.empty()) {
    mesh.indices = std::move(file.corner_positions);
  } else {
    mesh.indices.reserve(index_count(part));
    for_each_triangle(file, part, [&](std::size_t a, std::size_t b, std::size_t c) {
      for (const std::size_t corner : {a, b, c}) mesh.indices.push_back(file.corner_positions[corner]);
    });
  }
  if (!file.corner_texcoords.empty()) mesh.texcoords = std::move(file.texcoords);
  if (!file.corner_normals.empty()) mesh.normals = std::move(file.normals);
  mesh.positions = std::move(file.positions);
  mesh.colors = std::move(file.colors);
  return mesh;
}

// The values that the table's vertices refer to; nothing if none refers to any.
template <class T>
Array<T> gather(const Array<T>& list, const VertexTable& table, std::uint32_t VertexTable::Entry::*index) {
  Array<T> values;
  const auto given = [&](const VertexTable::Entry& e) { return e.*index != kNone; };
  if (list.empty() || std::none_of(table.entries().begin(), table.entries().end(), given)) return values;
  values.reserve(table.entries().size());
  for (const VertexTable::Entry& e : table.entries()) values.push_back(given(e) ? list[e.*index] : T{});
  return values;
}

// `normals`, if there are any, are those of the part's triangles, corner by corner, and count instead of
// the normals of the file's corners.
Mesh gather_part(const ObjFile& file, const ObjPart& part, VertexTable& table, const std::uint32_t* normals) {
  Mesh mesh;
  mesh.indices.reserve(index_count(part));
  for_each_triangle(file, part, [&](std::size_t a, std::size_t b, std::size_t c) {
    for (const std::size_t corner : {a, b, c}) {
      const std::uint32_t texcoord = file.corner_texcoords.empty() ? kNone : file.corner_texcoords[corner];
      std::uint32_t normal = file.corner_normals.empty() ? kNone : file.corner_normals[corner];
      if (normals != nullptr) normal = *normals++;
      mesh.indices.push_back(table.number(file.corner_positions[corner], texcoord, normal));
    }
  });
  mesh.positions = gather(file.positions, table, &VertexTable::Entry::position);
  mesh.colors = gather(file.colors, table, &VertexTable::Entry::position);
  mesh.texcoords = gather(file.texcoords, table, &VertexTable::Entry::texcoord);
  mesh.normals = gather(file.normals, table, &VertexTable::Entry::normal);
  return mesh;
}

// "off" and 0 are no group; a word that is no number is a group like any other.
std::uint32_t smoothing_group(std::string_view text) {
  if (text.empty() || text == "off") return 0;
  std::uint32_t group = 1;
  std::from_chars(text.data(), text.data() + text.size(), group);
  return group;
}

// Newell's: along the normal, as long as twice the polygon's area.
Vec3d face_normal(const ObjFile& file, std::size_t first, std::size_t corners) {
  const auto at = [&](std::size_t i) { return to_double(file.positions[file.corner_positions[first + i]]); };
  const Vec3d origin = at(0);
  Vec3d sum;
  for (std::size_t i = 1; i + 1 < corners; ++i) sum = sum + cross(at(i) - origin, at(i + 1) - origin);
  const double l = length(sum);
  return l <= 1e300 ? sum : Vec3d{};
}

bool is_finite(Vec3f p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

bool lacks_normals(const ObjFile& file, const ObjRun& run) {
  if (file.corner_normals.empty()) return true;
  const std::uint32_t* corners = file.corner_normals.data();
  return std::find(corners + run.first_corner, corners + run.end_corner, kNone) != corners + run.end_corner;
}

// Normals for the corners that have none, of groups and of faces.
class GroupNormals {
 public:
  explicit GroupNormals(ObjFile& file) : file_(file), table_(file.positions.size()) {
    if (file.corner_normals.empty()) file.corner_normals.assign(file.corner_positions.size(), kNone);
    first_new_ = file.normals.size();
  }

  void add(const ObjRun& run) {
    for_each_face(file_, run, [&](std::size_t first, std::size_t corners) {
      const Vec3d normal = face_normal(file_, first, corners);
      std::uint32_t own = kNone;
      for (std::size_t i = first; i < first + corners; ++i) {
        std::uint32_t& to = file_.corner_normals[i];
        if (to != kNone) continue;
        if (run.group == 0) {
          if (own == kNone) own = start_sum(normal);
          to = own;
        } else {
          to = group_sum(file_.corner_positions[i], run.group);
          sums_[to - first_new_] = sums_[to - first_new_] + normal;
        }
      }
    });
  }

  void finish() {
    file_.normals.reserve(first_new_ + sums_.size());
    for (const Vec3d& sum : sums_) file_.normals.push_back(to_float(normalize(sum * kScale, {0, 0, 0})));
  }

 private:
  // normalize() takes no vectors longer than 1e30; the corners of floats reach 1e77.
  static constexpr double kScale = 0x1p-160;

  std::uint32_t start_sum(const Vec3d& normal) {
    sums_.push_back(normal);
    return static_cast<std::uint32_t>(first_new_ + sums_.size() - 1);
  }

  std::uint32_t group_sum(std::uint32_t position, std::uint32_t group) {
    const std::uint32_t i = table_.number(position, group, 0);
    if (i == group_sums_.size()) group_sums_.push_back(start_sum({}));
    return group_sums_[i];
  }

  ObjFile& file_;
  std::size_t first_new_ = 0;
  VertexTable table_;
  Array<std::uint32_t> group_sums_;  // index of the normal of each of the table's numbers
  Array<Vec3d> sums_;
};

// `names` becomes the objects and groups that have faces; unless `apart`, all faces count as those of none.
std::vector<ObjPart> collect_parts(const ObjFile& file, bool apart, std::set<ObjName>& names) {
  std::vector<ObjPart> parts;
  std::map<std::pair<ObjName, std::string_view>, std::size_t> known;
  ObjName name;
  std::string_view material;
  ObjRun run;
  const auto close = [&](std::size_t face) {
    if (face == run.first_face) return;
    run.end_face = face;
    run.end_corner = run.first_corner;
    for_each_face(file, run, [&](std::size_t, std::size_t corners) { run.end_corner += corners; });
    const auto [at, is_new] = known.try_emplace({name, material}, parts.size());
    if (is_new) {
      parts.push_back({name, material, {}});
      names.insert(name);
    }
    parts[at->second].runs.push_back(run);
    run.first_face = run.end_face;
    run.first_corner = run.end_corner;
  };
  for (const ObjEvent& event : file.events) {
    const bool names_faces = event.kind == ObjEvent::Kind::object || event.kind == ObjEvent::Kind::group;
    if (event.kind == ObjEvent::Kind::material && event.text != material) {
      close(event.face);
      material = event.text;
    } else if (apart && names_faces) {
      close(event.face);
      name =
          event.kind == ObjEvent::Kind::object ? ObjName{event.text, {}} : ObjName{name.object, event.text};
    } else if (event.kind == ObjEvent::Kind::smoothing && smoothing_group(event.text) != run.group) {
      close(event.face);
      run.group = smoothing_group(event.text);
    }
  }
  close(file.faces);
  return parts;
}

}  // namespace

ObjParts find_parts(const ObjFile& file) {
  // Models of machines may have a group for every face: as a mesh each, they would be read and drawn many
  // times slower.
  std::set<ObjName> names;
  std::vector<ObjPart> parts = collect_parts(file, true, names);
  const bool joined = names.size() > kMostGroups;
  if (joined) parts = collect_parts(file, false, names);
  return {std::move(parts), joined};
}

void smooth_groups(ObjFile& file, const std::vector<ObjPart>& parts) {
  const bool has_groups = std::any_of(parts.begin(), parts.end(), [&](const ObjPart& part) {
    return std::any_of(part.runs.begin(), part.runs.end(),
                       [&](const ObjRun& run) { return run.group != 0 && lacks_normals(file, run); });
  });
  if (!has_groups) return;
  GroupNormals normals(file);
  for (const ObjPart& part : parts) {
    for (const ObjRun& run : part.runs) normals.add(run);
  }
  normals.finish();
}

Array<std::uint32_t> crease_normals(ObjFile& file, const std::vector<ObjPart>& parts, double crease_deg,
                                    int threads) {
  Array<std::uint32_t> normals;
  if (parts.size() < 2 || !file.corner_normals.empty() || !(crease_deg > 0)) return normals;
  Mesh whole;
  whole.positions = file.positions;
  for (Vec3f& p : whole.positions) p = is_finite(p) ? p : Vec3f{};
  for (const ObjPart& part : parts) {
    for_each_triangle(file, part, [&](std::size_t a, std::size_t b, std::size_t c) {
      const std::array corners{file.corner_positions[a], file.corner_positions[b], file.corner_positions[c]};
      const bool finite = std::all_of(corners.begin(), corners.end(),
                                      [&](std::uint32_t i) { return is_finite(file.positions[i]); });
      if (finite) whole.indices.insert(whole.indices.end(), corners.begin(), corners.end());
      normals.insert(normals.end(), 3, finite ? 0 : kNone);
    });
  }
  ThreadPool pool(whole.triangles() < kTrianglesWorthThreads ? 1 : threads);
  make_normals(whole, crease_deg, pool);
  // The triangles are still where they were; their corners are now the numbers of their normals.
  auto corner = whole.indices.begin();
  for (std::uint32_t& normal : normals) normal = normal == kNone ? kNone : *corner++;
  file.normals = std::move(whole.normals);
  return normals;
}

std::vector<Mesh> make_meshes(ObjFile&& file, const std::vector<ObjPart>& parts,
                              const Array<std::uint32_t>& triangle_normals) {
  std::vector<Mesh> meshes;
  if (is_one_mesh(file, parts)) {
    meshes.push_back(take_whole(std::move(file), parts.front()));
    return meshes;
  }
  VertexTable table(file.positions.size());
  const std::uint32_t* normals = triangle_normals.empty() ? nullptr : triangle_normals.data();
  for (const ObjPart& part : parts) {
    meshes.push_back(gather_part(file, part, table, normals));
    if (normals != nullptr) normals += meshes.back().indices.size();
    table.clear();
  }
  return meshes;
}

}  // namespace blysk::io
