// render/brute_force.h - what a picture of flat colours shows by the book: every sample, every layer, exact
// coverage, depths and colours in doubles.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "raster/coverage_reference.h"
#include "render/frame.h"

namespace blysk::reference {

/// A triangle of one colour. Corners in 1/256 of a part of a pixel (render/subpixels.h).
struct FlatLayer {
  Triangle triangle;
  Vec3d color;
  double opacity = 1;
};

/// The unlit triangles of a scene, as its plan has them; none of them may need clipping.
inline std::vector<FlatLayer> flat_layers(const FramePlan& plan) {
  std::vector<FlatLayer> layers;
  for (const DrawPlan& p : plan.draws) {
    const Draw& d = p.draw;
    for (std::size_t i = 0; i < 3 * p.triangles; i += 3) {
      FlatLayer layer;
      for (std::size_t k = 0; k < 3; ++k) {
        layer.triangle.corner[k] = place(d.projection, d.positions[d.indices[i + k]]).value();
      }
      const Vec4f own = d.colors != nullptr ? d.colors[d.indices[i]] : Vec4f{1, 1, 1, 1};
      const float* ambient = d.surface.ambient;
      layer.color = to_double(Vec3f{ambient[0] * own.x, ambient[1] * own.y, ambient[2] * own.z});
      layer.opacity = double{p.opacity};
      layers.push_back(layer);
    }
  }
  return layers;
}

struct BrutePixel {
  Vec3d color;            ///< the mean of its samples
  bool doubtful = false;  ///< depths are so close that rounding decides what is seen
};

struct BruteForce {
  int width = 0, height = 0;  ///< of the picture
  Subpixels parts;            ///< sixteen samples each
  Vec3d background;

  [[nodiscard]] std::vector<BrutePixel> draw(const std::vector<FlatLayer>& layers) const {
    const int columns = 4 * parts.across, rows = 4 * parts.down, across = width * columns;
    std::vector<std::vector<Seen>> samples(static_cast<std::size_t>(across * height * rows));
    for (const FlatLayer& layer : layers) {
      Triangle t = layer.triangle;
      for (Place& p : t.corner) p = {4 * p.x, 4 * p.y, p.nearness};  // samples are centres of a finer picture
      const double error = depth_error(t);
      for_each_covered(t, across, height * rows, [&](int x, int y) {
        samples[static_cast<std::size_t>(y * across + x)].push_back({nearness_at(t, x, y), error, &layer});
      });
    }
    std::vector<BrutePixel> pixels(static_cast<std::size_t>(width * height));
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const int x = static_cast<int>(i) % across / columns, y = static_cast<int>(i) / across / rows;
      compose(samples[i], pixels[static_cast<std::size_t>(y * width + x)]);
    }
    return pixels;
  }

 private:
  struct Seen {
    double nearness, error;
    const FlatLayer* layer;
  };

  void compose(std::vector<Seen>& seen, BrutePixel& pixel) const {
    std::stable_sort(seen.begin(), seen.end(),
                     [](const Seen& a, const Seen& b) { return a.nearness > b.nearness; });
    double through = 1;
    Vec3d color;
    for (std::size_t i = 0; i < seen.size() && through > 0; ++i) {
      const FlatLayer& layer = *seen[i].layer;
      color = color + layer.color * (through * layer.opacity);
      through *= 1 - layer.opacity;
      if (i + 1 == seen.size()) break;
      const FlatLayer& next = *seen[i + 1].layer;
      const bool alike = layer.color == next.color && layer.opacity == next.opacity;
      const double apart = seen[i].nearness - seen[i + 1].nearness;
      pixel.doubtful = pixel.doubtful || (!alike && apart <= seen[i].error + seen[i + 1].error);
    }
    pixel.color = pixel.color + (color + background * through) * (1.0 / (16 * parts.count()));
  }
};

}  // namespace blysk::reference
