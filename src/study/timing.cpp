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

double median(std::vector<double> values) {
  const auto middle = values.begin() + std::ssize(values) / 2;
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

std::vector<Timing> time_in_turn(std::span<const std::function<void()>> runs, const Rounds& rounds) {
  std::vector<int> repeat;
  for (const auto& run : runs) {
    run();  // fills caches
    const double once = sample_ns(run, 1);
    repeat.push_back(std::clamp(static_cast<int>(rounds.least_ms * 1e6 / once) + 1, 1, 100000));
  }
  std::vector<std::vector<double>> ns(runs.size()), gain(runs.size());
  for (int round = 0; round < rounds.count; ++round) {
    double first = 0;
    for (std::size_t i = 0; i < runs.size(); ++i) {
      const double t = sample_ns(runs[i], repeat[i]);
      if (i == 0) first = t;
      ns[i].push_back(t);
      gain[i].push_back(first / t);
    }
  }
  std::vector<Timing> timings;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    timings.push_back({median(std::move(ns[i])), median(std::move(gain[i]))});
  }
  return timings;
}

}  // namespace blysk::study
