#include "study/timing.h"

#include <algorithm>
#include <chrono>

namespace blysk::study {
namespace {

double sample_ns(const std::function<void()>& run, int repeat) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  for (int i = 0; i < repeat; ++i) run();
  return std::chrono::duration<double, std::nano>(Clock::now() - start).count() / repeat;
}

}  // namespace

bool settled(std::span<const double> samples) {
  constexpr double kMet = 1.01;
  constexpr std::ptrdiff_t kMeetings = 3;
  if (samples.empty()) return false;
  const double near = *std::ranges::min_element(samples) * kMet;
  return std::ranges::count_if(samples, [&](double sample) { return sample <= near; }) >= kMeetings;
}

std::vector<Timing> time_in_turn(std::span<const std::function<void()>> runs, const Rounds& rounds) {
  std::vector<int> repeat;
  std::vector<std::vector<double>> samples;
  for (const auto& run : runs) {
    run();  // fills caches
    const double once = sample_ns(run, 1);
    repeat.push_back(std::clamp(static_cast<int>(rounds.least_ms * 1e6 / once) + 1, 1, 100000));
    samples.push_back({once});
  }
  // All go on until all are settled: else some would have had quieter rounds than others.
  for (int round = 1; round < rounds.most && !std::ranges::all_of(samples, settled); ++round) {
    for (std::size_t i = 0; i < runs.size(); ++i) samples[i].push_back(sample_ns(runs[i], repeat[i]));
  }
  std::vector<Timing> timings;
  for (const std::vector<double>& of_run : samples) {
    const double best = *std::ranges::min_element(of_run);
    timings.push_back({best, timings.empty() ? 1 : timings[0].ns / best});
  }
  return timings;
}

}  // namespace blysk::study
