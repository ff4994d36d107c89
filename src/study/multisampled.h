// study/multisampled.h - common multisampling, by the book: coverage and depth at every sample, one shading a
// triangle and pixel, in doubles. A yardstick for the A-buffer, slow and not a method of the renderer.
//
// Hardware shades at the pixel's centre even where the triangle does not cover it, so that colours there are
// extrapolated; it can be told to shade at a covered place instead (OpenGL's centroid, here that of all
// covered samples).
#pragma once

#include "antialias/sample_patterns.h"
#include "blysk/image.h"
#include "blysk/render.h"

namespace blysk::study {

namespace detail {
constexpr antialias::SamplePattern rotated() {
  antialias::SamplePattern p;
  p.name = "rotated4";
  for (const auto& [x, y] : {std::pair{-2, -6}, {6, -2}, {-6, 2}, {2, 6}}) p.add(16 * x, 16 * y);
  return p;
}
}  // namespace detail

inline constexpr antialias::SamplePattern kRotated4 = detail::rotated();  ///< usual 4x: the rotated grid

enum class ShadeAt { centre, centroid };

struct Multisampling {
  const antialias::SamplePattern* pattern = &kRotated4;
  ShadeAt shade_at = ShadeAt::centre;
};

/// Blinn-Phong, with the camera, lights, ambient light and background of `options`, in linear light
/// (Transfer::none), whatever they say of methods; opaque, nothing culled. Triangles that the near or far
/// plane would cut are left out.
[[nodiscard]] Result<Image> multisampled(const Scene& scene, const RenderOptions& options,
                                         const Multisampling& sampling);

}  // namespace blysk::study
