// Two walks over the text: the first counts statements, so that the second knows where its vertices belong,
// how far negative indices reach, and which indices are out of range.
#include "io/obj_parse.h"

#include <algorithm>
#include <cstring>
#include <exception>
#include <limits>
#include <optional>

#include "core/threads.h"
#include "io/decimal.h"
#include "math/srgb.h"

namespace blysk::io {
namespace {

enum class Statement { nothing, position, texcoord, normal, face, other };

// Of a line whose first byte that is not blank is at `at`.
Statement statement_at(const char* at) {
  switch (*at) {
    case '\n':
    case '#':
      return Statement::nothing;
    case 'f':
      return is_blank_or_end(at[1]) ? Statement::face : Statement::other;
    case 'v':
      if (is_blank_or_end(at[1])) return Statement::position;
      if (at[1] == 't' && is_blank_or_end(at[2])) return Statement::texcoord;
      if (at[1] == 'n' && is_blank_or_end(at[2])) return Statement::normal;
      return Statement::other;
    default:
      return Statement::other;
  }
}

const char* line_feed(const char* at, const char* end) {
  return static_cast<const char*>(std::memchr(at, '\n', static_cast<std::size_t>(end - at)));
}

struct Counts {
  std::size_t positions = 0, texcoords = 0, normals = 0, faces = 0;
  bool continued = false;  // a backslash at a line's end

  void add(const Counts& c) {
    positions += c.positions;
    texcoords += c.texcoords;
    normals += c.normals;
    faces += c.faces;
    continued |= c.continued;
  }
};

Counts count_statements(const ObjPiece& piece) {
  Counts n;
  for (const char* at = piece.begin; at != piece.end;) {
    at = skip_blanks(at);
    switch (statement_at(at)) {
      case Statement::position:
        ++n.positions;
        break;
      case Statement::texcoord:
        ++n.texcoords;
        break;
      case Statement::normal:
        ++n.normals;
        break;
      case Statement::face:
        ++n.faces;
        break;
      case Statement::nothing:
      case Statement::other:
        break;
    }
    const char* feed = line_feed(at, piece.end);
    if (feed - at > 1 && *at != '#')
      n.continued |= feed[-1] == '\\' || (feed[-1] == '\r' && feed[-2] == '\\');
    at = feed + 1;
  }
  return n;
}

struct PieceError {
  std::size_t offset = 0;
  std::string message;
};

// What a piece gives beside the vertices, which go where they belong at once.
struct PieceResult {
  Array<Vec4f> colors;  // of the piece's positions; empty: none
  bool zero_normals = false;
  std::size_t faces = 0;
  Array<std::uint32_t> face_sizes, corner_positions, corner_texcoords, corner_normals;
  std::vector<ObjEvent> events;
  ObjOmissions omissions;
  std::optional<PieceError> error;
  std::exception_ptr out_of_memory;
};

// A list that faces refer to.
struct Referred {
  const char* what;
  std::size_t before;  // how many stand before the statement that is read
  std::size_t total;   // in the whole file
};

class PieceParser {
 public:
  PieceParser(const ObjPiece& piece, const Counts& before, const Counts& total, const Counts& own,
              ObjFile& file)
      : piece_(piece),
        file_(file),
        positions_{"vertex", before.positions, total.positions},
        texcoords_{"texture coordinate", before.texcoords, total.texcoords},
        normals_{"normal", before.normals, total.normals},
        first_position_(before.positions) {
    result_.corner_positions.reserve(3 * own.faces);
  }

  PieceResult run() {
    const char* at = piece_.begin;
    while (at != piece_.end) {
      at = skip_blanks(at);
      line_ = at;
      if (!statement(at)) break;
      if (*at != '\n') at = line_feed(at, piece_.end);
      ++at;
    }
    return std::move(result_);
  }

 private:
  bool statement(const char*& at) {
    switch (statement_at(at)) {
      case Statement::nothing:
        return true;
      case Statement::position:
        return position(at);
      case Statement::texcoord:
        return texcoord(at);
      case Statement::normal:
        return normal(at);
      case Statement::face:
        return face(at);
      case Statement::other:
        other(at);
        return true;
    }
    return true;
  }

  bool fail(std::string message) {
    result_.error = {offset(), std::move(message)};
    return false;
  }
  std::size_t offset() const { return piece_.offset + static_cast<std::size_t>(line_ - piece_.begin); }

