// shading/shade.h - what a shading method is given: one draw's pixels in one tile.
#pragma once

#include <cstdint>

#include "antialias/sample_tile.h"
#include "blysk/image.h"
#include "blysk/vector.h"
#include "geometry/screen_vertex.h"
#include "lighting/lamp.h"
#include "raster/tile.h"

namespace blysk {

/// Where the centre of a pixel looks. A pixel at subpixels (x, y) sees, at view depth d, the world point
/// (origin + x * origin_x + y * origin_y) + d * (direction + x * direction_x + y * direction_y).
struct ViewRays {
  float direction[3], direction_x[3], direction_y[3];  ///< component along the view axis is 1
  float origin[3], origin_x[3], origin_y[3];  ///< perspective: the eye; orthographic: moves with the pixel
  // d = depth_a / (1 + depth_b * nearness), orthographic: d = depth_a + depth_b * nearness
  bool orthographic;
  float depth_a, depth_b;
};

/// One instance as the shading methods see it.
struct Draw {
  const Vec3f* positions;
  const Vec3f* normals;  ///< null: every face has its own
  const Vec4f* colors;   ///< null: none
  const std::uint32_t* indices;
  std::uint32_t id_base, id_count;  ///< frame ids of its triangles
  std::uint32_t vertex_base;        ///< frame index of its vertex 0
  bool moved;                       ///< the matrices below are not the identity
  float normal_matrix[9];           ///< mesh to world for normals, row by row; lengths are not kept
  float matrix[12];                 ///< mesh to world, three rows
  Projection projection;
  Surface surface;
  bool in_samples = false;  ///< pixels in which several surfaces show are fragments: ShadeJob::samples

  /// What `auto` has found out about the draw in this frame; all threads find the same.
  enum InterpolationPays : std::uint8_t { kUnknown, kPays, kDoesNotPay };
  mutable std::uint8_t interpolation_pays = kUnknown;
};

struct ShadeJob {
  int x, y, width, height;       ///< tile in the picture, pixels
  TileBuffers* buffers;          ///< in: id, nearness; out: color
  SampleBuffers* samples;        ///< in: fragments, out: sum; null: there are none
  float* normals;                ///< out, of write_normals only: 3 * kTilePixels
  const ScreenVertex* vertices;  ///< of the frame
  const Draw* draw;
  const ViewRays* rays;
  bool screen_linear;  ///< attributes are interpolated without perspective, as the papers do
  Transfer transfer;
  const int* settings;  ///< of the shading method: MethodChoice::values
  float max_error;      ///< that a method which chooses for itself may make, of white as shown
};

/// Shades the pixels of the tile whose triangle belongs to job.draw.
using ShadeFunction = void (*)(const ShadeJob&);

}  // namespace blysk
