// A mesh made by hand, lit by two lights and seen by an explicit camera: roof.png, and its depths read back.
#include <blysk/blysk.h>

#include <algorithm>
#include <cstdio>

namespace {

int fail(const blysk::Error& error) {
  std::fprintf(stderr, "%s\n", error.text().c_str());
  return static_cast<int>(error.code);
}

// A hipped roof: four slopes and no floor. Without normals every face has its own: the ridges stay hard.
blysk::Mesh roof() {
  blysk::Mesh mesh;
  mesh.name = "roof";
  mesh.positions = {{-2, 0, 1}, {2, 0, 1}, {2, 0, -1}, {-2, 0, -1}, {-1, 1, 0}, {1, 1, 0}};
  mesh.indices = {0, 1, 5, 0, 5, 4,   // front, counter-clockwise as seen from outside
                  2, 3, 4, 2, 4, 5,   // back
                  1, 2, 5, 3, 0, 4};  // right, left
  return mesh;
}

}  // namespace

int main() {
  blysk::Scene scene;
  scene.add(roof(), {.name = "tiles", .color = {0.6f, 0.2f, 0.1f}, .shininess = 20});

  blysk::Light sun, lamp;
  sun.vector = {0.5, 1, 0.8};  // towards the light
  lamp.kind = blysk::Light::Kind::point;
  lamp.vector = {-3, 2, 2};  // where it hangs
  lamp.color = {0.2f, 0.3f, 0.6f};

  blysk::RenderOptions options;
  options.width = 640;
  options.height = 360;
  options.camera = blysk::Camera{.eye = {2, 3, 6}, .target = {0, 0.4, 0}, .fov_deg = 35};
  options.lights = {sun, lamp};
  options.background = {1, 1, 1, 1};
  options.want_depth = true;

  const auto frame = blysk::Renderer().render(scene, options);
  if (!frame) return fail(frame.error());

  // 0 is the near plane; 1 the far plane, and wherever nothing is.
  const auto& depths = frame->depth.values;
  const auto covered = std::count_if(depths.begin(), depths.end(), [](float depth) { return depth < 1; });
  const std::size_t middle = static_cast<std::size_t>(options.height / 2) * options.width + options.width / 2;
  std::printf("%td of %zu pixels show the roof; depth in the middle: %.4f\n", covered, depths.size(),
              static_cast<double>(depths[middle]));

  const auto written = blysk::write_picture(frame->image, "roof.png", blysk::PictureFormat::png);
  if (!written) return fail(written.error());
}
