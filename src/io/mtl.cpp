#include "io/mtl.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <set>
#include <system_error>

#include "io/obj_text.h"
#include "io/text.h"
#include "math/srgb.h"

namespace blysk::io {
namespace {

// More files than that is an attack: each costs a look at the disk, and may be large.
constexpr std::size_t kMostFiles = 64;
constexpr std::size_t kMostNamed = 8;  // things that one sentence lists

std::string lower(std::string_view text) {
  std::string s(text);
  for (char& c : s) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return s;
}

std::string_view next_word(std::string_view& text) {
  text = trimmed(text);
  std::size_t length = 0;
  while (length < text.size() && !is_blank_or_end(text[length])) ++length;
  const std::string_view word = text.substr(0, length);
  text.remove_prefix(length);
  return word;
}

// The number that stands next; `text` moves on only if there is one.
std::optional<float> next_number(std::string_view& text) {
  std::string_view rest = text;
  float value = 0;
  if (!parse_number(next_word(rest), value)) return std::nullopt;
  text = rest;
  return value;
}

// A map's options and how many words follow each; -o, -s and -t take one to three numbers.
struct MapOption {
  std::string_view name;
  int words;
  bool numbers;
};
constexpr std::array<MapOption, 14> kMapOptions = {{{"-blendu", 1, false},
                                                    {"-blendv", 1, false},
                                                    {"-boost", 1, false},
                                                    {"-bm", 1, false},
                                                    {"-cc", 1, false},
                                                    {"-clamp", 1, false},
                                                    {"-colorspace", 1, false},
                                                    {"-imfchan", 1, false},
                                                    {"-mm", 2, false},
                                                    {"-o", 3, true},
                                                    {"-s", 3, true},
                                                    {"-t", 3, true},
                                                    {"-texres", 1, false},
                                                    {"-type", 1, false}}};

const MapOption* find_option(std::string_view word) {
  const auto found = std::find_if(kMapOptions.begin(), kMapOptions.end(),
                                  [&](const MapOption& o) { return o.name == word; });
  return found == kMapOptions.end() ? nullptr : &*found;
}

void skip_option(const MapOption& option, std::string_view& text) {
  for (int i = 0; i < option.words; ++i) {
    if (option.numbers) {
      if (!next_number(text)) return;
    } else {
      next_word(text);
    }
  }
}

// The file name, which may hold blanks, between options in front and behind.
std::string map_file(std::string_view text) {
  text = trimmed(text);
  for (;;) {
    std::string_view rest = text;
    const MapOption* option = find_option(next_word(rest));
    if (option == nullptr) break;
    skip_option(*option, rest);
    text = trimmed(rest);
  }
  const char* const begin = text.data();
  std::size_t length = text.size();
  for (std::string_view rest = text; !rest.empty();) {
    const std::string_view word = next_word(rest);
    if (find_option(word) == nullptr) continue;
    length = static_cast<std::size_t>(word.data() - begin);
    break;
  }
  text = trimmed(text.substr(0, length));
  if (text.size() > 1 && text.front() == '"' && text.back() == '"') text = text.substr(1, text.size() - 2);
  return std::string(text);
}

// Reads the statements of one file.
class MtlReader {
 public:
  MtlReader(std::string_view file, std::vector<std::string>& problems) : file_(file), problems_(problems) {}

  void run(std::string_view text, std::map<std::string, MtlMaterial, std::less<>>& materials) {
    if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
    for (TextCursor cursor(text); !cursor.at_end();) {
      ++line_;
      std::string_view rest = trimmed(cursor.line());
      if (rest.empty() || rest.front() == '#') continue;
      const std::string keyword = lower(next_word(rest));
      if (keyword == "newmtl") {
        finish(materials);
        name_ = std::string(trimmed(rest));
      } else if (name_) {
        statement(keyword, rest);
      }
    }
    finish(materials);
    report();
  }

