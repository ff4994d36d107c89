// Draws a small picture through the public API alone, and writes it.
#include <blysk/blysk.h>

#include <cstdio>
#include <string>

namespace {

int fail(const blysk::Error& error) {
  std::fprintf(stderr, "%s\n", error.text().c_str());
  return static_cast<int>(error.code);
}

}  // namespace

int main() {
  const auto scene = blysk::make_shape("sphere?detail=8");
  if (!scene) return fail(scene.error());

  blysk::Renderer renderer({.threads = 1});
  const auto frame = renderer.render(*scene, {.width = 16, .height = 16});
  if (!frame) return fail(frame.error());

  const auto written = blysk::write_picture(frame->image, "consumer.png", blysk::PictureFormat::png);
  if (!written) return fail(written.error());

  std::printf("blysk %s: %llu triangles, %llu pixels\n", std::string(blysk::version()).c_str(),
              static_cast<unsigned long long>(scene->triangles()),
              static_cast<unsigned long long>(frame->statistics.pixels_covered));
  return frame->statistics.pixels_covered > 0 ? 0 : 1;
}
