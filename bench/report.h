// bench/report.h - units of the kernel benchmarks: items a second, and cycles an item on the measured clock.
#pragma once

#include <benchmark/benchmark.h>

#include <cstdint>
#include <string>

#include "blysk/render.h"
#include "study/clock.h"

namespace blysk::bench {

/// `items` is what one iteration does; `unit` names one of them ("triangle"). The benchmark must run on one
/// thread.
inline void report(benchmark::State& state, double items, const std::string& unit) {
  using benchmark::Counter;
  state.SetItemsProcessed(static_cast<std::int64_t>(static_cast<double>(state.iterations()) * items));
  state.counters["cycles/" + unit] =
      Counter(items / study::clock_hz(), Counter::kIsIterationInvariantRate | Counter::kInvert);
  state.counters["GHz"] = study::clock_hz() * 1e-9;
}

/// The instruction set that argument 0 counts, named in the label.
inline Isa isa_argument(benchmark::State& state) {
  const Isa isa = available_isas()[static_cast<std::size_t>(state.range(0))];
  state.SetLabel(std::string(isa_name(isa)));
  return isa;
}

/// Last of available_isas(), as argument 0.
inline std::int64_t best_isa() { return static_cast<std::int64_t>(available_isas().size()) - 1; }

}  // namespace blysk::bench
