// lighting/lamp.h - lights and surface as a kernel takes them: constants of one draw.
#pragma once

namespace blysk {

/// How light, normal and view give an intensity (the registry's `lighting`).
enum class LightingModel { lambert, phong, blinn };

/// How the specular term falls off (the registry's `lobe`).
enum class Lobe { power, schlick, w3, w4, w7, w8, w15, w16, logarithmic, quadratic, cosine_squared };

/// One light, already multiplied by the material.
struct Lamp {
  bool point;  ///< vector is a position (world) instead of a unit direction towards the light
  float vector[3];
  float diffuse[3];   ///< Il * kd
  float specular[3];  ///< Il * ks
};

inline constexpr int kMaxLamps = 16;

struct Surface {
  LightingModel model;
  Lobe lobe;
  float shininess;
  int whole_shininess;  ///< the same if it is an integer, else 0
  float lobe_scale;     ///< of the lobes that end before 90 degrees: set_lobe()
  int lobe_exponent;    ///< likewise
  float ambient[3];     ///< ka * Ia
  float emission[3];
  int lamps;
  Lamp lamp[kMaxLamps];
};

}  // namespace blysk
