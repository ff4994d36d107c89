// lighting/lighting_reference.h - the lighting models as the specification writes them, in double precision.
//
// What the kernels are measured against: thesis, formula (2.1) and section 2.1 of the specification.
#pragma once

#include <vector>

#include "blysk/scene.h"
#include "lighting/lamp.h"

namespace blysk::reference {

/// Unit vectors at a point.
struct Directions {
  Vec3d normal, light, viewer;
};

/// R.V of R = 2(N.L)N - L.
double cos_reflected(const Directions& d);
/// N.H of H = (L + V)/|L + V|; 0 where L + V is 0.
double cos_halfway(const Directions& d);
/// The lobe at the model's angle; 0 where the light is behind the surface.
double specular(LightingModel model, const Directions& d, double n, Lobe lobe = Lobe::power);

/// What lights a draw.
struct Lighting {
  LightingModel model = LightingModel::blinn;
  Material material;
  std::vector<Light> lights;
  double ambient = 0;  ///< Ia
  Lobe lobe = Lobe::power;
};

/// Light that leaves a point, apart: vertex colours multiply the diffuse part only.
struct Intensity {
  Vec3d diffuse;   ///< ambient and diffuse
  Vec3d specular;  ///< specular and emission
};

/// `normal` and `viewer` (towards it) of any length; the side that faces the viewer is lit.
Intensity light_point(const Lighting& lighting, Vec3d position, Vec3d normal, Vec3d viewer);

}  // namespace blysk::reference
