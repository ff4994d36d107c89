// Visible pixels to colours: 256x256 pixels, whose sixteen tiles stay in a second-level cache, under one
// layer of equal right triangles.
#include "report.h"
#include "scenes.h"
#include "study/pipeline.h"

namespace blysk::bench {
namespace {

constexpr int kSide = 256;

// Argument 1: pixels a triangle; 0: two triangles over everything.
void shade(benchmark::State& state, const char* method) {
  const std::int64_t area = state.range(1);
  const Stage stage = *make_stage(area == 0 ? "quad" : "tris:" + std::to_string(area) + ":1", kSide, kSide);
  study::Pipeline pipeline(stage.scene, aimed_options(stage, kSide, kSide), isa_argument(state));
  const MethodChoice choice = *choose_method(MethodKind::shading, method);
  pipeline.keep_tiles();
  for (auto _ : state) pipeline.shade(choice);
  report(state, double{kSide} * kSide, "pixel");
}

void scenes(benchmark::internal::Benchmark* b) {
  b->ArgNames({"isa", "area"})->Unit(benchmark::kMicrosecond);
  for (std::int64_t isa = 0; isa < best_isa(); ++isa) b->Args({isa, 0});
  for (const int area : {1, 4, 16, 100, 1000, 0}) b->Args({best_isa(), area});
}

BENCHMARK_CAPTURE(shade, phong, "phong")->Apply(scenes);
BENCHMARK_CAPTURE(shade, gouraud, "gouraud")->Apply(scenes);
BENCHMARK_CAPTURE(shade, flat, "flat")->Apply(scenes);
BENCHMARK_CAPTURE(shade, gouraud_constant, "gouraud-constant")->Apply(scenes);
BENCHMARK_CAPTURE(shade, quadratic, "quadratic")->Apply(scenes);
BENCHMARK_CAPTURE(shade, cubic, "cubic")->Apply(scenes);

}  // namespace
}  // namespace blysk::bench
