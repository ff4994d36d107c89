// The study of the A-buffer: which scenes are measured, and how.
#include <algorithm>

#include "blysk/study.h"
#include "study/abuffer_results.h"
#include "study/abuffer_truth.h"

namespace blysk {
namespace study {
namespace {

using antialias::Overflow;

std::vector<Variant> variants_of(std::span<const Overflow> policies, std::size_t from, std::size_t to) {
  std::vector<Variant> variants;
  for (const Overflow policy : policies) {
    for (std::size_t n = from; n <= to; ++n) variants.push_back({.overflow = policy, .most = n});
  }
  return variants;
}

struct OrderRow {
  Order order;
  std::uint64_t seed;
  std::string_view name;
};
constexpr OrderRow kOtherOrders[] = {{Order::random, 2, "random, seed 2"},
                                     {Order::random, 3, "random, seed 3"},
                                     {Order::given, 0, "as given"},
                                     {Order::front_to_back, 0, "front to back"},
                                     {Order::back_to_front, 0, "back to front"}};
constexpr std::uint64_t kSeed = 1;

// Named scenes are asked for to save time: then models alone are held against the truth.
Result<std::vector<TruthResult>> measure_truths(const StudyOptions& options) {
  std::vector<std::string> names = options.models;
  if (options.scenes.empty()) names.insert(names.begin(), {"xfighter", "slivers"});
  std::vector<TruthResult> results;
  for (const std::string& name : names) {
    if (options.progress) options.progress("measuring " + name + " against the truth");
    const Result<TruthScene> scene = truth_scene(name, options.limits);
    if (!scene) return scene.error();
    Result<TruthResult> result = measure_truth(*scene, "supersample:n=4", options.threads);
    if (!result) return result.error();
    results.push_back(std::move(*result));
  }
  return results;
}

}  // namespace

const Quality& SceneResult::at(Overflow policy, std::size_t most) const {
  const auto row = static_cast<std::size_t>(std::ranges::find(kPolicies, policy) - std::begin(kPolicies));
  return quality[row * kMostFragments + most - 1];
}

std::optional<std::size_t> SceneResult::least(Overflow policy, double nmse) const {
  for (std::size_t n = 1; n <= kMostFragments; ++n) {
    if (at(policy, n).nmse <= nmse) return n;
  }
  return std::nullopt;
}

SceneResult measure_all(const StudyScene& scene, const SceneRow* row, ThreadPool& threads) {
  SceneResult result = {.name = scene.name,
                        .expected = row != nullptr && row->expected.generated > 0 ? &row->expected : nullptr,
                        .width = scene.width,
                        .height = scene.height,
                        .triangles_in = scene.triangles_in,
                        .triangles = scene.triangles.size()};
  std::vector<Submission> runs = {{Order::random, kSeed, variants_of(kPolicies, 1, kMostFragments)}};
  runs[0].variants.push_back({.kind = Variant::Kind::zbuffer});
  runs[0].variants.push_back({.kind = Variant::Kind::carpenter});
  for (const OrderRow& order : kOtherOrders) {
    runs.push_back({order.order, order.seed, variants_of(kExpectedPolicies, 3, 3)});
  }
  std::vector<Measured> measured = measure(scene, runs, threads);
  Measured& all = measured[0];
  result.complexity = all.complexity;
  result.live = std::move(all.live);
  result.carpenter = all.quality.back();
  all.quality.pop_back();
  result.zbuffer = all.quality.back();
  all.quality.pop_back();
  result.quality = std::move(all.quality);
  for (std::size_t i = 0; i < std::size(kOtherOrders); ++i) {
    result.orders.push_back({std::string(kOtherOrders[i].name), std::move(measured[i + 1].quality)});
  }
  if (scene.common_memory) result.memory = measure_memory(scene, Order::random, kSeed, threads);
  return result;
}

}  // namespace study

std::vector<std::string> abuffer_scenes() {
  std::vector<std::string> names;
  for (const study::SceneRow& row : study::scene_rows()) names.emplace_back(row.name);
  return names;
}

Result<StudyReport> study_abuffer(const StudyOptions& options) {
  StudyReport report = {
      .name = "abuffer",
      .title = "The modified A-buffer: policies for full lists, and memory that pixels share",
      .source =
          "O. N. Romaniuk, M. S. Kurinnyi, O. O. Dudnyk, A. V. Snihur, S. O. Romaniuk. Modification of "
          "the A-buffer method for antialiasing of three-dimensional images. Vinnytsia"};
  ThreadPool threads(options.threads);
  std::vector<study::SceneResult> scenes;
  const auto add = [&](const Result<study::StudyScene>& scene, const study::SceneRow* row) -> Status {
    if (!scene) return scene.error();
    scenes.push_back(study::measure_all(*scene, row, threads));
    std::vector<StudyClaim> claims = study::abuffer_claims(scenes.back());
    report.claims.insert(report.claims.end(), claims.begin(), claims.end());
    return Done{};
  };
  for (const std::string& name : options.scenes) {
    const std::vector<std::string> known = abuffer_scenes();
    if (std::ranges::find(known, name) == known.end()) {
      return Error{
          .code = ErrorCode::usage, .message = "the study has no scene of this name", .source = name};
    }
  }
  for (const study::SceneRow& row : study::scene_rows()) {
    const bool wanted =
        options.scenes.empty() || std::ranges::find(options.scenes, row.name) != options.scenes.end();
    if (!wanted) continue;
    if (options.progress) options.progress("measuring " + std::string(row.name));
    if (const Status status = add(study::make_scene(row), &row); !status) return status.error();
  }
  for (const std::string& model : options.models) {
    if (options.progress) options.progress("measuring " + model);
    const Status status = add(study::model_scene(model, options.limits), nullptr);
    if (!status) return status.error();
  }
  std::vector<study::TurningResult> turning;
  for (const std::string_view shape : {"xfighter", "trefoil?detail=384"}) {
    if (!options.scenes.empty()) break;
    if (options.progress) options.progress("measuring a turning model");
    const Result<study::TurningResult> result = study::measure_turning(shape, threads);
    if (!result) return result.error();
    turning.push_back(*result);
  }
  const Result<std::vector<study::TruthResult>> truths = study::measure_truths(options);
  if (!truths) return truths.error();
  report.sections = study::abuffer_sections(scenes, turning);
  if (!truths->empty()) report.sections.push_back(study::truth_section(*truths));
  return report;
}

}  // namespace blysk
