// comparison.h - what `blysk compare` finds, and the two ways to a comparison: pictures and methods.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "arguments.h"
#include "blysk/image.h"
#include "blysk/metrics.h"

namespace blysk::command {

/// One picture and, for a candidate, how far it is from the reference.
struct Compared {
  std::string name;   ///< path, or method
  std::string title;  ///< of a method
  Image image;        ///< a candidate's is empty again unless a report wants it
  int width = 0, height = 0;
  std::string hash;                      ///< sha256() of the picture
  double frame_ms = 0;                   ///< of a method
  std::optional<Difference> difference;  ///< none: the sizes differ
  double similarity = 0;
  bool equal = false;
  std::string map_path;  ///< of the error map written; empty: none
};

struct Comparison {
  Compared reference;
  std::vector<Compared> candidates;
  std::string models;   ///< in words; empty: pictures are compared
  std::string setting;  ///< of the renderer, in words

  [[nodiscard]] bool of_methods() const { return !models.empty(); }
};

/// Takes the candidates one by one: measures, judges by the options, and writes error maps.
class Judge {
 public:
  Judge(const Arguments& arguments, Compared reference);

  /// `id` tells the candidate's error map from the others'; empty: there is but one candidate.
  [[nodiscard]] Status take(Compared candidate, const std::string& id);
  [[nodiscard]] Comparison& comparison() { return comparison_; }

 private:
  [[nodiscard]] bool is_equal(const Difference& difference) const;
  [[nodiscard]] Status write_map(Compared& candidate, const std::string& id) const;

  const Arguments& arguments_;
  Comparison comparison_;
};

[[nodiscard]] Compared compared(std::string name, Image image);

[[nodiscard]] Result<Comparison> compare_pictures(const Arguments& arguments);
[[nodiscard]] Result<Comparison> compare_methods(const Arguments& arguments);

/// The table as rows of cells, a heading first.
[[nodiscard]] std::vector<std::vector<std::string>> comparison_rows(const Comparison& comparison);
/// One HTML page with everything in it.
[[nodiscard]] Result<std::string> comparison_page(const Comparison& comparison);

}  // namespace blysk::command
