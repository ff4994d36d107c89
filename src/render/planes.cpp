#include "render/planes.h"

#include <cstring>
#include <utility>

#include "antialias/sample_tile.h"

namespace blysk {
namespace {

void size_floats(FloatImage& plane, const RenderOptions& options, int channels) {
  plane.width = options.width;
  plane.height = options.height;
  plane.channels = channels;
  plane.values.resize(static_cast<std::size_t>(channels) * static_cast<std::size_t>(options.width) *
                      static_cast<std::size_t>(options.height));
}

}  // namespace

void size_planes(const RenderOptions& options, Frame& frame) {
  const std::size_t pixels =
      static_cast<std::size_t>(options.width) * static_cast<std::size_t>(options.height);
  const auto size = [&](FloatImage& plane, bool wanted, int channels) {
    if (wanted) {
      size_floats(plane, options, channels);
    } else {
      plane = {};
    }
  };
  size(frame.depth, options.want_depth, 1);
  size(frame.normal, options.want_normal, 3);
  size(frame.coverage, options.want_coverage, 1);
  frame.id.resize(options.want_id ? pixels : 0);
  frame.fragments.resize(options.want_fragments ? pixels : 0);
}

void store_planes(const RenderOptions& options, const TilePlanes& tile, Frame& frame) {
  if (!wants_surface(options) && !wants_counts(options)) return;
  const auto& [area, buffers, normals, counts, samples] = tile;
  const auto width = static_cast<std::size_t>(area.width);
  for (int row = 0; row < area.height; ++row) {
    const std::size_t from = static_cast<std::size_t>(row) * kTileSize;
    const std::size_t to = static_cast<std::size_t>(area.y + row) * static_cast<std::size_t>(options.width) +
                           static_cast<std::size_t>(area.x);
    if (options.want_normal)
      std::memcpy(&frame.normal.values[3 * to], normals + 3 * from, 3 * width * sizeof(float));
    for (std::size_t i = 0; i < width && options.want_depth; ++i)
      frame.depth.values[to + i] = 1.0f - buffers->nearness[from + i];
    for (std::size_t i = 0; i < width && options.want_id; ++i) frame.id[to + i] = buffers->id[from + i] + 1;
    if (options.want_fragments)
      std::memcpy(&frame.fragments[to], counts->live + from, width * sizeof(std::uint32_t));
    for (std::size_t i = 0; i < width && options.want_coverage; ++i)
      frame.coverage.values[to + i] =
          static_cast<float>(counts->covered[from + i]) / static_cast<float>(samples);
  }
}

}  // namespace blysk
