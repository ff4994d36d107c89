#include "study/speed.h"

#include <cmath>
#include <memory>

#include "blysk/methods.h"
#include "math/trig.h"
#include "shading/normals_reference.h"
#include "study/clock.h"
#include "study/operations.h"
#include "study/pipeline.h"

namespace blysk::study {
namespace {

constexpr int kWalkTriangles = 16;  // differently tilted, so that nothing of one serves the next

struct Grid {
  double cell_width, cell_height;  // pixels
  int width, height;               // of the picture
};

// One unit is one pixel. Normals lean up to 20 degrees, corners of a triangle up to about as much apart.
SpeedScene flat_grid(std::string name, const Grid& grid) {
  const int columns = static_cast<int>(std::ceil(grid.width / grid.cell_width));
  const int rows = static_cast<int>(std::ceil(grid.height / grid.cell_height));
  Mesh mesh;
  for (int y = 0; y <= rows; ++y) {
    for (int x = 0; x <= columns; ++x) {
      mesh.positions.push_back(to_float(Vec3d{x * grid.cell_width, y * grid.cell_height, 0}));
      mesh.normals.push_back(to_float(normalize(Vec3d{0.3 * sine(x * 0.9), 0.3 * cosine(y * 0.8), 1})));
    }
  }
  const auto stride = static_cast<std::uint32_t>(columns) + 1;
  for (std::uint32_t y = 0; y < static_cast<std::uint32_t>(rows); ++y) {
    for (std::uint32_t x = 0; x < static_cast<std::uint32_t>(columns); ++x) {
      const std::uint32_t a = y * stride + x, b = a + 1, c = a + stride, d = c + 1;
      mesh.indices.insert(mesh.indices.end(), {a, b, d, a, d, c});
    }
  }
  SpeedScene scene;
  scene.name = std::move(name);
  Material material;
  material.color = {0.75f, 0.7f, 0.65f};
  material.specular = {0.45f, 0.45f, 0.45f};
  material.shininess = 50;
  scene.scene.add(std::move(mesh), material);

  Light light;
  light.vector = normalize(Vec3d{0.3, 0.5, 1});
  light.color = {0.85f, 0.85f, 0.85f};
  Camera camera;
  camera.eye = {grid.width * 0.5, grid.height * 0.5, 10};
  camera.target = {grid.width * 0.5, grid.height * 0.5, 0};
  camera.height = grid.height;
  camera.near_distance = 1;
  camera.far_distance = 20;
  scene.options.width = grid.width;
  scene.options.height = grid.height;
  scene.options.camera = camera;
  scene.options.lights = {light};
  scene.options.interpolation = Interpolation::screen;
  scene.options.transfer = Transfer::none;
  scene.options.cull = Cull::none;
  return scene;
}

ShadingCost cost_of(const std::vector<std::function<void()>>& runs, double pixels, const Rounds& rounds) {
  ShadingCost cost;
  for (const Timing& t : time_in_turn(runs, rounds)) {
    cost.cycles.push_back(t.ns * 1e-9 * clock_hz() / pixels);
    cost.gains.push_back(t.gain);
  }
  return cost;
}

}  // namespace

SpeedScene triangles_of(double pixels, int side) {
  const double leg = std::sqrt(2 * pixels);
  return flat_grid(std::to_string(static_cast<int>(pixels)) + (pixels == 1 ? " pixel" : " pixels"),
                   {leg, leg, side, side});
}

SpeedScene spans_of(int pixels, int width, int height) {
  return flat_grid("span " + std::to_string(pixels), {2.0 * pixels, 32, width, height});
}

ShadingCost shading_cost(const SpeedScene& scene, const std::vector<std::string>& methods, Isa isa,
                         const Rounds& rounds) {
  Pipeline pipeline(scene.scene, scene.options, isa);
  const auto pixels = static_cast<double>(pipeline.keep_tiles());
  std::vector<std::function<void()>> runs;
  for (const std::string& name : methods) {
    const MethodChoice choice = *choose_method(MethodKind::shading, name);
    runs.emplace_back([&pipeline, choice] { pipeline.shade(choice); });
  }
  return cost_of(runs, pixels, rounds);
}

WalkCost walk_cost(const Rounds& rounds) {
  std::vector<WalkTriangle<float>> triangles;
  for (int i = 0; i < kWalkTriangles; ++i) {
    triangles.push_back(average_triangle<float>(static_cast<double>(i) / kWalkTriangles));
  }
  Pixels<float> out(triangles[0].rows);
  std::vector<std::function<void()>> runs;
  for (const Walk& walk : walks()) {
    runs.emplace_back([&triangles, &out, run = walk.run] {
      for (const WalkTriangle<float>& t : triangles) run(t, out);
    });
  }
  const ShadingCost cost = cost_of(runs, kWalkTriangles * kAveragePixels, rounds);
  return {cost.cycles, cost.gains};
}

std::vector<double> row_cost(const Rounds& rounds) {
  constexpr int kRows = 64, kPixels = 16;
  const reference::SecondOrderSurfaceOf<float> surface = {-0.0022f, -0.0015f, 0.0011f, 0.013f, 0.021f, 0.45f};
  std::vector<float> out(kRows * kPixels);
  std::vector<std::function<void()>> runs;
  for (int form = 0; form <= static_cast<int>(QuadraticForm::forward); ++form) {
    runs.emplace_back([&, form] {
      for (int y = 0; y < kRows; ++y) {
        reference::quadratic_row<float>(
            static_cast<QuadraticForm>(form), surface, -5.0f, static_cast<float>(y),
            std::span(out).subspan(static_cast<std::size_t>(y) * kPixels, kPixels));
      }
    });
  }
  return cost_of(runs, kRows * kPixels, rounds).cycles;
}

std::vector<double> normalisation_cost(const Rounds& rounds) {
  constexpr std::size_t kVectors = 1024;
  std::vector<Vec3f> in, out(kVectors);
  for (std::size_t i = 0; i < kVectors; ++i) {
    const double turn = radians(static_cast<double>(i));
    in.push_back(to_float(Vec3d{0.3 * sine(turn), 0.3 * cosine(turn), 0.85}));
  }
  const auto each = [&](auto unit) {
    return [&in, &out, unit] {
      for (std::size_t i = 0; i < in.size(); ++i) out[i] = unit(in[i]);
    };
  };
  const std::vector<std::function<void()>> runs = {
      each([](Vec3f n) { return n * (1 / std::sqrt(dot(n, n))); }), each([](Vec3f n) {
        const float l = std::sqrt(dot(n, n));
        return Vec3f{n.x / l, n.y / l, n.z / l};
      }),
      each([](Vec3f n) { return n * reference::inverse_length<float>(kInverseLengthPaper, dot(n, n)); })};
  return cost_of(runs, kVectors, rounds).cycles;
}

std::vector<double> plain_lobe_cost(const Rounds& rounds) {
  constexpr std::size_t kCosines = 1024;
  constexpr int kShininess = 50;
  std::vector<float> in, out(kCosines);
  for (std::size_t i = 0; i < kCosines; ++i) in.push_back(0.8f + 0.2f * static_cast<float>(i) / kCosines);
  const auto each = [&](auto lobe) {
    return [&in, &out, lobe] {
      for (std::size_t i = 0; i < in.size(); ++i) out[i] = lobe(in[i]);
    };
  };
  const double scale = reference::w_shift_scale(kShininess, 16);
  const std::vector<std::function<void()>> runs = {
      each([](float c) { return reference::fixed_power<kShininess>(c); }),
      each([](float c) { return reference::schlick_lobe(c, kShininess); }),
      each([scale](float c) { return reference::fixed_w_lobe<16>(c, scale); })};
  return cost_of(runs, kCosines, rounds).cycles;
}

ShadingCost lobe_cost(SpeedScene scene, float shininess, const std::vector<std::string>& lobes,
                      const Rounds& rounds) {
  scene.scene.materials.at(0).shininess = shininess;
  std::vector<std::unique_ptr<Pipeline>> pipelines;
  std::vector<std::function<void()>> runs;
  const MethodChoice phong = *choose_method(MethodKind::shading, "phong");
  double pixels = 0;
  for (const std::string& lobe : lobes) {
    scene.options.lobe = lobe;
    pipelines.push_back(std::make_unique<Pipeline>(scene.scene, scene.options, Isa::best));
    pixels = static_cast<double>(pipelines.back()->keep_tiles());
    runs.emplace_back([&pipeline = *pipelines.back(), phong] { pipeline.shade(phong); });
  }
  return cost_of(runs, pixels, rounds);
}

}  // namespace blysk::study
