// PLY, ASCII and binary of both byte orders: any order of elements and properties, faces and triangle strips.
//
// Two ways through the rows: rows of one size (vertices without lists, faces that are all triangles) are
// converted in parallel column by column; all others are read value by value.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "core/threads.h"
#include "io/faces.h"
#include "io/ply_header.h"
#include "io/ply_values.h"
#include "io/ply_vertices.h"
#include "io/reader.h"
#include "scene/normals.h"

namespace blysk::io {
namespace {

constexpr std::size_t kBytesWorthThreads = std::size_t{1} << 20;
constexpr std::size_t kFacesPerBlock = 8192;

std::uint32_t to_index(double value) {
  if (!(value >= 0 && value < static_cast<double>(kBadIndex))) return kBadIndex;
  const auto index = static_cast<std::uint32_t>(value);
  return static_cast<double>(index) == value ? index : kBadIndex;
}

bool is_index_list(const PlyProperty& p) {
  return p.is_list && (p.name == "vertex_indices" || p.name == "vertex_index");
}

// A strip's triangles, turning their order every time; an index below zero begins a new strip.
class Strip {
 public:
  void add(double value, Faces& faces) {
    if (value < 0) {
      length_ = 0;
      return;
    }
    const std::uint32_t index = to_index(value);
    if (length_ >= 2) {
      const bool odd = length_ % 2 != 0;
      faces.corners.insert(faces.corners.end(),
                           {odd ? last_ : before_last_, odd ? before_last_ : last_, index});
      faces.end_face();
    }
    before_last_ = std::exchange(last_, index);
    ++length_;
  }

 private:
  std::uint32_t before_last_ = 0, last_ = 0;
  std::uint64_t length_ = 0;
};

class PlyReader {
 public:
  PlyReader(const Source& source, PlyHeader header)
      : source_(source),
        header_(std::move(header)),
        pool_(source.bytes.size() < kBytesWorthThreads ? 1 : source.options.threads) {}

  Result<Scene> read() {
    if (Status s = check_header(); !s) return s.error();
    Status status = header_.format == PlyFormat::ascii           ? read_elements<AsciiPlyValues>()
                    : header_.format == PlyFormat::little_endian ? read_elements<BinaryPlyValues<false>>()
                                                                 : read_elements<BinaryPlyValues<true>>();
    if (!status) return status.error();
    return finish();
  }

 private:
  Status check_header() const {
    const bool has_vertices =
        std::any_of(header_.elements.begin(), header_.elements.end(),
                    [](const PlyElement& e) { return e.name == "vertex" && PlyVertices(e).has_positions(); });
    if (!has_vertices) return broken(source_, "has no vertices with x, y and z");
    for (const PlyElement& e : header_.elements) {
      for (const PlyProperty& p : e.properties) {
        if (is_index_list(p) && !is_integer(p.type)) {
          return broken(source_,
                        "gives the vertices of its faces as fractions: " + p.name + " must be integers");
        }
      }
    }
    return Done{};
  }

  template <class Values>
  Status read_elements() {
    Values values(source_.bytes, header_.data_offset);
    bool vertices_read = false, faces_read = false;
    for (const PlyElement& e : header_.elements) {
      const std::size_t least = e.least_row_bytes(header_.format);
      if (least == 0) continue;
      // The last number of a text need not be followed by anything.
      if (e.count > (values.left() + 1) / least) {
        return broken(source_, "is cut short: it announces " + std::to_string(e.count) + " of '" + e.name +
                                   "', more than its " + std::to_string(values.left()) +
                                   " bytes of data can hold");
      }
      Status status = Done{};
      if (e.name == "vertex" && !vertices_read) {
        status = read_vertices(e, values);
        vertices_read = true;
      } else if ((e.name == "face" && !faces_read) || e.name == "tristrips") {
        status = read_faces(e, values);
        faces_read = faces_read || e.name == "face";
      } else {
        status = skip(e, values);
      }
      if (!status) return status;
    }
    if (header_.format != PlyFormat::ascii && values.left() > 1) {
      scene_.problems.push_back("ignored " + std::to_string(values.left()) + " bytes after the last element");
    }
    return Done{};
  }

  static std::string row_name(const PlyElement& e, std::uint64_t row) {
    return "'" + e.name + "' " + std::to_string(row + 1) + " of " + std::to_string(e.count);
  }

  template <class Values>
  bool next_count(const PlyProperty& p, Values& values, std::uint64_t& count) {
    double number = 0;
    if (!values.next(p.count_type, number) || !(number >= 0) || number != std::floor(number)) return false;
    if (number > static_cast<double>(values.left() + 1)) return false;
    count = static_cast<std::uint64_t>(number);
    return true;
  }

