// 36 pictures around a shape: turn_00.png ... turn_35.png.
//
// One Renderer and one Frame serve all of them: threads stay up, and memory is allocated for the first only.
#include <blysk/blysk.h>

#include <cmath>
#include <cstdio>
#include <string>

namespace {

int fail(const blysk::Error& error) {
  std::fprintf(stderr, "%s\n", error.text().c_str());
  return static_cast<int>(error.code);
}

// On a circle around `bounds`, a little above its middle.
blysk::Camera camera_at(const blysk::Bounds& bounds, double turn) {
  const double angle = turn * 2 * 3.14159265358979, distance = 3 * bounds.radius();
  blysk::Camera camera;
  camera.target = bounds.center();
  camera.eye = camera.target + blysk::Vec3d{std::sin(angle), 0.4, std::cos(angle)} * distance;
  camera.fov_deg = 40;
  return camera;
}

}  // namespace

int main(int count, char** words) {
  const auto scene = blysk::make_shape(count > 1 ? words[1] : "trefoil?detail=512");
  if (!scene) return fail(scene.error());
  const blysk::Bounds bounds = scene->bounds();

  constexpr int kFrames = 36;
  blysk::Renderer renderer;
  blysk::RenderOptions options;
  options.width = options.height = 480;
  blysk::Frame frame;
  double milliseconds = 0;
  for (int i = 0; i < kFrames; ++i) {
    options.camera = camera_at(bounds, static_cast<double>(i) / kFrames);
    if (const auto drawn = renderer.render(*scene, options, frame); !drawn) return fail(drawn.error());
    milliseconds += frame.statistics.frame_ms;

    const std::string path = std::string("turn_") + (i < 10 ? "0" : "") + std::to_string(i) + ".png";
    const auto written = blysk::write_picture(frame.image, path, blysk::PictureFormat::png);
    if (!written) return fail(written.error());
  }
  std::fprintf(stderr, "%d frames, %.2f ms each\n", kFrames, milliseconds / kFrames);
}
