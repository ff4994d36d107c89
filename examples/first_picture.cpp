// A model (or a built-in teapot) to teapot.png.
#include <blysk/blysk.h>

#include <cstdio>

int main(int count, char** words) {
  const auto scene = blysk::load_model(count > 1 ? words[1] : "shape:teapot");
  if (!scene) return std::fprintf(stderr, "%s\n", scene.error().text().c_str()), 1;
  const auto frame = blysk::Renderer().render(*scene, {.width = 640, .height = 480});
  if (!frame) return std::fprintf(stderr, "%s\n", frame.error().text().c_str()), 1;
  const auto written = blysk::write_picture(frame->image, "teapot.png", blysk::PictureFormat::png);
  if (!written) return std::fprintf(stderr, "%s\n", written.error().text().c_str()), 1;
}
