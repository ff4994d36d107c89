// io/mtl.h - materials of OBJ files.
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "blysk/scene.h"
#include "io/reader.h"

namespace blysk::io {

struct MtlMaterial {
  Material material;
  std::string color_map;   ///< file of map_Kd as the MTL file spells it; empty: none
  std::string normal_map;  ///< of norm, else of a bump map; likewise
};

/// The materials of any number of MTL files by name; the first of a name counts.
class MtlLibrary {
 public:
  /// Reads what a `mtllib` statement names, from the folder of `source` and nowhere else. Files that cannot
  /// be had and statements that are left out become `problems`.
  void load(const Source& source, std::string_view statement, std::vector<std::string>& problems);
  /// Reads the text of one file, called `file` in problems.
  void read(std::string_view text, std::string_view file, std::vector<std::string>& problems);

  [[nodiscard]] const MtlMaterial* find(std::string_view name) const;

 private:
  void load_file(const Source& source, const std::string& name, std::vector<std::string>& problems);

  std::map<std::string, MtlMaterial, std::less<>> materials_;
  std::set<std::string> files_;  // asked for so far
};

/// The file names of a `mtllib` statement: words that end in .mtl and may hold blanks, quoted or with a
/// backslash before each blank or as they are. Other backslashes become slashes.
[[nodiscard]] std::vector<std::string> library_names(std::string_view statement);

}  // namespace blysk::io
