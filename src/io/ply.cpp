// PLY, ASCII and binary of both byte orders: any order of elements and properties, faces and triangle strips.
//
// Two ways through the rows: those of binary files as programs write them (vertices without lists, faces with
// none but that of their vertices) are converted in parallel; all others are read value by value.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "core/threads.h"
#include "io/faces.h"
#include "io/ply_faces.h"
#include "io/ply_header.h"
#include "io/ply_values.h"
#include "io/ply_vertices.h"
#include "io/reader.h"
#include "scene/normals.h"

namespace blysk::io {
namespace {

constexpr std::size_t kBytesWorthThreads = std::size_t{1} << 20;
constexpr Vec4f kWhite{1, 1, 1, 1};

// As the file may have it: a whole number, or anything.
std::string index_text(double value) {
  if (value == std::floor(value) && std::abs(value) < 1e15)
    return std::to_string(static_cast<long long>(value));
  char text[32];  // not to_string(), which writes 309 digits for the largest
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

// A strip's triangles, turning their order every time; an index below zero begins a new strip.
class Strip {
 public:
  void end() { length_ = 0; }
  void add(std::uint32_t index, Faces& faces) {
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
  Status check_header() {
    const auto found = std::find_if(
        header_.elements.begin(), header_.elements.end(),
        [](const PlyElement& e) { return e.name == "vertex" && PlyVertices(e).has_positions(); });
    if (found == header_.elements.end())
      return broken(source_, "has no vertices with x, y and z; export the model again");
    vertices_ = &*found;
    for (const PlyElement& e : header_.elements) {
      for (const PlyProperty& p : e.properties) {
        if (is_index_list(p) && !is_integer(p.type)) {
          return broken(source_, "gives the vertices of its faces as fractions: " + p.name +
                                     " must be integers; export the model again");
        }
      }
    }
    return Done{};
  }

  template <class Values>
  Status read_elements() {
    Values values(source_.bytes, header_.data_offset);
    bool faces_read = false;
    for (const PlyElement& e : header_.elements) {
      const std::size_t least = e.least_row_bytes(header_.format);
      if (least == 0) continue;
      // The last number of a text need not be followed by anything.
      if (e.count > (values.left() + 1) / least) {
        return broken(source_, "is cut short: it announces " + std::to_string(e.count) + " of '" + e.name +
                                   "', more than its " + std::to_string(values.left()) +
                                   " bytes of data can hold; fetch or export it again");
      }
      Status status = Done{};
      if (&e == vertices_) {
        status = read_vertices(e, values);
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

  template <class Values>
  Status read_faces(const PlyElement& e, Values& values) {
    const bool may_color = e.name == "face" && mesh_.colors.empty();
    if (Status s = check_face_memory(e, may_color, values.left()); !s) return s;
    if (e.name == "face" && faces_.corners.empty() && read_rows(e, may_color, values)) return Done{};
    const std::vector<std::size_t> colors = may_color ? face_color_properties(e) : std::vector<std::size_t>{};
    faces_.begin_faces();
    if (!colors.empty()) faces_.colors.resize(faces_.count(), kWhite);
    for (std::uint64_t row = 0; row < e.count; ++row) {
      Vec4f color{0, 0, 0, 1};
      auto next_color = colors.begin();
      for (std::size_t i = 0; i < e.properties.size(); ++i) {
        const PlyProperty& p = e.properties[i];
        const bool colored = next_color != colors.end() && *next_color == i;
        Status status = Done{};
        if (is_index_list(p)) {
          status = read_index_list(e, row, p, values);
        } else if (colored ? !read_color(p, values, color) : !skip_property(p, values)) {
          status = values.failure(source_, row_name(e, row));
        }
        if (!status) return status;
        next_color += colored;
      }
      if (!colors.empty()) faces_.colors.resize(faces_.count(), color);
    }
    return Done{};
  }

  // Before it is taken: indices become 32 bits wide.
  Status check_face_memory(const PlyElement& e, bool may_color, std::uint64_t bytes) const {
    std::uint64_t least =
        header_.format == PlyFormat::ascii ? 2 : sizeof(std::uint32_t);  // a digit and a space
    for (const PlyProperty& p : e.properties) {
      if (is_index_list(p) && header_.format != PlyFormat::ascii)
        least = std::min<std::uint64_t>(least, size_of(p.type));
    }
    const std::uint64_t per_face = sizeof(std::uint32_t) + (may_color ? sizeof(Vec4f) : 0);
    return check_limits(source_, 0, e.count * per_face + bytes / least * sizeof(std::uint32_t));
  }

  // The parallel way; false, and nothing done, where it cannot go.
  template <class Values>
  bool read_rows(const PlyElement& e, bool may_color, Values& values) {
    const PlyFaceRows rows(e, header_.format, may_color);
    if (!rows.usable()) return false;
    const std::size_t bytes =
        rows.read(source_.bytes.subspan(values.offset()), vertices_->count, faces_, pool_);
    return bytes > 0 && values.skip(PlyType::uint8, bytes);
  }

  template <class Values>
  bool read_color(const PlyProperty& p, Values& values, Vec4f& color) {
    double value = 0;
    if (!values.next(p.type, value)) return false;
    const int channel = ply_color_channel(p.name);
    (&color.x)[channel] = ply_color(channel, p.type, value);
    return true;
  }

  template <class Values>
  Status read_index_list(const PlyElement& e, std::uint64_t row, const PlyProperty& p, Values& values) {
    double number = 0;
    if (!values.next(p.count_type, number)) return values.failure(source_, row_name(e, row));
    if (!(number >= 0 && number <= static_cast<double>(values.left() + 1)) || number != std::floor(number)) {
      return values.complaint(
          source_, row_name(e, row) + " has " + index_text(number) + " for the number of its corners, and " +
                       std::to_string(values.left()) + " bytes follow; fetch or export the model again");
    }
    const auto count = static_cast<std::uint64_t>(number);
    const std::uint64_t vertices = vertices_->count;
    const bool strips = e.name == "tristrips";
    Strip strip;
    for (std::uint64_t i = 0; i < count; ++i) {
      double value = 0;
      if (!values.next(p.type, value)) return values.failure(source_, row_name(e, row));
      if (strips && value < 0) {
        strip.end();
      } else if (!(value >= 0 && value < static_cast<double>(vertices)) || value != std::floor(value)) {
        return values.complaint(source_, no_such_vertex(row_name(e, row), index_text(value), vertices));
      } else if (strips) {
        strip.add(static_cast<std::uint32_t>(value), faces_);
      } else {
        faces_.corners.push_back(static_cast<std::uint32_t>(value));
      }
    }
    if (!strips) faces_.end_face();
    return Done{};
  }

  Result<Scene> finish() {
    if (faces_.count() == 0) scene_.problems.push_back(no_faces(mesh_.positions.size()));
    if (!faces_.colors.empty()) faces_.colors.resize(faces_.count(), kWhite);  // strips have none
    if (Status s = add_faces(source_, std::move(faces_), mesh_, scene_.problems, pool_); !s) return s.error();
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

  const Source& source_;
  PlyHeader header_;
  const PlyElement* vertices_ = nullptr;  // those that are drawn: the first with positions
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
