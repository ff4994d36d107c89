// blysk/study.h - the papers' tables and claims, measured again.
//
// A study runs methods, counts their operations, times them, and says which claims hold. Times are of this
// machine and differ from run to run; everything else is the same everywhere.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "blysk/result.h"

namespace blysk {

/// A number with the text that shows it, or text alone.
struct StudyCell {
  std::string text;
  std::optional<double> value;
};

struct StudyTable {
  std::string id;     ///< short and stable: "4.3"
  std::string title;  ///< one line
  std::vector<std::string> columns;
  std::vector<std::vector<StudyCell>> rows;
  std::vector<std::string> notes;  ///< sentences that stand below it
};

enum class Verdict { holds, in_part, fails };
[[nodiscard]] std::string_view verdict_name(Verdict verdict);

/// One figure that was measured, and where: "plain", "scalar, 100 pixels".
struct StudyMeasurement {
  std::string where;
  StudyCell figure;
  bool witness = false;  ///< shown, but not judged by
};

struct StudyClaim {
  std::string id;      ///< short and stable
  std::string text;    ///< what is claimed, in words
  std::string source;  ///< paper and place
  StudyCell claimed, modelled;
  std::vector<StudyMeasurement> measured;
  Verdict verdict = Verdict::fails;
  std::string why;  ///< one or two sentences
};

struct StudyPoint {
  std::string label;
  double x = 0, y = 0;
};

/// Points in a plane. Points that lie under `y_floor` are drawn on it.
struct StudyPlot {
  std::string id, title, x_label, y_label;
  double y_floor = 0;
  std::vector<StudyPoint> points;
};

/// A picture of the plot on logarithmic axes, as a file of SVG.
[[nodiscard]] std::string plot_svg(const StudyPlot& plot);

struct StudyReport {
  std::string name, title;
  std::vector<std::string> introduction;  ///< paragraphs
  std::vector<StudyTable> tables;
  std::vector<StudyClaim> claims;
  std::vector<StudyPlot> plots;
  double clock_ghz = 0;         ///< of the processor, as measured
  std::string instruction_set;  ///< that "SIMD" stands for
};

struct StudyOptions {
  bool quick = false;                              ///< small frames and few repetitions: to see that it works
  std::function<void(std::string_view)> progress;  ///< told what goes on; may be empty
};

struct Study {
  std::string_view name;   ///< as given to --study
  std::string_view title;  ///< what it is about
  Result<StudyReport> (*run)(const StudyOptions&);
};

/// All studies there are.
[[nodiscard]] std::span<const Study> studies();

}  // namespace blysk