  // Up to `wanted` numbers that stand next; how many there are.
  static int numbers(const char*& at, float* values, int wanted) {
    for (int i = 0; i < wanted; ++i) {
      at = skip_blanks(at);
      if (!read_float(at, values[i]) || !is_blank_or_end(*at)) return i;
    }
    return wanted;
  }

  // v x y z [w], or v x y z r g b as MeshLab and others write it. The weight w is for curves only.
  bool position(const char*& at) {
    float v[6];
    ++at;
    const int count = numbers(at, v, 3);
    if (count < 3) return fail("a vertex needs three numbers, this one has " + std::to_string(count));
    file_.positions[positions_.before++] = {v[0], v[1], v[2]};
    at = skip_blanks(at);
    if (*at != '\n' && numbers(at, v + 3, 3) == 3) {
      if (result_.colors.empty())
        result_.colors.assign(positions_.before - first_position_ - 1, {1, 1, 1, 1});
      result_.colors.push_back({srgb_to_linear(v[3]), srgb_to_linear(v[4]), srgb_to_linear(v[5]), 1});
    } else if (!result_.colors.empty()) {
      result_.colors.push_back({1, 1, 1, 1});
    }
    return true;
  }
  // vt u [v [w]]
  bool texcoord(const char*& at) {
    float t[2] = {0, 0};
    at += 2;
    if (numbers(at, t, 2) == 0) return fail("a texture coordinate needs a number");
    file_.texcoords[texcoords_.before++] = {t[0], t[1]};
    return true;
  }

  bool normal(const char*& at) {
    float n[3];
    at += 2;
    const int count = numbers(at, n, 3);
    if (count < 3) return fail("a normal needs three numbers, this one has " + std::to_string(count));
    const Vec3f unit = to_float(normalize(to_double(Vec3f{n[0], n[1], n[2]}), {0, 0, 0}));
    result_.zero_normals |= unit == Vec3f{};
    file_.normals[normals_.before++] = unit;
    return true;
  }

  bool face(const char*& at) {
    const std::size_t first = result_.corner_positions.size();
    for (at = skip_blanks(at + 1); *at != '\n' && *at != '#'; at = skip_blanks(at)) {
      if (!corner(at)) return false;
    }
    const std::size_t size = result_.corner_positions.size() - first;
    if (size < 3) {
      drop_corners(first);
      if (result_.omissions.short_faces++ == 0) result_.omissions.first_short_face = offset();
      return true;
    }
    if (size != 3 && result_.face_sizes.empty()) result_.face_sizes.assign(result_.faces, 3);
    if (size != 3 || !result_.face_sizes.empty())
      result_.face_sizes.push_back(static_cast<std::uint32_t>(size));
    ++result_.faces;
    return true;
  }

  void drop_corners(std::size_t from) {
    result_.corner_positions.resize(from);
    if (!result_.corner_texcoords.empty()) result_.corner_texcoords.resize(from);
    if (!result_.corner_normals.empty()) result_.corner_normals.resize(from);
  }

  // v, v/t, v//n, v/t/n; what stands behind a slash may be missing.
  bool corner(const char*& at) {
    const char* const start = at;
    std::uint32_t v = 0, t = ObjFile::kNone, n = ObjFile::kNone;
    if (!index(at, positions_, v)) return bad_corner(start);
    if (*at == '/') {
      ++at;
      if (*at != '/' && !is_blank_or_end(*at) && !optional_index(at, texcoords_, t)) return bad_corner(start);
      if (*at == '/') {
        ++at;
        if (!is_blank_or_end(*at) && !optional_index(at, normals_, n)) return bad_corner(start);
      }
    }
    if (!is_blank_or_end(*at)) return bad_corner(start);
    result_.corner_positions.push_back(v);
    attribute(result_.corner_texcoords, t);
    attribute(result_.corner_normals, n);
    return true;
  }

  void attribute(Array<std::uint32_t>& list, std::uint32_t value) {
    if (value != ObjFile::kNone && list.empty())
      list.assign(result_.corner_positions.size() - 1, ObjFile::kNone);
    if (value != ObjFile::kNone || !list.empty()) list.push_back(value);
  }

