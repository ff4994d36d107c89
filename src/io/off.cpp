// OFF with its prefixes: ST (texture coordinates), C (vertex colours), N (normals); faces may have colours.
//
// Colours are sRGB values: 0..255 where a file has any above one, else 0..1.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "io/faces.h"
#include "io/reader.h"
#include "io/text.h"
#include "math/srgb.h"
#include "scene/normals.h"

namespace blysk::io {
namespace {

constexpr std::size_t kMostWords =
    8;  // looked for on the rest of a line: more than a colour and what follows it
constexpr std::size_t kMostDigitsShown = 40;  // of a wrong index: it may have a million
constexpr float kNoAlpha = -1;
constexpr Vec4f kUncolored{-1, -1, -1, -1};  // a face without a colour among faces with one
constexpr Vec4f kUncoloredLinear{0.8f, 0.8f, 0.8f, 1};

struct Layout {
  bool texcoords = false, colors = false, normals = false;
};

class OffReader {
 public:
  explicit OffReader(const Source& source) : source_(source), text_(source.text()) {}

  Result<Scene> read() {
    Status status = read_header();
    if (status) status = read_counts();
    if (status) status = read_vertices();
    if (status) status = read_faces();
    if (status) status = finish();
    if (!status) return status.error();
    return std::move(scene_);
  }

 private:
  // The next word that is not in a comment, and where it stands.
  std::string_view next() {
    text_.skip_comments('#');
    word_start_ = text_.offset();
    return text_.word();
  }
  template <class T>
  bool next(T& value) {
    return parse_number(next(), value);
  }

  Error refuse(const std::string& message) const { return broken_at(source_, word_start_, message); }
  Error fail(const std::string& message) const {
    const bool at_end = word_start_ == source_.bytes.size();
    return refuse(at_end ? "is cut short: " + message + "; fetch or export it again"
                         : message + "; mend the line or export the model again");
  }

  // The keyword is optional: a file may begin with its counts.
  Status read_header() {
    TextCursor before = text_;
    std::string_view word = next();
    if (long long count = 0; parse_number(word, count)) {
      text_ = before;
      return Done{};
    }
    const auto take = [&](std::string_view prefix) {
      if (!word.starts_with(prefix)) return false;
      word.remove_prefix(prefix.size());
      return true;
    };
    layout_.texcoords = take("ST");
    layout_.colors = take("C");
    layout_.normals = take("N");
    if (take("4") || take("n"))
      return refuse("OFF in other than three dimensions (4OFF, nOFF) is not read; project it first");
    if (word != "OFF") return fail("does not begin with OFF");
    before = text_;
    if (next() == "BINARY") return refuse("binary OFF is not read; save the model as text");
    text_ = before;
    return Done{};
  }

  Status read_counts() {
    long long vertices = 0, faces = 0;
    if (!next(vertices) || !next(faces) || vertices < 0 || faces < 0) {
      return fail("needs the numbers of its vertices and faces after OFF");
    }
    skip_edges();
    vertex_count_ = static_cast<std::uint64_t>(vertices);
    face_count_ = static_cast<std::uint64_t>(faces);
    const std::uint64_t left = text_.left() + 1;  // the last number need not be followed by anything
    if (vertex_count_ > left / (2 * least_vertex_words()) || face_count_ > left / 2) {
      return fail("it announces " + std::to_string(vertices) + " vertices and " + std::to_string(faces) +
                  " faces, more than its " + std::to_string(text_.left()) + " bytes of data can hold");
    }
    const std::uint64_t per_vertex = sizeof(Vec3f) + (layout_.normals ? sizeof(Vec3f) : 0) +
                                     (layout_.colors ? sizeof(Vec4f) : 0) +
                                     (layout_.texcoords ? sizeof(Vec2f) : 0);
    return check_limits(source_, 0, vertex_count_ * per_vertex);
  }

  // The number of edges is of no use, and absent in some files: then nothing follows on the line, and no
  // number stands alone on the next.
  void skip_edges() {
    if (words_left_on_line() > 0) {
      next();
      return;
    }
    TextCursor before = text_;
    next();
    if (words_left_on_line() > 0) text_ = before;
  }

  // At most kMostWords: a file may be one line.
  std::size_t words_left_on_line() const {
    TextCursor line = text_;
    std::size_t words = 0;
    for (; words < kMostWords && !line.at_line_end(); ++words) {
      if (line.word().starts_with('#')) break;
    }
    return words;
  }

  std::uint64_t least_vertex_words() const {
    return 3 + (layout_.normals ? 3u : 0u) + (layout_.colors ? 3u : 0u) + (layout_.texcoords ? 2u : 0u);
  }

