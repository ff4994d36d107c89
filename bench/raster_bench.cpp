// Triangles into bins, and bins into visible pixels: one layer of equal right triangles over 1920x1080
// pixels.
#include "report.h"
#include "scenes.h"
#include "study/pipeline.h"

namespace blysk::bench {
namespace {

constexpr int kWidth = 1920, kHeight = 1080;

// Argument 1: area in hundredths of a pixel; 0: two triangles over everything. Argument 2: layers, from the
// farthest to the nearest if negative.
Stage layers(const benchmark::State& state) {
  const std::int64_t area = state.range(1), count = state.range(2);
  const std::string hundredths = std::to_string(100 + area % 100).substr(1);
  const std::string name = "tris:" + std::to_string(area / 100) + "." + hundredths + ":" +
                           std::to_string(std::abs(count)) + (count < 0 ? ":b2f" : "");
  return *make_stage(area == 0 ? "quad" : name, kWidth, kHeight);
}

void assemble(benchmark::State& state) {
  const Stage stage = layers(state);
  study::Pipeline pipeline(stage.scene, aimed_options(stage, kWidth, kHeight), isa_argument(state));
  for (auto _ : state) pipeline.assemble();
  report(state, static_cast<double>(pipeline.triangles()), "triangle");
  state.counters["bin_bytes"] = static_cast<double>(pipeline.bytes());
}

void rasterize(benchmark::State& state) {
  const Stage stage = layers(state);
  study::Pipeline pipeline(stage.scene, aimed_options(stage, kWidth, kHeight), isa_argument(state));
  for (auto _ : state) benchmark::DoNotOptimize(pipeline.rasterize());
  report(state, static_cast<double>(pipeline.triangles()), "triangle");
  state.counters["pixels/s"] =
      benchmark::Counter(double{kWidth} * kHeight, benchmark::Counter::kIsIterationInvariantRate);
}

void scenes(benchmark::internal::Benchmark* b) {
  b->ArgNames({"isa", "area/100", "layers"})->Unit(benchmark::kMillisecond);
  for (std::int64_t isa = 0; isa < best_isa(); ++isa) b->Args({isa, 400, 1});
  for (const int area : {25, 100, 400, 1600, 10000, 100000}) b->Args({best_isa(), area, 1});
  b->Args({best_isa(), 10000, 10})->Args({best_isa(), 10000, -10});
}

BENCHMARK(assemble)->Apply(scenes);
BENCHMARK(rasterize)->Apply(scenes)->Args({best_isa(), 0, 1});

}  // namespace
}  // namespace blysk::bench