  template <class Values>
  bool skip_property(const PlyProperty& p, Values& values) {
    std::uint64_t count = 1;
    if (p.is_list && !next_count(p, values, count)) return false;
    return values.skip(p.type, count);
  }

  template <class Values>
  Status skip(const PlyElement& e, Values& values) {
    for (std::uint64_t row = 0; row < e.count; ++row) {
      for (const PlyProperty& p : e.properties) {
        if (!skip_property(p, values)) return values.failure(source_, row_name(e, row));
      }
    }
    return Done{};
  }

  template <class Values>
  Status read_vertices(const PlyElement& e, Values& values) {
    PlyVertices vertices(e);
    if (Status s = check_limits(source_, 0, e.count * vertices.bytes_per_vertex()); !s) return s;
    vertices.allocate(mesh_);
    if (header_.format != PlyFormat::ascii && !e.has_lists()) {
      const std::size_t row_bytes = e.least_row_bytes(header_.format);
      const std::byte* rows = source_.bytes.data() + values.offset();
      if (!values.skip(PlyType::uint8, e.count * row_bytes)) return values.failure(source_, "its vertices");
      vertices.store_rows(rows, row_bytes, header_.format, pool_);
      return Done{};
    }
    for (std::uint64_t row = 0; row < e.count; ++row) {
      for (std::size_t i = 0; i < e.properties.size(); ++i) {
        const PlyProperty& p = e.properties[i];
        double value = 0;
        if (!(p.is_list ? skip_property(p, values) : values.next(p.type, value))) {
          return values.failure(source_, row_name(e, row));
        }
        if (!p.is_list) vertices.store(row, i, value);
      }
    }
    return Done{};
  }

  enum class Role { skipped, corners, color };

  // What each property of a face is for.
  static std::vector<Role> find_roles(const PlyElement& e, bool with_colors) {
    std::vector<Role> roles;
    std::size_t colors = 0;
    for (const PlyProperty& p : e.properties) {
      const bool color = with_colors && !p.is_list && ply_color_channel(p.name) >= 0;
      roles.push_back(is_index_list(p) ? Role::corners : color ? Role::color : Role::skipped);
      colors += color;
    }
    if (colors < 3) std::replace(roles.begin(), roles.end(), Role::color, Role::skipped);
    return roles;
  }

  template <class Values>
  Status read_faces(const PlyElement& e, Values& values) {
    const std::vector<Role> roles = find_roles(e, e.name == "face" && mesh_.colors.empty());
    const bool colored = std::find(roles.begin(), roles.end(), Role::color) != roles.end();
    if (header_.format != PlyFormat::ascii && !colored && read_triangles(e, values)) return Done{};
    for (std::uint64_t row = 0; row < e.count; ++row) {
      Vec4f color{0, 0, 0, 1};
      for (std::size_t i = 0; i < roles.size(); ++i) {
        const PlyProperty& p = e.properties[i];
        const bool ok = roles[i] == Role::corners ? read_index_list(e, p, values)
                        : roles[i] == Role::color ? read_color(p, values, color)
                                                  : skip_property(p, values);
        if (!ok) return values.failure(source_, row_name(e, row));
      }
      if (colored) faces_.colors.resize(faces_.sizes.size(), color);
    }
    return Done{};
  }

  template <class Values>
  bool read_color(const PlyProperty& p, Values& values, Vec4f& color) {
    double value = 0;
    if (!values.next(p.type, value)) return false;
    switch (ply_color_channel(p.name)) {
      case 0:
        color.x = ply_color(p.type, value);
        break;
      case 1:
        color.y = ply_color(p.type, value);
        break;
      case 2:
        color.z = ply_color(p.type, value);
        break;
      default:
        color.w = ply_alpha(p.type, value);
        break;
    }
    return true;
  }

  template <class Values>
  bool read_index_list(const PlyElement& e, const PlyProperty& p, Values& values) {
    std::uint64_t count = 0;
    if (!next_count(p, values, count)) return false;
    Strip strip;
    for (std::uint64_t i = 0; i < count; ++i) {
      double value = 0;
      if (!values.next(p.type, value)) return false;
      if (e.name == "tristrips") {
        strip.add(value, faces_);
      } else {
        faces_.corners.push_back(to_index(value));
      }
    }
    if (e.name == "face") faces_.end_face();
    return true;
  }

