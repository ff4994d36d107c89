// study/abuffer_scenes.h - what the variants of the A-buffer are measured in, and what to expect there.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>

#include "blysk/limits.h"
#include "blysk/result.h"
#include "study/abuffer_measure.h"

namespace blysk::study {

/// NMSE of seven policies for N = 3 that an earlier simulation found in scenes made by the same rules from
/// other random numbers, and what it counted there. Zero where it has no figures.
struct Expected {
  double generated = 0, live = 0, zbuffer = 0;  ///< fragments a pixel, and NMSE
  std::array<double, 7> policies{};             ///< kExpectedPolicies
  std::array<double, 9> ratios{};               ///< of memory, in the order of measure_memory()
  double factor = 4;                            ///< how far seeds spread
};
inline constexpr antialias::Overflow kExpectedPolicies[] = {
    antialias::Overflow::d1, antialias::Overflow::d4, antialias::Overflow::d5, antialias::Overflow::m0,
    antialias::Overflow::m1, antialias::Overflow::m3, antialias::Overflow::m5};

struct SceneRow {
  std::string_view name;
  std::string_view shape;  ///< as blysk render takes it
  int width = 128, height = 128;
  bool common_memory = true;
  Expected expected = {};
};
[[nodiscard]] std::span<const SceneRow> scene_rows();

[[nodiscard]] Result<StudyScene> make_scene(const SceneRow& row);
/// Of a file or a shape, in 640x480.
[[nodiscard]] Result<StudyScene> model_scene(const std::string& model, const Limits& limits);

}  // namespace blysk::study
