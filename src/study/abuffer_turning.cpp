#include "study/abuffer_turning.h"

#include <algorithm>

#include "blysk/shapes.h"
#include "math/trig.h"
#include "study/abuffer_scenes.h"
#include "study/flat_scene.h"

namespace blysk::study {
namespace {

constexpr int kFrames = 12;

Scene turned(Scene scene, double degrees) {
  const Bounds b = scene.bounds();
  const Vec3d middle = (b.lo + b.hi) * 0.5;
  const Mat4 turn = translation(middle) * rotation({0, 1, 0}, radians(degrees)) * translation(-middle);
  for (Instance& instance : scene.instances) instance.transform = turn * instance.transform;
  return scene;
}

// The frame with unlimited lists, and with each policy.
Result<std::vector<Picture>> frame_of(const Scene& scene, const Camera& camera, ThreadPool& threads) {
  const auto triangles = flat_triangles(scene, camera, kTurningWidth, kTurningHeight);
  if (!triangles) return triangles.error();
  const Region region = {0, 0, kTurningWidth, kTurningHeight};
  FragmentStream stream;
  rasterise(*triangles, submission_order(*triangles, Order::random, 1), region, kPattern, stream);
  stream.sort_by_pixel(region.pixels());
  std::vector<Picture> pictures(1 + std::size(kExpectedPolicies));
  threads.for_each(pictures.size(), [&](int, std::size_t i) {
    const Variant variant = i == 0 ? Variant{} : Variant{.overflow = kExpectedPolicies[i - 1], .most = 3};
    const auto tile = make_tile(variant, kPattern, region.pixels(), region.pixels());
    pictures[i] = picture_of(stream, *tile, region.pixels());
  });
  return pictures;
}

double nmse(const Picture& picture, const Picture& reference) {
  return error_of(picture, reference).quality().nmse;
}

}  // namespace

Result<TurningResult> measure_turning(std::string_view shape, ThreadPool& threads) {
  const Result<Scene> scene = make_shape(shape);
  if (!scene) return scene.error();
  const Camera camera = study_camera(*scene, kTurningWidth, kTurningHeight);
  TurningResult result = {.name = std::string(shape), .frames = kFrames, .moving = 0, .rows = {}};
  for (const antialias::Overflow policy : kExpectedPolicies) result.rows.push_back({policy});
  std::vector<Picture> before;
  for (int frame = 0; frame < kFrames; ++frame) {
    Result<std::vector<Picture>> now = frame_of(turned(*scene, frame), camera, threads);
    if (!now) return now.error();
    const std::vector<Picture>& pictures = *now;
    const double moved = frame == 0 ? 0 : nmse(pictures[0], before[0]);
    result.moving += moved / (kFrames - 1);
    for (std::size_t i = 0; i < result.rows.size(); ++i) {
      TurningRow& row = result.rows[i];
      const double error = nmse(pictures[i + 1], pictures[0]);
      row.mean += error / kFrames;
      row.worst = std::max(row.worst, error);
      if (frame > 0) row.flicker += (nmse(pictures[i + 1], before[i + 1]) - moved) / (kFrames - 1);
    }
    before = std::move(*now);
  }
  return result;
}

}  // namespace blysk::study
