// STL, binary and ASCII. Equal corners near each other become one vertex; faces stay flat.
#include <bit>
#include <cstring>
#include <string>
#include <utility>

#include "core/threads.h"
#include "io/faces.h"
#include "io/polygon.h"
#include "io/reader.h"
#include "io/share_equal.h"
#include "io/stl_layout.h"
#include "io/text.h"
#include "scene/normals.h"

namespace blysk::io {
namespace {

// Memory of a mesh of n triangles: indices, and at worst every corner a vertex, held twice for a moment.
std::uint64_t memory_for(std::uint64_t triangles) { return triangles * 3 * (4 + 12 + 12); }

// A corner as bits, so that a NaN finds itself.
struct Corner {
  std::uint32_t x, y, z;

  [[nodiscard]] std::uint64_t hash() const {
    const std::uint64_t xy = x | std::uint64_t{y} << 32;
    const std::uint64_t h = (xy ^ (xy >> 29)) * 0x9e3779b97f4a7c15u;
    return (h ^ (h >> 32) ^ z) * 0xd6e8feb86659fd93u;
  }
  friend bool operator==(const Corner&, const Corner&) = default;
};

Corner load_corner(const std::byte* at) {
  Vec3f p;
  std::memcpy(&p, at, sizeof p);
  return std::bit_cast<Corner>(Vec3f{p.x + 0.0f, p.y + 0.0f, p.z + 0.0f});  // -0 + 0 is 0
}

// Adds a mesh of triangles, less the bad ones. Their packed corners stand `stride` bytes from each other.
void add_triangles(const std::byte* first, std::size_t count, std::size_t stride, int threads,
                   std::string name, Scene& scene) {
  ThreadPool pool(count < kTrianglesWorthThreads ? 1 : threads);
  const auto each = [&](std::size_t begin, std::size_t end, const auto& take) {
    for (std::size_t triangle = begin / 3; triangle < end / 3; ++triangle) {
      const std::byte* corner = first + triangle * stride;
      for (int k = 0; k < 3; ++k) take(load_corner(corner + static_cast<std::size_t>(k) * sizeof(Vec3f)));
    }
  };
  SharedKeys<Corner> shared = share_equal<Corner>(3 * count, each, pool);
  Mesh mesh;
  mesh.name = std::move(name);
  mesh.positions.resize(shared.count());
  pool.for_each(shared.runs.size(), [&](int, std::size_t run) {
    Vec3f* to = mesh.positions.data() + shared.first[run];
    for (const Corner& corner : shared.runs[run]) *to++ = std::bit_cast<Vec3f>(corner);
    shared.runs[run] = {};
  });
  mesh.indices = std::move(shared.ids);
  drop_bad_triangles(mesh, scene.problems, pool);
  add_mesh(scene, std::move(mesh));
}

Result<Scene> read_binary(const Source& source) {
  const std::span<const std::byte> bytes = source.bytes;
  if (bytes.size() < kStlHeader)
    return broken(source,
                  "is cut short: a binary STL has 84 bytes before its triangles; fetch or export it again");
  const std::uint64_t count = stl_count(bytes), held = (bytes.size() - kStlHeader) / kStlTriangle;
  if (count > held) {
    return broken(source, "is cut short: it announces " + std::to_string(count) + " triangles and holds " +
                              std::to_string(held) + "; fetch or export it again");
  }
  if (Status s = check_limits(source, count, memory_for(count)); !s) return s.error();
  if (Status s = check_index_width(source, count); !s) return s.error();

  Scene scene;
  if (count == 0) {
    scene.problems.push_back("a binary STL of 0 triangles, followed by " +
                             std::to_string(bytes.size() - kStlHeader) + " bytes");
  } else if (bytes.size() != kStlHeader + kStlTriangle * count) {
    scene.problems.push_back("ignored " + std::to_string(bytes.size() - kStlHeader - kStlTriangle * count) +
                             " bytes after the last of " + std::to_string(count) + " triangles");
  }
  const std::byte* first_corner = bytes.data() + kStlHeader + sizeof(Vec3f);  // behind a normal
  add_triangles(first_corner, count, kStlTriangle, source.options.threads, {}, scene);
  return scene;
}

// Facets of the ASCII form. Its words may stand on any lines; only names end where their line does.
class AsciiStl {
 public:
  explicit AsciiStl(const Source& source) : source_(source), text_(source.text()) {}

