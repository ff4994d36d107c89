#include "study/timing.h"

#include <algorithm>
#include <chrono>
#include <limits>

namespace blysk::study {
namespace {

double sample_ns(const std::function<void()>& run, int repeat) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  for (int i = 0; i < repeat; ++i) run();
  return std::chrono::duration<double, std::nano>(Clock::now() - start).count() / repeat;
}

}  // namespace

std::vector<Timing> time_in_turn(std::span<const std::function<void()>> runs, const Rounds& rounds) {
  std::vector<int> repeat;
  for (const auto& run : runs) {
    run();  // fills caches
    const double once = sample_ns(run, 1);
    repeat.push_back(std::clamp(static_cast<int>(rounds.least_ms * 1e6 / once) + 1, 1, 100000));
  }
  std::vector<Timing> timings(runs.size(), {std::numeric_limits<double>::infinity(), 1});
  for (int round = 0; round < rounds.count; ++round) {
    for (std::size_t i = 0; i < runs.size(); ++i) {
      timings[i].ns = std::min(timings[i].ns, sample_ns(runs[i], repeat[i]));
    }
  }
  for (Timing& t : timings) t.gain = timings[0].ns / t.ns;
  return timings;
}

}  // namespace blysk::study
