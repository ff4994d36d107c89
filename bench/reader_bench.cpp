// A file in memory to a scene with normals: a bumpy sphere of a million triangles in each format.
#include <benchmark/benchmark.h>

#include <string>

#include "blysk/model.h"
#include "model_files.h"
#include "scenes.h"

namespace blysk::bench {
namespace {

// crease 0 leaves the mesh without normals: reading alone (STL still joins equal corners).
void read(benchmark::State& state, const char* format) {
  const Stage stage = *make_stage("sphere:1e6", 1, 1);
  const std::vector<std::byte> file = model_file(stage.scene.meshes[0], format);
  const ModelOptions options{.crease_deg = static_cast<double>(state.range(1)),
                             .threads = static_cast<int>(state.range(0)),
                             .limits = {}};
  const std::string name = std::string("sphere.") + format;
  std::uint64_t triangles = 0;
  for (auto _ : state) {
    const Result<Scene> scene = load_model(file, name, {}, options);
    if (!scene) {
      state.SkipWithError(scene.error().text().c_str());
      return;
    }
    triangles = scene->triangles();
  }
  state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations()) *
                          static_cast<std::int64_t>(file.size()));
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()) *
                          static_cast<std::int64_t>(triangles));
}

void settings(benchmark::internal::Benchmark* b) {
  b->ArgNames({"threads", "crease"})->Unit(benchmark::kMillisecond)->UseRealTime();
  b->Args({1, 0})->Args({2, 0})->Args({2, 60});
}

BENCHMARK_CAPTURE(read, obj, "obj")->Apply(settings);
BENCHMARK_CAPTURE(read, stl, "stl")->Apply(settings);
BENCHMARK_CAPTURE(read, stl_shuffled, "shuffled.stl")->Apply(settings);
BENCHMARK_CAPTURE(read, stl_apart, "apart.stl")->Apply(settings);
BENCHMARK_CAPTURE(read, ply, "ply")->Apply(settings);
BENCHMARK_CAPTURE(read, ply_colors, "colors.ply")->Apply(settings);
BENCHMARK_CAPTURE(read, glb, "glb")->Apply(settings);

}  // namespace
}  // namespace blysk::bench
