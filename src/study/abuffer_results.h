// study/abuffer_results.h - everything that is measured in one scene, and how the report tells it.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "blysk/study.h"
#include "study/abuffer_scenes.h"
#include "study/abuffer_turning.h"

namespace blysk::study {

inline constexpr std::size_t kMostFragments = 8;  ///< N of the tables: 1 to this

/// All that have a limit.
inline constexpr antialias::Overflow kPolicies[] = {
    antialias::Overflow::d1, antialias::Overflow::d2, antialias::Overflow::d3, antialias::Overflow::d4,
    antialias::Overflow::d5, antialias::Overflow::m0, antialias::Overflow::m1, antialias::Overflow::m2,
    antialias::Overflow::m3, antialias::Overflow::m4, antialias::Overflow::m5};

struct OrderResult {
  std::string name;
  std::vector<Quality> quality;  ///< of kExpectedPolicies, N = 3
};

struct SceneResult {
  std::string name;
  const Expected* expected = nullptr;  ///< null: nothing is known beforehand
  int width = 0, height = 0;
  std::uint64_t triangles_in = 0, triangles = 0;
  Complexity complexity = {};
  std::vector<std::uint32_t> live = {};  ///< fragments of each pixel
  Quality zbuffer = {}, carpenter = {};
  std::vector<Quality> quality = {};     ///< by policy of kPolicies, then N; random order, seed 1
  std::vector<OrderResult> orders = {};  ///< the others
  std::vector<MemoryRow> memory = {};    ///< empty: not measured

  [[nodiscard]] const Quality& at(antialias::Overflow policy, std::size_t most) const;
  /// The least N whose NMSE is not above the wanted one, if one of the tables' is.
  [[nodiscard]] std::optional<std::size_t> least(antialias::Overflow policy, double nmse) const;
};

[[nodiscard]] SceneResult measure_all(const StudyScene& scene, const SceneRow* row, ThreadPool& threads);

[[nodiscard]] std::vector<StudySection> abuffer_sections(const std::vector<SceneResult>& scenes,
                                                         const std::vector<TurningResult>& turning);
[[nodiscard]] std::vector<StudyClaim> abuffer_claims(const SceneResult& scene);

}  // namespace blysk::study