  // False: not an index, or one that is out of range, which reference_ then tells.
  bool index(const char*& at, const Referred& list, std::uint32_t& value) {
    constexpr std::uint64_t kFar = std::uint64_t{1} << 40;
    const bool backwards = *at == '-';
    const char* digits = at + (backwards ? 1 : 0);
    const Digits first = read_digits(digits);
    if (first.count == 0) return false;
    std::uint64_t number = first.value;
    digits += first.count;
    for (; *digits >= '0' && *digits <= '9'; ++digits) {
      number = std::min(kFar, number * 10 + static_cast<std::uint64_t>(*digits - '0'));
    }
    // 0 becomes the largest number there is.
    if (number - 1 >= (backwards ? list.before : list.total)) {
      bad_reference_ = &list;
      bad_number_ = number;
      bad_backwards_ = backwards;
      return false;
    }
    value = static_cast<std::uint32_t>(backwards ? list.before - number : number - 1);
    at = digits;
    return true;
  }

  // Like index(), but a file without such a list is pardoned: the faces can be drawn without.
  bool optional_index(const char*& at, const Referred& list, std::uint32_t& value) {
    if (index(at, list, value)) return true;
    if (bad_reference_ == nullptr || list.total != 0) return false;
    bad_reference_ = nullptr;
    (&list == &normals_ ? result_.omissions.normals : result_.omissions.texcoords) = true;
    while (*at == '-' || (*at >= '0' && *at <= '9')) ++at;
    return true;
  }

  bool bad_corner(const char* start) {
    if (bad_reference_ == nullptr) {
      const char* end = start;
      while (!is_blank_or_end(*end)) ++end;
      return fail("a face corner must be an index or index/index/index, not " +
                  in_quotes({start, static_cast<std::size_t>(end - start)}));
    }
    const Referred& list = *bad_reference_;
    std::string subject = "a face uses ";
    subject +=
        std::string(list.what) + (bad_backwards_ ? " -" : " ") + std::to_string(bad_number_) + ", but ";
    if (bad_number_ == 0) return fail(subject + "they count from 1 to " + std::to_string(list.total));
    if (bad_backwards_) return fail(subject + "only " + std::to_string(list.before) + " stand before it");
    return fail(subject + "the file has " +
                (list.total == 0 ? "none" : "only " + std::to_string(list.total)));
  }

  void other(const char*& at) {
    const char* const keyword_begin = at;
    while (!is_blank_or_end(*at)) ++at;
    const std::string_view keyword(keyword_begin, static_cast<std::size_t>(at - keyword_begin));
    const char* const feed = line_feed(at, piece_.end);
    const std::string_view rest = trimmed({at, static_cast<std::size_t>(feed - at)});
    at = feed;
    const auto event = [&](ObjEvent::Kind kind) { result_.events.push_back({kind, result_.faces, rest}); };
    if (keyword == "usemtl") {
      event(ObjEvent::Kind::material);
    } else if (keyword == "s") {
      event(ObjEvent::Kind::smoothing);
    } else if (keyword == "o") {
      event(ObjEvent::Kind::object);
    } else if (keyword == "g") {
      event(ObjEvent::Kind::group);
    } else if (keyword == "mtllib") {
      event(ObjEvent::Kind::library);
    } else if (keyword == "p") {
      ++result_.omissions.points;
    } else if (keyword == "l") {
      ++result_.omissions.lines;
    } else {
      if (result_.omissions.unknown++ > 0) return;
      result_.omissions.first_unknown = offset();
      result_.omissions.first_keyword = keyword;
    }
  }

