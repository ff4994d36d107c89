// math/lighting_texture.h - when a triangle gets a lighting texture, and how fine.
//
// Per-fragment paper; A-buffer specification, C.6 - C.8.
#pragma once

namespace blysk {

inline constexpr int kTextureSteps = 16;     ///< of an edge, on the finest level: 17 x 17 points
inline constexpr int kTextureLamps = 4;      ///< surfaces with more are lit pixel by pixel
inline constexpr float kTextureOne = 32767;  ///< 1 as fixed point

/// shininess * (angle from point to point)^2 up to which linear interpolation is at most about 2/255 off:
/// second derivative of cos^n at its top, an eighth of it.
inline constexpr double kTextureTurn = 0.06;

/// A texture pays from this many pixels a point on.
inline constexpr int kTexturePay = 2;

}  // namespace blysk
