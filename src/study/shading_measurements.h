// study/shading_measurements.h - everything that the study of shading measures, before it is told.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "blysk/study.h"
#include "study/operations.h"
#include "study/picture_errors.h"
#include "study/speed.h"

namespace blysk::study {

/// One scene of the speed table: cycles per pixel and gains over phong, by method.
struct SpeedColumn {
  std::string scene;
  ShadingCost best, scalar;  ///< scalar is empty where it was not built, or not asked for
};

/// Lobes on spans of so many pixels. The power of a whole shininess is products, of any other polynomials.
struct LobeColumn {
  int span;
  float shininess;
  ShadingCost cost;
};

/// "span 64, n = 50".
[[nodiscard]] std::string lobe_place(const LobeColumn& column);

struct ErrorColumn {
  std::string scene;
  PictureErrors errors;
};

struct ShadingMeasurements {
  std::vector<std::string> methods;   ///< of the registry, phong first
  std::vector<std::string> variants;  ///< with every setting of theirs, phong first
  std::vector<std::string> lobes;     ///< power first

  std::map<std::string, StepCounts, std::less<>> counts;  ///< by walk
  WalkCost walks;                                         ///< in the order of walks()
  std::vector<SpeedColumn> speeds;                        ///< of methods
  std::vector<double> rows;                               ///< cycles per pixel by QuadraticForm
  std::vector<double> normalisations;                     ///< cycles by Normalisation
  std::vector<double> plain_lobes;                        ///< cycles by CountedLobe
  std::vector<LobeColumn> lobe_speeds;                    ///< span 64, shininess 50 first
  ShadingCost variant_speeds;                             ///< on spans of 64 pixels
  ShadingCost small_speeds;                               ///< of variants on triangles of 100 pixels
  ShadingCost diffuse_speeds;                             ///< the same with Lambert's light
  std::vector<ErrorColumn> errors;                        ///< of variants, frames timed
  ErrorColumn lobe_errors;                                ///< of lobes
  double clock_ghz = 0;
  std::string best;  ///< instruction set

  [[nodiscard]] std::optional<std::size_t> method(std::string_view name) const;
  [[nodiscard]] std::optional<std::size_t> variant(std::string_view name) const;
  [[nodiscard]] const SpeedColumn& speed(std::string_view scene) const;  ///< must exist
  /// Clocks of the Pentium with one cost of divisions for the average triangle.
  [[nodiscard]] std::uint64_t clocks(std::string_view walk) const;
  /// How many times as fast as `from` the walk `to` is here.
  [[nodiscard]] double walk_gain(std::string_view from, std::string_view to) const;
  /// How many times as fast as the exact power a lobe is.
  [[nodiscard]] double lobe_gain(const LobeColumn& column, std::string_view lobe) const;
  /// Largest NMSE of a variant over the scenes.
  [[nodiscard]] double worst_nmse(std::size_t variant) const;
};

[[nodiscard]] Result<ShadingMeasurements> measure_shading(const StudyOptions& options);

}  // namespace blysk::study
