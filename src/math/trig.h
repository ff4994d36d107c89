// math/trig.h - sine, cosine and their kin from + - * / alone, so that cameras and shapes have the same bits
// on every system. libm differs between systems and is not used for anything that reaches a picture.
#pragma once

namespace blysk {

inline constexpr double kPi = 3.14159265358979323846;

/// Max error: 1e-15 absolute. Valid range: |radians| <= 1e6.
double sine(double radians);
double cosine(double radians);
double tangent(double radians);
/// Max error: 1e-15 absolute.
double arc_tangent(double v);
inline double radians(double degrees) { return degrees * (kPi / 180.0); }

}  // namespace blysk
