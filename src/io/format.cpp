#include "io/format.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "io/stl_layout.h"
#include "io/text.h"

namespace blysk::io {
namespace {

constexpr std::string_view kFormats = "OBJ, STL, PLY, OFF, glTF (.gltf, .glb)";
constexpr std::size_t kObjLinesLooked = 200;
constexpr std::size_t kSolidBytesLooked = 4096;

// What people hand over that is no model of ours, and what to tell them.
struct Foreign {
  std::string_view start, sentence;
};
constexpr Foreign kForeign[] = {
    {"version https://git-lfs", "is a Git LFS pointer, not the model itself; run `git lfs pull`"},
    {"PK\3\4", "is a ZIP archive (a 3MF or USDZ model, perhaps); unpack or convert it first"},
    {"\x1f\x8b", "is compressed with gzip; unpack it first"},
    {"Kaydara FBX Binary", "is an FBX model, which Blysk does not read; convert it to glTF"},
    {"ISO-10303-21", "is a STEP model, which Blysk does not read; convert it to STL or glTF"},
    {"<?xml", "is XML (a COLLADA or X3D model, perhaps), which Blysk does not read; convert it to glTF"},
    {"BLENDER", "is a Blender file, which Blysk does not read; export it as glTF"},
};

std::optional<Format> by_extension(std::string_view name) {
  constexpr std::pair<std::string_view, Format> kExtensions[] = {
      {"obj", Format::obj}, {"stl", Format::stl},   {"ply", Format::ply},
      {"off", Format::off}, {"gltf", Format::gltf}, {"glb", Format::gltf}};
  const std::size_t dot = name.rfind('.');
  if (dot == std::string_view::npos) return std::nullopt;
  for (const auto& [extension, format] : kExtensions) {
    if (same_word(name.substr(dot + 1), extension)) return format;
  }
  return std::nullopt;
}

bool is_off(std::string_view text) {
  TextCursor cursor(text);
  cursor.skip_comments('#');
  std::string_view word = cursor.word();
  for (const std::string_view prefix : {"ST", "C", "N", "4", "n"}) {
    if (word.starts_with(prefix)) word.remove_prefix(prefix.size());
  }
  return word == "OFF";
}

bool is_ascii_stl(std::string_view text) {
  TextCursor cursor(text.substr(0, kSolidBytesLooked));
  if (!same_word(cursor.word(), "solid")) return false;
  while (!cursor.at_end()) {
    const std::string_view word = cursor.word();
    if (same_word(word, "facet") || same_word(word, "endsolid")) return true;
  }
  return false;
}

// Every line is blank, a comment, or begins with a word of the format; vertices or faces are among them.
bool is_obj(std::string_view text) {
  static constexpr std::string_view kWords[] = {"v",      "vt",     "vn",     "vp",     "f",      "l",
                                                "p",      "o",      "g",      "s",      "mg",     "deg",
                                                "cstype", "mtllib", "usemtl", "maplib", "usemap", "bevel"};
  TextCursor cursor(text);
  bool geometry = false;
  for (std::size_t line = 0; line < kObjLinesLooked && !cursor.at_end();) {
    cursor.skip_blanks();
    const std::string_view rest = cursor.line();
    if (rest.empty() || rest.front() == '#') continue;
    ++line;
    const std::string_view word = TextCursor(rest).word();
    if (std::find(std::begin(kWords), std::end(kWords), word) == std::end(kWords)) return false;
    geometry = geometry || word == "v" || word == "f" || word == "mtllib";
  }
  return geometry;
}

std::optional<Format> by_content(std::span<const std::byte> bytes) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  if (text.starts_with("glTF")) return Format::gltf;
  if (text.starts_with("ply\n") || text.starts_with("ply\r") || text.starts_with("ply ")) return Format::ply;
  if (is_off(text)) return Format::off;
  if (has_stl_size(bytes) || is_ascii_stl(text)) return Format::stl;
  TextCursor cursor(text);
  cursor.skip_space();
  if (text.substr(cursor.offset()).starts_with("{")) return Format::gltf;
  if (is_obj(text)) return Format::obj;
  return std::nullopt;
}

}  // namespace

Result<Format> find_format(std::span<const std::byte> bytes, std::string_view name) {
  const auto refuse = [&](std::string_view sentence) {
    return Error{ErrorCode::input, std::string(sentence), std::string(name)};
  };
  if (bytes.empty()) return refuse("is empty; save or fetch it again");
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  for (const Foreign& foreign : kForeign) {
    if (text.starts_with(foreign.start)) return refuse(foreign.sentence);
  }
  if (const auto format = by_content(bytes)) return *format;
  if (const auto format = by_extension(name)) return *format;
  return refuse("is not a model in any of the formats Blysk reads; convert it to one of " +
                std::string(kFormats));
}

}  // namespace blysk::io
