#include "study/clock.h"

#include <algorithm>
#include <chrono>
#include <cstdint>

namespace blysk::study {
namespace {

// Short enough that some loops run without being interrupted on a busy machine.
constexpr int kLoops = 300;
constexpr int kRounds = 1 << 17, kAdditions = 16;

double measure() {
  using Clock = std::chrono::steady_clock;
  double best = 0;
  std::uint64_t sum = 1, step = 3;
  for (int loop = 0; loop < kLoops; ++loop) {
    const Clock::time_point start = Clock::now();
    for (int i = 0; i < kRounds; ++i) {
      for (int k = 0; k < kAdditions; ++k) {
        // Both are hidden from the compiler, and no processor knows `step` before it adds.
        sum += step;
        asm volatile("" : "+r"(sum), "+r"(step));
      }
    }
    const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
    best = std::max(best, double{kRounds} * kAdditions / seconds);
  }
  return best;
}

}  // namespace

double clock_hz() {
  static const double hz = measure();
  return hz;
}

}  // namespace blysk::study
