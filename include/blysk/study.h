// blysk/study.h - the papers' experiments, measured again: tables, plots, and a verdict on every claim.
#pragma once

#include <functional>
#include <optional>
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
};

/// A picture of the report.
struct StudyPlot {
  std::string name;  ///< of its file: .svg or .png
  std::string title;
  std::string bytes;
};

enum class Verdict { confirmed, partly, refuted };
[[nodiscard]] std::string_view verdict_name(Verdict verdict);

/// What a paper says, and what was found in one scene.
struct StudyClaim {
  std::string claim, scene, claimed, measured;
  Verdict verdict = Verdict::refuted;
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
  std::string source;  ///< the paper
  std::vector<StudySection> sections = {};
  std::vector<StudyClaim> claims = {};
};

struct StudyOptions {
  int threads = 0;                       ///< 0: one per processor; the report does not depend on it
  std::vector<std::string> scenes = {};  ///< names of the study's scenes; empty: all
  std::vector<std::string> models = {};  ///< files or shapes measured besides
  Limits limits = {};                    ///< for `models`
  std::function<void(std::string_view)> progress = {};  ///< told what is measured next; may be empty
};

/// Names of the scenes that study_abuffer() knows, in its order.
[[nodiscard]] std::vector<std::string> abuffer_scenes();

/// O. Romaniuk, M. Kurinnyi et al.: the modified A-buffer, every policy for lists that are full, and its
/// memory.
[[nodiscard]] Result<StudyReport> study_abuffer(const StudyOptions& options = {});

}  // namespace blysk
