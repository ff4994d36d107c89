#include "study/flat_picture.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace blysk::study {

void PictureError::add(Vec3d shown, Vec3d wanted) {
  const Vec3d d = shown - wanted;
  const double worst = std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)});
  squares += dot(d, d);
  reference += dot(wanted, wanted);
  ++pixels;
  over_8 += worst > 8 ? 1 : 0;
  over_32 += worst > 32 ? 1 : 0;
}

PictureError& PictureError::operator+=(const PictureError& o) {
  squares += o.squares;
  reference += o.reference;
  pixels += o.pixels;
  over_8 += o.over_8;
  over_32 += o.over_32;
  return *this;
}

Quality PictureError::quality() const {
  constexpr double kRounding = 1e-12;  // merged colours are floats: their rounding is no error
  const auto all = static_cast<double>(pixels);
  const double nmse = squares <= kRounding * reference ? 0 : squares / reference;
  double psnr = std::numeric_limits<double>::infinity();
  if (nmse > 0) psnr = 10 * std::log10(255.0 * 255 * 3 * all / squares);  // deterministic: shown to a tenth
  return {nmse, psnr, static_cast<double>(over_8) / all, static_cast<double>(over_32) / all};
}

Picture picture_of(const FragmentStream& stream, antialias::FragmentTile& tile, std::size_t pixels) {
  tile.clear(pixels);
  stream.insert_into(tile);
  Picture picture(pixels);
  for (std::size_t p = 0; p < pixels; ++p) picture[p] = tile.resolve(p, kBackground);
  return picture;
}

PictureError error_of(const Picture& picture, const Picture& reference) {
  PictureError error;
  for (std::size_t p = 0; p < picture.size(); ++p) error.add(picture[p], reference[p]);
  return error;
}

}  // namespace blysk::study
