// image/png.h - the pieces of a PNG file, for writers that need not join them.
#pragma once

#include <cstdint>
#include <vector>

#include "blysk/image.h"

namespace blysk {

/// Whether it has 1..kMaxPictureSide pixels a side, and as many as its sides say.
bool is_writable(const Image& image);

/// The file's bytes in order. The image must be writable.
std::vector<Array<std::uint8_t>> encode_png_pieces(const Image& image, const PictureOptions& options);

}  // namespace blysk