 private:
  void statement(const std::string& keyword, std::string_view rest) {
    Material& m = now_.material;
    if (keyword == "kd") {
      color(rest, m.color);
    } else if (keyword == "ks") {
      color(rest, m.specular);
    } else if (keyword == "ke") {
      color(rest, m.emission);
    } else if (keyword == "ns") {
      if (const auto n = number(rest)) m.shininess = std::clamp(*n, 1.0f, 1000.0f);
    } else if (keyword == "d") {
      std::string_view halo = rest;
      opacity_ = number(next_word(halo) == "-halo" ? halo : rest);
    } else if (keyword == "tr") {
      transparency_ = number(rest);
    } else if (keyword == "illum") {
      illumination_ = number(rest);
    } else if (keyword == "map_kd") {
      now_.color_map = map_file(rest);
    } else if (keyword == "norm" || keyword == "map_norm") {
      now_.normal_map = map_file(rest);
    } else if (keyword == "bump" || keyword == "map_bump") {
      bump_ = map_file(rest);
    } else if (!says_nothing(keyword)) {
      left_out_.insert(keyword);
    }
  }

  // Ka: the ambient reflectance of a Material is its diffuse one, and files set Ka to anything from 0 to 20.
  // Ni, Tf, Kt: refraction and coloured filters are no part of any lighting model here.
  static bool says_nothing(std::string_view keyword) {
    return keyword == "ka" || keyword == "ni" || keyword == "tf" || keyword == "kt" ||
           keyword == "sharpness" || keyword == "map_aat";
  }

  std::optional<float> number(std::string_view& rest) {
    const std::optional<float> n = next_number(rest);
    if (n && *n == *n) return n;
    if (bad_statements_++ == 0) first_bad_line_ = line_;
    return std::nullopt;
  }

  // MTL colours are what the program that wrote them showed on its display, so they are decoded from sRGB.
  // One number stands for all three. The forms `spectral` and `xyz` are not known to be written by anyone.
  void color(std::string_view rest, Vec3f& to) {
    const std::optional<float> r = number(rest);
    if (!r) return;
    const std::optional<float> g = next_number(rest), b = next_number(rest);
    to = {srgb_to_linear(*r), srgb_to_linear(g.value_or(*r)), srgb_to_linear(b.value_or(g.value_or(*r)))};
  }

  void finish(std::map<std::string, MtlMaterial, std::less<>>& materials) {
    if (!name_) return;
    Material& m = now_.material;
    // Of d and Tr, which programs write side by side and not always in agreement, d counts.
    m.opacity = std::clamp(opacity_ ? *opacity_ : 1 - transparency_.value_or(0.0f), 0.0f, 1.0f);
    if (m.opacity < 1) m.alpha_mode = AlphaMode::blend;
    // Illumination models 0 and 1 have no highlight.
    if (illumination_ && *illumination_ < 2) m.specular = {0, 0, 0};
    // A texture on black would stay black: what the file means is the texture by itself.
    if (!now_.color_map.empty() && m.color == Vec3f{0, 0, 0}) m.color = {1, 1, 1};
    if (now_.normal_map.empty()) now_.normal_map = std::move(bump_);
    materials.try_emplace(std::move(*name_), std::move(now_));
    now_ = {};
    bump_.clear();
    name_ = std::nullopt;
    opacity_ = transparency_ = illumination_ = std::nullopt;
  }

  void report() {
    if (bad_statements_ > 0) {
      problems_.push_back(in_quotes(file_) + ": left out " + std::to_string(bad_statements_) +
                          " statements without the numbers they need, the first in line " +
                          std::to_string(first_bad_line_));
    }
    if (left_out_.empty()) return;
    std::string list;
    std::size_t named = 0;
    for (const std::string& keyword : left_out_) {
      if (named++ == kMostNamed) break;
      list += (list.empty() ? "" : ", ") + in_quotes(keyword);
    }
    if (left_out_.size() > kMostNamed)
      list += " and " + std::to_string(left_out_.size() - kMostNamed) + " more";
    problems_.push_back(in_quotes(file_) + ": left out " + list + ", which no material here has");
  }