  bool next(Vec3f& v) { return next(v.x) && next(v.y) && next(v.z); }

  // Alpha is optional: the words on the line tell.
  bool next_color(std::size_t words_after, Vec4f& color, float& largest) {
    const bool alpha = words_left_on_line() != words_after + 3;
    if (!next(color.x) || !next(color.y) || !next(color.z)) return false;
    color.w = kNoAlpha;
    if (alpha && !next(color.w)) return false;
    largest = std::max({largest, color.x, color.y, color.z});
    return true;
  }

  Status read_vertices() {
    mesh_.positions.resize(vertex_count_);
    if (layout_.normals) mesh_.normals.resize(vertex_count_);
    if (layout_.colors) mesh_.colors.resize(vertex_count_);
    if (layout_.texcoords) mesh_.texcoords.resize(vertex_count_);
    float largest = 0;
    for (std::uint64_t i = 0; i < vertex_count_; ++i) {
      const bool ok = next(mesh_.positions[i]) && (!layout_.normals || next(mesh_.normals[i])) &&
                      (!layout_.colors || next_color(layout_.texcoords ? 2 : 0, mesh_.colors[i], largest)) &&
                      (!layout_.texcoords || (next(mesh_.texcoords[i].x) && next(mesh_.texcoords[i].y)));
      if (!ok) return fail("vertex " + std::to_string(i) + " needs more numbers");
    }
    make_linear(mesh_.colors, largest);
    return Done{};
  }

  Status read_faces() {
    if (face_count_ == 0) scene_.problems.push_back(no_faces(vertex_count_));
    Faces faces;
    faces.sizes.reserve(face_count_);
    float largest = 0;
    for (std::uint64_t i = 0; i < face_count_; ++i) {
      long long size = 0;
      if (!next(size) || size < 0)
        return fail("face " + std::to_string(i) + " needs the number of its corners");
      if (static_cast<std::uint64_t>(size) > text_.left()) {
        return refuse("face " + std::to_string(i) + " announces " + std::to_string(size) +
                      " corners, more than the rest of the file holds; fetch or export it again");
      }
      for (long long k = 0; k < size; ++k) {
        double index = 0;
        const std::string_view word = next();
        if (!parse_number(word, index)) return fail("face " + std::to_string(i) + " needs more corners");
        if (!(index >= 0 && index < static_cast<double>(vertex_count_)) || index != std::floor(index)) {
          const std::string shown(word.substr(0, kMostDigitsShown));
          return refuse(no_such_vertex("face " + std::to_string(i), shown, vertex_count_));
        }
        faces.corners.push_back(static_cast<std::uint32_t>(index));
      }
      faces.end_face();
      const std::size_t words = words_left_on_line();
      if (!layout_.colors && (words == 3 || words == 4)) {
        Vec4f color;
        if (!next_color(0, color, largest))
          return fail("face " + std::to_string(i) + " has a colour that is no number");
        faces.colors.resize(faces.sizes.size() - 1, kUncolored);
        faces.colors.push_back(color);
      }
      text_.line();
    }
    if (!faces.colors.empty()) faces.colors.resize(faces.sizes.size(), kUncolored);
    make_linear(faces.colors, largest);
    ThreadPool pool(faces.count() < kTrianglesWorthThreads ? 1 : source_.options.threads);
    return add_faces(source_, std::move(faces), mesh_, scene_.problems, pool);
  }

  static void make_linear(Array<Vec4f>& colors, float largest) {
    const float whole = largest > 1 ? 255.0f : 1.0f;
    const auto bend = [&](float v) {
      return static_cast<float>(srgb_to_linear(static_cast<double>(v) / static_cast<double>(whole)));
    };
    for (Vec4f& c : colors) {
      const float alpha = c.w == kNoAlpha ? 1.0f : c.w / whole;
      c = c == kUncolored ? kUncoloredLinear
                          : Vec4f{bend(c.x), bend(c.y), bend(c.z), alpha > 0 ? std::min(alpha, 1.0f) : 0};
    }
  }

  Status finish() {
    mend_normals(mesh_);
    add_mesh(scene_, std::move(mesh_));
    return Done{};
  }

  const Source& source_;
  TextCursor text_;
  Layout layout_;
  std::size_t word_start_ = 0;
  std::uint64_t vertex_count_ = 0, face_count_ = 0;
  Mesh mesh_;
  Scene scene_;
};

}  // namespace

Result<Scene> read_off(const Source& source) { return OffReader(source).read(); }

}  // namespace blysk::io
