// A square of hills: octaves of gradient noise, each half as high and twice as fine as the one before.
#include <utility>

#include "core/random.h"
#include "math/noise.h"
#include "scene/shapes_internal.h"

namespace blysk::shape {
namespace {

struct Hills {
  Vec3d origin;  // of the square's middle in the noise, by the seed
  double height, cells;
  int octaves;

  // Height as `value`, its slopes along X and Z as `gradient`.
  [[nodiscard]] Noise at(double x, double z) const {
    Noise sum{0, {0, 0, 0}};
    double weight = 1, weights = 0, frequency = 1;
    for (int octave = 0; octave < octaves; ++octave) {
      const Vec3d p = origin + Vec3d{x * cells / 2, 0, z * cells / 2};
      const Noise n = gradient_noise(p * frequency);
      sum.value += weight * n.value;
      sum.gradient = sum.gradient + n.gradient * (weight * frequency * cells / 2);
      weights += weight;
      weight *= 0.5;
      frequency *= 2;
    }
    return {sum.value * (height / weights), sum.gradient * (height / weights)};
  }
};

Scene make_terrain(const Arguments& arguments) {
  const int detail = arguments.whole("detail");
  Random random(static_cast<std::uint64_t>(arguments.real("seed")));
  const auto coordinate = [&] { return 256 * static_cast<double>(random.unit()); };
  Hills hills{{}, arguments.real("height"), arguments.real("cells"), arguments.whole("octaves")};
  hills.origin.x = coordinate();
  hills.origin.y = coordinate();
  hills.origin.z = coordinate();

  Mesh mesh;
  add_sheet(mesh, {.columns = detail, .rows = detail}, [&](int row, int column, Vec2f texcoord) {
    const double x = static_cast<double>(2 * column - detail) / detail;
    const double z = static_cast<double>(2 * row - detail) / detail;
    const Noise n = hills.at(x, z);
    return Vertex{to_float({x, n.value, z}), to_float(normalize(Vec3d{-n.gradient.x, 1, -n.gradient.z})),
                  texcoord};
  });
  return scene_of(std::move(mesh), "terrain");
}

}  // namespace

Entry terrain() {
  return {{"terrain",
           "square of side 2 with hills of gradient noise, facing +Y",
           {{"detail", 1, 2048, 128, "segments along each side"},
            {"seed", 0, 4294967295, 1, "which hills"},
            {"height", 0, 2, 0.5, "how far hills may rise, and valleys fall: 1.04 times this at most", false},
            {"cells", 0.1, 64, 3, "large hills and valleys from side to side", false},
            {"octaves", 1, 10, 5, "layers of ever finer hills"}}},
          make_terrain};
}

}  // namespace blysk::shape
