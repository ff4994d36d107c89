// study/abuffer_turning.h - a model that turns before the viewer: errors that flicker.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "antialias/overflow.h"
#include "blysk/result.h"
#include "core/threads.h"

namespace blysk::study {

struct TurningRow {
  antialias::Overflow policy;
  double mean = 0, worst = 0;  ///< NMSE of the frames
  double flicker = 0;          ///< mean NMSE of a frame against the one before, less that of unlimited lists
};

struct TurningResult {
  std::string name;
  int frames = 0;
  double moving = 0;  ///< mean NMSE of a frame against the one before, unlimited lists
  std::vector<TurningRow> rows;
};

inline constexpr int kTurningWidth = 320, kTurningHeight = 240;

/// Twelve frames, a degree each, every policy of kExpectedPolicies with N = 3, triangles in random order.
[[nodiscard]] Result<TurningResult> measure_turning(std::string_view shape, ThreadPool& threads);

}  // namespace blysk::study
