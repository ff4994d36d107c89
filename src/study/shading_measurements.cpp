#include "study/shading_measurements.h"

#include <algorithm>

#include "blysk/methods.h"
#include "study/clock.h"
#include "study/cost_model.h"

namespace blysk::study {
namespace {

constexpr int kTriangleSizes[] = {1, 4, 16, 100};
constexpr int kSpans[] = {4, 8, 16, 32, 64, 128, 256};
constexpr int kDetails[] = {10, 25, 50, 100}, kThesisDetail = 50;
constexpr int kSide = 256, kSmallSide = 64, kSpanWidth = 512;

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

std::vector<SpeedScene> speed_scenes(bool quick) {
  std::vector<SpeedScene> scenes;
  for (const int pixels : kTriangleSizes) scenes.push_back(triangles_of(pixels, quick ? kSmallSide : kSide));
  for (const int pixels : kSpans) {
    if (!quick || pixels == 64) scenes.push_back(spans_of(pixels, quick ? kSide : kSpanWidth, kSide / 4));
  }
  return scenes;
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
  const Rounds frames = options.quick ? Rounds{1, 0.0} : Rounds{25, 0.0};
  const Rounds few = options.quick ? Rounds{1, 0.0} : Rounds{5, 0.0};
  ShadingMeasurements m;
  list_methods(m);
  m.clock_ghz = clock_hz() * 1e-9;
  m.best = isa_name(available_isas().back());

  tell("counting operations");
  for (const Walk& walk : walks()) m.counts.emplace(walk.name, count_operations(walk));
  tell("timing the papers' programs");
  m.walks = walk_cost(rounds);
  const std::vector<SpeedScene> scenes = speed_scenes(options.quick);
  for (const SpeedScene& scene : scenes) {
    tell("timing shading, " + scene.name);
    SpeedColumn column{scene.name, shading_cost(scene, m.methods, Isa::best, rounds), {}};
    if (have(Isa::scalar)) column.scalar = shading_cost(scene, m.methods, Isa::scalar, few);
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
  m.lobe_speeds = lobe_cost(m.lobes, rounds);

  for (const int detail : kDetails) {
    tell("comparing pictures of spheres, detail " + std::to_string(detail));
    const Result<PictureScene> scene = thesis_spheres(detail, options.quick);
    if (!scene) return scene.error();
    const Rounds timed = detail == kThesisDetail ? frames : Rounds{0, 0.0};
    Result<PictureErrors> errors = picture_errors(*scene, MethodKind::shading, m.variants, timed);
    if (!errors) return errors.error();
    m.errors.push_back({scene->name, std::move(*errors)});
    if (detail != kThesisDetail) continue;
    Result<PictureErrors> of_lobes = picture_errors(*scene, MethodKind::lobe, m.lobes, Rounds{0, 0.0});
    if (!of_lobes) return of_lobes.error();
    m.lobe_errors = {scene->name, std::move(*of_lobes)};
  }
  tell("comparing pictures of the teapot");
  const Result<PictureScene> pot = teapot(options.quick);
  if (!pot) return pot.error();
  Result<PictureErrors> errors = picture_errors(*pot, MethodKind::shading, m.variants, frames);
  if (!errors) return errors.error();
  m.errors.push_back({pot->name, std::move(*errors)});
  return m;
}

}  // namespace blysk::study
