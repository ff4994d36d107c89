// study/timing.h - times of things that are to be compared.
#pragma once

#include <functional>
#include <span>
#include <vector>

namespace blysk::study {

struct Timing {
  double ns = 0;    ///< of one run: the best of the rounds
  double gain = 1;  ///< how many times as fast as the first of them
};

struct Rounds {
  int most = 25;
  double least_ms = 0.15;  ///< of one sample; short runs are repeated until then
};

/// Other programs only ever add time, so the best sample says most; it is believed when it comes again:
/// three samples within 1 % of it, itself among them.
[[nodiscard]] bool settled(std::span<const double> samples);

/// Runs all of them in turn, round after round, so that what disturbs the machine disturbs all: until every
/// one is settled, or as often as `rounds` says.
[[nodiscard]] std::vector<Timing> time_in_turn(std::span<const std::function<void()>> runs,
                                               const Rounds& rounds);

}  // namespace blysk::study
