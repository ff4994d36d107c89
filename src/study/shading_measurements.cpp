#include "study/shading_measurements.h"

#include <algorithm>
#include <functional>

#include "blysk/methods.h"
#include "study/cells.h"
#include "study/clock.h"
#include "study/cost_model.h"

namespace blysk::study {
namespace {

constexpr int kTriangleSizes[] = {1, 4, 16, 100};
constexpr int kSpans[] = {4, 8, 16, 32, 64, 128, 256};
constexpr int kDetails[] = {10, 25, 50, 100}, kThesisDetail = 50;
struct LobeRun {
  int span;
  float shininess;
};
constexpr LobeRun kLobeRuns[] = {{64, 50}, {256, 50}, {256, 255}, {256, 50.5f}};
struct Sizes {
  int side, span_width, span_height;  // of the pictures with triangles, and with spans
};
// Without SIMD a picture takes many times as long: parts of it say the same.
constexpr Sizes kSizes = {256, 512, 64}, kScalarSizes = {128, 512, 32}, kQuickSizes = {64, 256, 64};

std::optional<std::size_t> index_of(const std::vector<std::string>& names, std::string_view name) {
  const auto found = std::ranges::find(names, name);
  if (found == names.end()) return std::nullopt;
  return static_cast<std::size_t>(found - names.begin());
}

bool have(Isa isa) {
  const std::vector<Isa> isas = available_isas();
  return std::ranges::find(isas, isa) != isas.end();
}

void list_methods(ShadingMeasurements& m) {
  for (const Method& row : methods()) {
    if (row.kind == MethodKind::lobe) m.lobes.emplace_back(row.name);
    if (row.kind != MethodKind::shading) continue;
    m.methods.emplace_back(row.name);
    for (std::string& variant : method_variants(row)) m.variants.push_back(std::move(variant));
  }
}

std::vector<SpeedScene> speed_scenes(const Sizes& sizes, bool quick) {
  std::vector<SpeedScene> scenes;
  for (const int pixels : kTriangleSizes) scenes.push_back(triangles_of(pixels, sizes.side));
  for (const int pixels : kSpans) {
    if (quick && pixels != 64) continue;
    scenes.push_back(spans_of(pixels, sizes.span_width, sizes.span_height));
  }
  return scenes;
}

using Tell = std::function<void(const std::string& what)>;

void measure_speeds(bool quick, const Rounds& rounds, const Tell& tell, ShadingMeasurements& m) {
  const Rounds few = quick ? Rounds{1, 0.0} : Rounds{5, 0.0};
  const Sizes &sizes = quick ? kQuickSizes : kSizes, &scalar_sizes = quick ? kQuickSizes : kScalarSizes;
  const std::vector<SpeedScene> scenes = speed_scenes(sizes, quick),
                                of_scalar = speed_scenes(scalar_sizes, quick);
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    tell("timing shading, " + scenes[i].name);
    SpeedColumn column{scenes[i].name, shading_cost(scenes[i], m.methods, Isa::best, rounds), {}};
    if (have(Isa::scalar)) column.scalar = shading_cost(of_scalar[i], m.methods, Isa::scalar, few);
    m.speeds.push_back(std::move(column));
  }
  tell("timing settings and lobes");
  m.rows = row_cost(rounds);
  m.normalisations = normalisation_cost(rounds);
  m.plain_lobes = plain_lobe_cost(rounds);
  const auto scene_of = [&](std::string_view name) {
    return *std::ranges::find(scenes, name, &SpeedScene::name);
  };
  m.variant_speeds = shading_cost(scene_of("span 64"), m.variants, Isa::best, rounds);
  SpeedScene matt = scene_of("100 pixels");
  matt.options.lighting = "lambert";
  m.diffuse_speeds = shading_cost(matt, m.variants, Isa::best, rounds);
  m.small_speeds = shading_cost(scene_of("100 pixels"), m.variants, Isa::best, rounds);
  for (const LobeRun& run : kLobeRuns) {
    m.lobe_speeds.push_back(
        {run.span, run.shininess,
         lobe_cost(spans_of(run.span, sizes.span_width, sizes.span_height), run.shininess, m.lobes, rounds)});
  }
}

Status add_errors(const Result<PictureScene>& scene, const Rounds& rounds, const Tell& tell,
                  ShadingMeasurements& m) {
  if (!scene) return scene.error();
  tell("comparing pictures, " + scene->name);
  Result<PictureErrors> errors = picture_errors(*scene, MethodKind::shading, m.variants, rounds);
  if (!errors) return errors.error();
  m.errors.push_back({scene->name, std::move(*errors)});
  return Done{};
}

Status measure_pictures(const StudyOptions& options, const std::vector<PictureScene>& models,
                        const Tell& tell, ShadingMeasurements& m) {
  const Rounds frames = options.quick ? Rounds{1, 0.0} : Rounds{25, 0.0}, untimed = {0, 0.0};
  for (const int detail : kDetails) {
    const Result<PictureScene> scene = thesis_spheres(detail, options.quick);
    const bool thesis = detail == kThesisDetail;
    if (const Status s = add_errors(scene, thesis ? frames : untimed, tell, m); !s) return s;
    if (!thesis) continue;
    Result<PictureErrors> of_lobes = picture_errors(*scene, MethodKind::lobe, m.lobes, untimed);
    if (!of_lobes) return of_lobes.error();
    m.lobe_errors = {scene->name, std::move(*of_lobes)};
  }
  if (const Status s = add_errors(teapot(options.quick), frames, tell, m); !s) return s;
  const Rounds fewer = options.quick ? frames : Rounds{5, 0.0};
  for (const PictureScene& model : models) {
    if (const Status s = add_errors(model, fewer, tell, m); !s) return s;
  }
  return Done{};
}

}  // namespace