  Result<Scene> read() {
    while (!text_.at_end()) {
      text_.skip_space();
      word_start_ = text_.offset();
      const std::string_view word = text_.word();
      if (word.empty()) break;
      if (Status s = read_word(word); !s) return s.error();
    }
    if (in_facet_) return fail("is cut short: it ends in a facet; fetch or export it again");
    if (in_solid_) scene_.problems.push_back("no endsolid at the end: the file may be cut short");
    if (Status s = end_solid(); !s) return s.error();
    if (triangles_ == 0) scene_.problems.push_back("an ASCII STL without a facet");
    return std::move(scene_);
  }

 private:
  Error fail(std::string message) const { return broken_at(source_, word_start_, std::move(message)); }

  Status read_word(std::string_view word) {
    if (same_word(word, "vertex")) return read_vertex();
    if (same_word(word, "facet")) {
      in_facet_ = true;
      polygon_.clear();
      text_.word();  // "normal"; it follows from the corners
      for (int i = 0; i < 3; ++i) text_.word();
    } else if (same_word(word, "outer")) {
      text_.word();  // "loop"
    } else if (same_word(word, "endloop")) {
      return end_loop();
    } else if (same_word(word, "endfacet")) {
      in_facet_ = false;
    } else if (same_word(word, "solid")) {
      if (Status s = end_solid(); !s) return s;
      in_solid_ = true;
      text_.skip_blanks();
      name_ = std::string(text_.line());
    } else if (same_word(word, "endsolid")) {
      text_.skip_blanks();
      text_.line();
      in_solid_ = false;
      return end_solid();
    } else {
      return fail(
          "has a word that is not of STL where a facet or a vertex should stand; mend it or export the model "
          "again");
    }
    return Done{};
  }

  Status read_vertex() {
    Vec3f p;
    if (!text_.number(p.x) || !text_.number(p.y) || !text_.number(p.z)) {
      return fail("a vertex needs three numbers; mend it or export the model again");
    }
    polygon_.push_back(p);
    return Done{};
  }

  Status end_loop() {
    if (polygon_.size() < 3) return fail("a facet needs three vertices; mend it or export the model again");
    local_.clear();
    triangulate({polygon_.data(), polygon_.size()}, local_);
    for (const std::uint32_t corner : local_) corners_.push_back(polygon_[corner]);
    polygon_.clear();
    return Done{};
  }

  Status end_solid() {
    const std::uint64_t triangles = corners_.size() / 3;
    triangles_ += triangles;
    if (Status s = check_limits(source_, triangles_, memory_for(triangles_)); !s) return s;
    if (Status s = check_index_width(source_, triangles); !s) return s;
    if (triangles == 0) return Done{};
    add_triangles(reinterpret_cast<const std::byte*>(corners_.data()), triangles, 3 * sizeof(Vec3f),
                  source_.options.threads, name_, scene_);
    corners_.clear();
    name_.clear();
    return Done{};
  }

  const Source& source_;
  TextCursor text_;
  std::size_t word_start_ = 0;
  bool in_solid_ = false, in_facet_ = false;
  std::string name_;
  Array<Vec3f> polygon_, corners_;
  Array<std::uint32_t> local_;
  std::uint64_t triangles_ = 0;
  Scene scene_;
};

// Headers of binary files begin with "solid" too; only text has a facet or the end right after its first
// line.
bool is_ascii(const Source& source) {
  if (has_stl_size(source.bytes)) return false;
  TextCursor text(source.text());
  if (!same_word(text.word(), "solid")) return false;
  text.line();
  const std::string_view word = text.word();
  return word.empty() || same_word(word, "facet") || same_word(word, "endsolid") || same_word(word, "solid");
}

}  // namespace

Result<Scene> read_stl(const Source& source) {
  return is_ascii(source) ? AsciiStl(source).read() : read_binary(source);
}

}  // namespace blysk::io