  const ObjPiece& piece_;
  ObjFile& file_;
  Referred positions_, texcoords_, normals_;
  std::size_t first_position_;
  const char* line_ = nullptr;
  const Referred* bad_reference_ = nullptr;
  std::uint64_t bad_number_ = 0;
  bool bad_backwards_ = false;
  PieceResult result_;
};

void add(ObjOmissions& to, const ObjOmissions& from) {
  if (to.short_faces == 0) to.first_short_face = from.first_short_face;
  if (to.unknown == 0) {
    to.first_unknown = from.first_unknown;
    to.first_keyword = from.first_keyword;
  }
  to.short_faces += from.short_faces;
  to.points += from.points;
  to.lines += from.lines;
  to.unknown += from.unknown;
  to.texcoords |= from.texcoords;
  to.normals |= from.normals;
}

// Where a piece's faces and corners begin among those of the file.
struct Place {
  std::size_t position = 0, face = 0, corner = 0;
};

// Copies a piece's part of a list that may be empty for `absent` throughout.
template <class T>
void place(Array<T>& to, const Array<T>& from, std::size_t begin, std::size_t count, T absent) {
  if (to.empty()) return;
  if (from.empty()) {
    std::fill_n(to.begin() + static_cast<std::ptrdiff_t>(begin), count, absent);
  } else {
    std::copy(from.begin(), from.end(), to.begin() + static_cast<std::ptrdiff_t>(begin));
  }
}

// A list may be there for a face that was left out later.
bool has_any(const Array<std::uint32_t>& list) {
  return std::any_of(list.begin(), list.end(), [](std::uint32_t i) { return i != ObjFile::kNone; });
}

// Puts the pieces' lists one after the other.
void join(ObjFile& file, std::vector<PieceResult>& parts, std::span<const Counts> own, ThreadPool& pool) {
  std::vector<Place> places;
  Place end;
  bool colors = false, sizes = false, texcoords = false, normals = false;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    PieceResult& p = parts[i];
    places.push_back(end);
    for (ObjEvent& e : p.events) e.face += end.face;
    file.events.insert(file.events.end(), p.events.begin(), p.events.end());
    add(file.omissions, p.omissions);
    file.zero_normals |= p.zero_normals;
    end.position += own[i].positions;
    end.face += p.faces;
    end.corner += p.corner_positions.size();
    colors |= !p.colors.empty();
    sizes |= !p.face_sizes.empty();
    texcoords |= has_any(p.corner_texcoords);
    normals |= has_any(p.corner_normals);
  }
  file.faces = end.face;
  if (colors) file.colors.resize(end.position);
  if (sizes) file.face_sizes.resize(end.face);
  if (texcoords) file.corner_texcoords.resize(end.corner);
  if (normals) file.corner_normals.resize(end.corner);
  file.corner_positions.resize(end.corner);
  pool.for_each(parts.size(), [&](int, std::size_t i) {
    PieceResult& p = parts[i];
    const std::size_t corner = places[i].corner, corners = p.corner_positions.size();
    place(file.colors, p.colors, places[i].position, own[i].positions, {1, 1, 1, 1});
    place(file.face_sizes, p.face_sizes, places[i].face, p.faces, 3u);
    place(file.corner_positions, p.corner_positions, corner, corners, ObjFile::kNone);
    place(file.corner_texcoords, p.corner_texcoords, corner, corners, ObjFile::kNone);
    place(file.corner_normals, p.corner_normals, corner, corners, ObjFile::kNone);
    p = {};
  });
}

std::vector<Counts> count_pieces(const ObjText& text, ThreadPool& pool, Counts& total) {
  std::vector<Counts> own(text.pieces().size());
  pool.for_each(own.size(), [&](int, std::size_t i) { own[i] = count_statements(text.pieces()[i]); });
  total = {};
  for (const Counts& c : own) total.add(c);
  return own;
}

}  // namespace

Result<ObjFile> parse_obj(const Source& source, ObjText& text) {
  const int wanted = source.options.threads > 0 ? source.options.threads : processor_count();
  ThreadPool pool(std::min(wanted, static_cast<int>(std::min<std::size_t>(text.pieces().size(), 1024))));
  Counts total;
  std::vector<Counts> own = count_pieces(text, pool, total);
  if (total.continued) {
    text.join_continued_lines();
    own = count_pieces(text, pool, total);
  }
  if (std::max({total.positions, total.texcoords, total.normals}) >= ObjFile::kNone) {
    return Error{ErrorCode::limit, "has more than 4294967294 vertices", source.name, 0};
  }
  const std::uint64_t bytes = total.positions * sizeof(Vec3f) + total.texcoords * sizeof(Vec2f) +
                              total.normals * sizeof(Vec3f) + total.faces * 3 * sizeof(std::uint32_t);
  if (Status s = check_limits(source, 0, bytes); !s) return s.error();

  ObjFile file;
  file.positions.resize(total.positions);
  file.texcoords.resize(total.texcoords);
  file.normals.resize(total.normals);
  std::vector<Counts> before(own.size());
  for (std::size_t i = 1; i < own.size(); ++i) {
    before[i] = before[i - 1];
    before[i].add(own[i - 1]);
  }
  std::vector<PieceResult> parts(own.size());
  pool.for_each(parts.size(), [&](int, std::size_t i) {
    try {
      parts[i] = PieceParser(text.pieces()[i], before[i], total, own[i], file).run();
    } catch (...) {
      parts[i].out_of_memory = std::current_exception();
    }
  });
  for (const PieceResult& p : parts) {
    if (p.out_of_memory) std::rethrow_exception(p.out_of_memory);
    if (p.error) {
      return Error{ErrorCode::input, p.error->message + "; mend the line or export the model again",
                   source.name, text.line_of(p.error->offset)};
    }
  }
  join(file, parts, own, pool);
  return file;
}

}  // namespace blysk::io
