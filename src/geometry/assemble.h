// geometry/assemble.h - indices to triangles in bins.
#pragma once

#include <cstddef>
#include <cstdint>

#include "blysk/vector.h"
#include "geometry/bins.h"
#include "geometry/screen_vertex.h"

namespace blysk {

/// Which triangles are dropped by the sign of their area on the screen (row 0 at the top: a triangle seen
/// counter-clockwise has negative area).
enum class DropArea { none, positive, negative };

struct AssembleJob {
  const ScreenVertex* vertices;  ///< of the whole frame
  const std::uint32_t* indices;  ///< of the mesh
  std::size_t first, count;      ///< triangles of the mesh to take
  std::uint32_t vertex_base;     ///< frame index of the mesh's vertex 0
  std::uint32_t id_base;         ///< frame id of the mesh's triangle 0
  int width, height;             ///< picture, pixels
  int tiles_x;
  DropArea drop;
  Sampling sampling;  ///< triangles that miss all of these go
  bool transparent;   ///< of Sampling::samples: the triangles go to lists of their own
  ThreadBins* owner;  ///< of the lists
  Bin* bins;          ///< owner->bins()

  std::uint32_t* rest;          ///< out: triangles left to assemble_rest(), room for count + 16
  std::size_t rest_count;       ///< out
  std::uint64_t culled, drawn;  ///< out: added to
};

/// Bins small triangles (of Sampling::centers the very small ones as dots) and leaves large and unplaced ones
/// in job.rest.
using AssembleFunction = void (*)(AssembleJob&);

/// The triangles of job.rest: clips what has unplaced vertices, bins what is large.
void assemble_rest(AssembleJob& job, const Vec3f* positions, const Projection& projection);

}  // namespace blysk