  // Faces that are all triangles, with one list of the usual types: rows of one size. False, and nothing
  // done, for others.
  template <class Values>
  bool read_triangles(const PlyElement& e, Values& values) {
    if (e.name != "face" || !faces_.sizes.empty() || !mesh_.indices.empty()) return false;
    std::size_t row_bytes = 0, list_offset = 0;
    const PlyProperty* list = nullptr;
    for (const PlyProperty& p : e.properties) {
      if (!p.is_list) {
        row_bytes += size_of(p.type);
        continue;
      }
      if (!is_index_list(p) || list != nullptr) return false;
      list = &p;
      list_offset = row_bytes;
      row_bytes += size_of(p.count_type) + 3 * size_of(p.type);
    }
    if (list == nullptr || size_of(list->type) != 4 || size_of(list->count_type) == 2) return false;
    if (values.left() / row_bytes < e.count) return false;
    if (e.count > source_.options.limits.max_triangles) return false;  // the other way says so

    const std::byte* rows = source_.bytes.data() + values.offset();
    mesh_.indices.resize(3 * e.count);
    const bool swap = header_.format == PlyFormat::big_endian;
    const bool byte_counts = size_of(list->count_type) == 1;
    const bool all =
        swap ? (byte_counts ? copy_triangles<std::uint8_t, true>(rows + list_offset, row_bytes)
                            : copy_triangles<std::uint32_t, true>(rows + list_offset, row_bytes))
             : (byte_counts ? copy_triangles<std::uint8_t, false>(rows + list_offset, row_bytes)
                            : copy_triangles<std::uint32_t, false>(rows + list_offset, row_bytes));
    if (!all) mesh_.indices = {};
    return all && values.skip(PlyType::uint8, e.count * row_bytes);
  }

  // Whether every row's count is three; stops early where one is not.
  template <class Count, bool kSwap>
  bool copy_triangles(const std::byte* lists, std::size_t row_bytes) {
    const std::size_t count = mesh_.indices.size() / 3;
    std::atomic<bool> all = true;
    pool_.for_each((count + kFacesPerBlock - 1) / kFacesPerBlock, [&](int, std::size_t block) {
      const std::size_t end = std::min(count, (block + 1) * kFacesPerBlock);
      if (!all.load(std::memory_order_relaxed)) return;
      for (std::size_t face = block * kFacesPerBlock; face < end; ++face) {
        const std::byte* from = lists + face * row_bytes;
        if (load<Count, kSwap>(from) != 3) {
          all.store(false, std::memory_order_relaxed);
          return;
        }
        from += sizeof(Count);
        std::uint32_t* to = &mesh_.indices[3 * face];
        for (std::size_t k = 0; k < 3; ++k) {
          to[k] = load<std::uint32_t, kSwap>(from + k * sizeof(std::uint32_t));
        }
      }
    });
    return all;
  }

  Result<Scene> finish() {
    if (mesh_.indices.empty() && faces_.sizes.empty()) {
      scene_.problems.push_back(std::to_string(mesh_.positions.size()) + " points without faces");
    }
    if (!mesh_.indices.empty() && faces_.sizes.empty()) {
      drop_bad_triangles(mesh_, scene_.problems, pool_);
    } else {
      append_strips();
      if (Status s = add_faces(source_, std::move(faces_), mesh_, scene_.problems); !s) return s.error();
    }
    mend_normals(mesh_);
    const bool textured = !header_.texture.empty() && !mesh_.texcoords.empty();
    add_mesh(scene_, std::move(mesh_));
    if (textured && !scene_.materials.empty()) {
      TextureReference texture;
      texture.uri = header_.texture;
      scene_.textures.push_back(std::move(texture));
      scene_.materials[0].color_texture = 0;
    }
    return std::move(scene_);
  }

  // Strips may follow triangles of the fast way, or faces with colours.
  void append_strips() {
    if (!mesh_.indices.empty()) {
      faces_.sizes.insert(faces_.sizes.end(), mesh_.indices.size() / 3, 3u);
      faces_.corners.insert(faces_.corners.end(), mesh_.indices.begin(), mesh_.indices.end());
      mesh_.indices = {};
    }
    if (!faces_.colors.empty()) faces_.colors.resize(faces_.sizes.size(), Vec4f{1, 1, 1, 1});
  }

  const Source& source_;
  PlyHeader header_;
  ThreadPool pool_;
  Mesh mesh_;
  Faces faces_;
  Scene scene_;
};

}  // namespace

Result<Scene> read_ply(const Source& source) {
  Result<PlyHeader> header = read_ply_header(source);
  if (!header) return header.error();
  return PlyReader(source, std::move(*header)).read();
}

}  // namespace blysk::io