std::optional<std::size_t> ShadingMeasurements::method(std::string_view name) const {
  return index_of(methods, name);
}
std::optional<std::size_t> ShadingMeasurements::variant(std::string_view name) const {
  return index_of(variants, name);
}

const SpeedColumn& ShadingMeasurements::speed(std::string_view scene) const {
  return *std::ranges::find(speeds, scene, &SpeedColumn::scene);
}

std::uint64_t ShadingMeasurements::clocks(std::string_view walk) const {
  return kPentium32.clocks(counts.find(walk)->second.total());
}

double ShadingMeasurements::walk_gain(std::string_view from, std::string_view to) const {
  const auto cycles = [&](std::string_view name) {
    return walks.cycles[static_cast<std::size_t>(&find_walk(name) - study::walks().data())];
  };
  return cycles(from) / cycles(to);
}

std::string lobe_place(const LobeColumn& column) {
  return "span " + std::to_string(column.span) +
         ", n = " + significant_text(static_cast<double>(column.shininess), 3);
}

double ShadingMeasurements::lobe_gain(const LobeColumn& column, std::string_view lobe) const {
  return column.cost.gains[*index_of(lobes, lobe)];
}

double ShadingMeasurements::worst_nmse(std::size_t variant) const {
  double worst = 0;
  for (const ErrorColumn& column : errors) worst = std::max(worst, column.errors.differences[variant].nmse);
  return worst;
}

Result<ShadingMeasurements> measure_shading(const StudyOptions& options) {
  const auto tell = [&](const std::string& what) {
    if (options.progress) options.progress(what);
  };
  const Rounds rounds = options.quick ? Rounds{3, 0.02} : Rounds{};
  ShadingMeasurements m;
  list_methods(m);
  tell("timing the processor's clock");
  m.clock_ghz = clock_hz() * 1e-9;
  m.best = isa_name(available_isas().back());

  std::vector<PictureScene> models;  // read first: one that cannot be is told at once
  for (const std::string& model : options.models) {
    tell("reading " + model);
    Result<PictureScene> scene = model_picture(model, options.limits, options.quick);
    if (!scene) return scene.error();
    models.push_back(std::move(*scene));
  }
  tell("counting operations");
  for (const Walk& walk : walks()) m.counts.emplace(walk.name, count_operations(walk));
  tell("timing the papers' programs");
  m.walks = walk_cost(rounds);
  measure_speeds(options.quick, rounds, tell, m);
  const Status status = measure_pictures(options, models, tell, m);
  if (!status) return status.error();
  return m;
}

}  // namespace blysk::study
