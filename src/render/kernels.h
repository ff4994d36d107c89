// render/kernels.h - the kernels of one instruction set, as a table.
#pragma once

#include <string_view>

#include "antialias/sample_tile.h"
#include "blysk/render.h"
#include "geometry/assemble.h"
#include "geometry/support.h"
#include "geometry/transform.h"
#include "raster/tile.h"
#include "shading/shade.h"

namespace blysk {

struct ShadingKernel {
  std::string_view name;  ///< of the registry
  ShadeFunction shade;
};

struct Kernels {
  Isa isa;
  SupportFunction support;
  TransformFunction transform;
  AssembleFunction assemble;
  RasterizeFunction rasterize;
  RasterizeSamplesFunction rasterize_samples;
  ResolveFunction resolve_samples;
  StoreTileFunction store_tile;
  ShadeFunction write_normals;
  const ShadingKernel* shadings;
  int shadings_count;
};

/// The table of an instruction set that available_isas() lists; Isa::best is the last of them.
const Kernels& kernels(Isa isa);

}  // namespace blysk
