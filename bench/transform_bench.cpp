// Positions to screen vertices. 12 bytes are read and 16 written a vertex; memory moves 44, as a line that is
// written is fetched first.
#include <vector>

#include "render/kernels.h"
#include "report.h"

namespace blysk::bench {
namespace {

constexpr Projection kProjection = {
    {{1e5f, 0, -3e4f, 2e5f}, {0, -1e5f, -2e4f, 1e5f}, {0, 0, 0.3f, 0.5f}, {0, 0, -0.25f, 1}}};

void transform(benchmark::State& state) {
  const Kernels& table = kernels(isa_argument(state));
  const auto count = static_cast<std::size_t>(state.range(1));
  std::vector<Vec3f> positions(count);
  std::vector<ScreenVertex> out(count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto part = static_cast<float>(i % 1000) * 1e-3f;
    positions[i] = {part, 1 - part, part * part};
  }
  for (auto _ : state) {
    table.transform({positions.data(), count, kProjection, out.data()});
    benchmark::ClobberMemory();
  }
  report(state, static_cast<double>(count), "vertex");
  state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations()) * static_cast<std::int64_t>(count) *
                          static_cast<std::int64_t>(sizeof(Vec3f) + sizeof(ScreenVertex)));
}

// 16384 vertices are a frame's chunk and fit the second-level cache, 4 million fit none.
BENCHMARK(transform)->Apply([](benchmark::internal::Benchmark* b) {
  b->ArgNames({"isa", "vertices"})->Unit(benchmark::kMicrosecond);
  for (std::int64_t isa = 0; isa <= best_isa(); ++isa) b->Args({isa, 16384});
  b->Args({best_isa(), 4 << 20});
});

}  // namespace
}  // namespace blysk::bench