  std::string_view file_;
  std::vector<std::string>& problems_;
  long long line_ = 0;
  std::optional<std::string> name_;
  MtlMaterial now_;
  std::string bump_;
  std::optional<float> opacity_, transparency_, illumination_;
  long long bad_statements_ = 0, first_bad_line_ = 0;
  std::set<std::string> left_out_;
};

// Whether a name stays below the folder, as its letters go.
bool is_inside(const std::string& name) {
  if (name.starts_with('/') || (name.size() > 1 && name[1] == ':')) return false;
  for (const std::filesystem::path& part : std::filesystem::path(name)) {
    if (part == "..") return false;
  }
  return true;
}

bool is_file(const Source& source, const std::string& name) {
  std::error_code ignored;
  return is_inside(name) && std::filesystem::is_regular_file(source.folder / name, ignored);
}

// A backslash and a blank are a blank, any other backslash separates folders.
std::string without_escapes(std::string_view text) {
  std::string s;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool escape = text[i] == '\\' && i + 1 < text.size() && text[i + 1] == ' ';
    s += escape ? text[++i] : text[i] == '\\' ? '/' : text[i];
  }
  return s;
}

}  // namespace

std::vector<std::string> library_names(std::string_view statement) {
  std::vector<std::string> names, words;  // `words` may yet turn out to be one name
  const auto keep_words = [&] {
    names.insert(names.end(), words.begin(), words.end());
    words.clear();
  };
  for (statement = trimmed(statement); !statement.empty(); statement = trimmed(statement)) {
    if (statement.front() == '"') {
      keep_words();
      const std::size_t end = statement.find('"', 1);
      names.push_back(without_escapes(statement.substr(1, end == std::string_view::npos ? end : end - 1)));
      statement.remove_prefix(end == std::string_view::npos ? statement.size() : end + 1);
      continue;
    }
    std::size_t length = 0;
    while (length < statement.size() &&
           !(is_blank_or_end(statement[length]) && (length == 0 || statement[length - 1] != '\\'))) {
      ++length;
    }
    words.push_back(without_escapes(statement.substr(0, length)));
    statement.remove_prefix(length);
    if (!lower(words.back()).ends_with(".mtl")) continue;
    std::string name;
    for (const std::string& word : words) name += (name.empty() ? "" : " ") + word;
    names.push_back(std::move(name));
    words.clear();
  }
  keep_words();
  return names;
}

void MtlLibrary::load(const Source& source, std::string_view statement, std::vector<std::string>& problems) {
  const std::string whole = without_escapes(trimmed(statement));
  if (is_file(source, whole)) {
    load_file(source, whole, problems);
  } else {
    for (const std::string& name : library_names(statement)) load_file(source, name, problems);
  }
}

void MtlLibrary::load_file(const Source& source, const std::string& name,
                           std::vector<std::string>& problems) {
  const std::string key = std::filesystem::path(name).lexically_normal().string();
  if (files_.size() > kMostFiles || !files_.insert(key).second) return;
  if (files_.size() > kMostFiles) {
    problems.push_back("only the first " + std::to_string(kMostFiles) + " material files were looked for");
  } else if (!is_inside(name)) {
    problems.push_back("material file " + in_quotes(name) +
                       " was not read: it is outside the model's folder");
  } else if (source.folder.empty()) {
    problems.push_back("material file " + in_quotes(name) + " was not read: the model has no folder");
  } else if (!is_file(source, name)) {
    problems.push_back("material file " + in_quotes(name) + " was not found beside the model");
  } else {
    const Result<FileBytes> file =
        FileBytes::open((source.folder / name).string(), source.options.limits.max_memory);
    if (!file) {
      problems.push_back("material file " + in_quotes(name) + " " + file.error().message);
      return;
    }
    const std::span<const std::byte> bytes = file->bytes();
    read({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, name, problems);
  }
}

void MtlLibrary::read(std::string_view text, std::string_view file, std::vector<std::string>& problems) {
  MtlReader(file, problems).run(text, materials_);
}

const MtlMaterial* MtlLibrary::find(std::string_view name) const {
  const auto found = materials_.find(name);
  return found == materials_.end() ? nullptr : &found->second;
}

}  // namespace blysk::io
