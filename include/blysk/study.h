// blysk/study.h - the papers' experiments, measured again: tables, plots, and a verdict on every claim.
//
// Times are of the machine that measures and differ from run to run; everything else is the same everywhere.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "blysk/limits.h"
#include "blysk/result.h"

namespace blysk {

/// A number with the text that shows it, or only text.
struct StudyCell {
  std::string text;
  std::optional<double> value = {};
};

struct StudyTable {
  std::string title;
  std::vector<std::string> columns;
  std::vector<std::vector<StudyCell>> rows;  ///< each as long as `columns`
  std::string id = {};                       ///< short and stable: "4.3"; may be empty
  std::vector<std::string> notes = {};       ///< what to know of it, a sentence or two each
};

/// A picture of the report.
struct StudyPlot {
  std::string name;  ///< of its file: .svg or .png
  std::string title;
  std::string bytes;
};

enum class Verdict { holds, in_part, fails };
[[nodiscard]] std::string_view verdict_name(Verdict verdict);

/// One figure that was measured, and where: "plain program", "avx512, 100 pixels".
struct StudyMeasurement {
  std::string where;  ///< empty: the figure says it all
  StudyCell figure;
  bool witness = false;  ///< shown, but not judged by
};

/// What a paper says, and what was found.
struct StudyClaim {
  std::string claim;
  std::string scene;  ///< in which it was looked at; empty: the claim is about no scene
  StudyCell claimed;
  std::vector<StudyMeasurement> measured;
  Verdict verdict = Verdict::fails;
  std::string id = {};      ///< short and stable; may be empty
  std::string source = {};  ///< paper and place
  StudyCell modelled = {};  ///< by operation counts and the paper's processor; empty: nothing to model
  std::string why = {};     ///< one or two sentences
};

struct StudySection {
  std::string title;
  std::vector<std::string> paragraphs;
  std::vector<StudyTable> tables;
  std::vector<StudyPlot> plots;
};

struct StudyReport {
  std::string name;    ///< "abuffer"
  std::string title;   ///< one line
  std::string source;  ///< the papers
  std::vector<StudySection> sections = {};
  std::vector<StudyClaim> claims = {};
  std::string clock = {};  ///< processor clock and instruction set of the times; empty: there are no times
};

struct StudyOptions {
  int threads = 0;                       ///< 0: one per processor; times are of one thread always
  bool quick = false;                    ///< small pictures, few repetitions: to see that it works
  std::vector<std::string> scenes = {};  ///< names of the study's scenes; empty: all
  std::vector<std::string> models = {};  ///< files or shapes measured besides
  Limits limits = {};                    ///< for `models`
  std::function<void(std::string_view)> progress = {};  ///< told what is done next; may be empty
};

/// Names of the scenes that study_abuffer() knows, in its order.
[[nodiscard]] std::vector<std::string> abuffer_scenes();

/// O. Romaniuk, M. Kurinnyi et al.: the modified A-buffer, every policy for lists that are full, and its
/// memory.
[[nodiscard]] Result<StudyReport> study_abuffer(const StudyOptions& options = {});

/// The thesis on shading, the papers on Gouraud shading and on vectors: operations, errors, speed. `scenes`
/// are not for it; of `models` errors and frames are measured.
[[nodiscard]] Result<StudyReport> study_shading(const StudyOptions& options = {});

struct Study {
  std::string_view name;  ///< as given to --study
  std::string_view help;
  Result<StudyReport> (*run)(const StudyOptions&);
  bool has_scenes;  ///< StudyOptions::scenes and models are for it
};

/// All studies there are.
[[nodiscard]] std::span<const Study> studies();

}  // namespace blysk
