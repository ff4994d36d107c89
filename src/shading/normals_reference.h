// shading/normals_reference.h - the relief thesis' ways to interpolated normals, as the specification writes
// them, in double precision. What the kernels are measured against.
#pragma once

#include "blysk/vector.h"
#include "math/inverse_length.h"

namespace blysk::reference {

/// Steps of a vector that is linear on the screen, and its value at corner 0 (specification 2.1).
struct LinearNormals {
  double x, y;  ///< of corner 0, pixels
  Vec3d at_corner;
  Vec3d horizontal, vertical;  ///< from a pixel to the next
  [[nodiscard]] Vec3d at(double px, double py) const;
};
LinearNormals linear_normals(const Vec2<double> (&corner)[3], const Vec3d (&normal)[3]);

/// Squared length along a row by additions alone (specification 2.3). The paper starts beta at 1; -beta is
/// meant.
class SquaredLengths {
 public:
  SquaredLengths(Vec3d first, Vec3d step);
  [[nodiscard]] double value() const { return k_; }
  void next();

 private:
  double k_, difference_, twice_beta_;
};

double inverse_length(const InverseLength& polynomial, double k);
/// Outside the polynomial's range by the exact root.
Vec3d normalize_fast(const InverseLength& polynomial, Vec3d n);

/// Four times the vector in the middle of an edge: M of specification 2.4.
Vec3d mid_vector(const MidVector& polynomial, Vec3d a, Vec3d b);
/// The normal at barycentric (c1, c2, 1 - c1 - c2) of unit corner normals (specification 2.4). Where two of
/// them are further apart than the polynomial reaches, linear and made unit by the exact root.
Vec3d six_point_normal(const MidVector& polynomial, const Vec3d (&normal)[3], double c1, double c2);

}  // namespace blysk::reference
