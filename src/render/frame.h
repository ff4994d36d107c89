// render/frame.h - a scene and options as the kernels' constants.
#pragma once

#include <vector>

#include "antialias/overflow.h"
#include "antialias/vertex_opacity.h"
#include "blysk/methods.h"
#include "blysk/render.h"
#include "geometry/assemble.h"
#include "render/subpixels.h"
#include "render/view.h"
#include "shading/shade.h"

namespace blysk {

/// One instance: what its draw says, and what geometry needs besides.
struct DrawPlan {
  Draw draw;
  std::size_t vertices = 0, triangles = 0;
  DropArea drop = DropArea::none;
  float opacity = 1;    ///< below 1 it is transparent; only where pixels are sampled
  bool varies = false;  ///< opacity is that of the vertices: `varying`
  VertexOpacity varying{};

  [[nodiscard]] bool transparent() const { return varies || opacity < 1; }
};

/// A variant of the A-buffer that keeps lists of fragments.
struct ListPlan {
  enum class Kind { none, lists, pool, carpenter };
  Kind kind = Kind::none;
  antialias::Overflow overflow = antialias::Overflow::unlimited;
  std::size_t most = 0;                       ///< of lists, fragments a pixel
  std::size_t main = 0, extra = 0, pool = 0;  ///< of a pool, which is a tile's
  const antialias::SamplePattern* pattern = &antialias::kGrid16;
};

struct FramePlan {
  ViewFrame view;
  std::vector<DrawPlan> draws;  ///< instances with triangles, in the scene's order
  std::size_t vertices = 0, triangles = 0;
  std::uint32_t background = 0;  ///< RGBA8
  Vec4f linear_background;       ///< linear colour times alpha, alpha
  Sampling sampling = Sampling::centers;
  ListPlan lists;
  Subpixels subpixels;
  int width = 0, height = 0;   ///< of what is drawn: sub-pixels
  bool glass = false;          ///< any draw is transparent
  bool want_nearness = false;  ///< of pixels: for point lights or a picture of depths
  MethodChoice shading;
};

/// Checks the options and fills `plan` (its memory is reused).
[[nodiscard]] Status plan_frame(const Scene& scene, const RenderOptions& options, FramePlan& plan);

}  // namespace blysk
