// scene/shapes_screen.h - scenes made for one picture: triangles of one colour each, placed in pixels.
//
// The variants of the A-buffer are measured in them (study/abuffer.h).
#pragma once

#include <array>
#include <string_view>

#include "core/random.h"
#include "scene/shapes_internal.h"

namespace blysk::shape {

inline constexpr double kScreen = 128;  ///< pixels a side of the picture that such a scene is made for

/// The picture is the square from -1 to 1, +X right and +Y up; depth 0 stands at z = 1 and depth 1 at z = -1.
class ScreenScene {
 public:
  /// A corner in pixels, y down, and its depth.
  void add(std::array<Vec3d, 3> corners, Vec3f color);
  [[nodiscard]] std::size_t triangles() const { return mesh_.indices.size() / 3; }
  /// With the camera that shows the picture, and colours that need no light.
  [[nodiscard]] Scene finish(std::string_view name) &&;

 private:
  Mesh mesh_;
};

/// Red, green and blue uniform in 0..1.
[[nodiscard]] Vec3f random_color(Random& random);
/// Close to the normal distribution of variance 1: the sum of twelve uniform numbers.
[[nodiscard]] double random_normal(Random& random);
/// Uniform in low..high.
[[nodiscard]] inline double random_between(Random& random, double low, double high) {
  return low + (high - low) * double{random.unit()};
}

}  // namespace blysk::shape
