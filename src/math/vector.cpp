#include "blysk/vector.h"

#include <algorithm>

#include "math/trig.h"

namespace blysk {

Mat4 operator*(const Mat4& a, const Mat4& b) {
  Mat4 r;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      double s = 0;
      for (int k = 0; k < 4; ++k) s += a.m[i][k] * b.m[k][j];
      r.m[i][j] = s;
    }
  }
  return r;
}

Vec4d transform(const Mat4& m, Vec4d v) {
  const auto row = [&](int i) {
    return m.m[i][0] * v.x + m.m[i][1] * v.y + m.m[i][2] * v.z + m.m[i][3] * v.w;
  };
  return {row(0), row(1), row(2), row(3)};
}

Vec3d transform_point(const Mat4& m, Vec3d p) {
  const Vec4d r = transform(m, {p.x, p.y, p.z, 1});
  return {r.x, r.y, r.z};
}

Vec3d transform_direction(const Mat4& m, Vec3d d) {
  const Vec4d r = transform(m, {d.x, d.y, d.z, 0});
  return {r.x, r.y, r.z};
}

double determinant3(const Mat4& m) {
  const auto& a = m.m;
  return a[0][0] * (a[1][1] * a[2][2] - a[1][2] * a[2][1]) -
         a[0][1] * (a[1][0] * a[2][2] - a[1][2] * a[2][0]) +
         a[0][2] * (a[1][0] * a[2][1] - a[1][1] * a[2][0]);
}

Mat4 normal_matrix(const Mat4& m) {
  const auto& a = m.m;
  Mat4 r;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const int i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
      r.m[i][j] = a[i1][j1] * a[i2][j2] - a[i1][j2] * a[i2][j1];
    }
  }
  return r;
}

Mat4 translation(Vec3d by) {
  Mat4 r;
  r.m[0][3] = by.x;
  r.m[1][3] = by.y;
  r.m[2][3] = by.z;
  return r;
}

Mat4 scaling(Vec3d by) {
  Mat4 r;
  r.m[0][0] = by.x;
  r.m[1][1] = by.y;
  r.m[2][2] = by.z;
  return r;
}

Mat4 rotation(Vec3d axis, double radians) {
  const double s = sine(radians * 0.5);
  return rotation_from_quaternion({axis.x * s, axis.y * s, axis.z * s, cosine(radians * 0.5)});
}

Mat4 rotation_from_quaternion(Vec4d q) {
  const double n = q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w;
  if (!(n > 0) || n > 1e300) return {};
  const double s = 2.0 / n;
  Mat4 r;
  r.m[0][0] = 1 - s * (q.y * q.y + q.z * q.z);
  r.m[0][1] = s * (q.x * q.y - q.z * q.w);
  r.m[0][2] = s * (q.x * q.z + q.y * q.w);
  r.m[1][0] = s * (q.x * q.y + q.z * q.w);
  r.m[1][1] = 1 - s * (q.x * q.x + q.z * q.z);
  r.m[1][2] = s * (q.y * q.z - q.x * q.w);
  r.m[2][0] = s * (q.x * q.z - q.y * q.w);
  r.m[2][1] = s * (q.y * q.z + q.x * q.w);
  r.m[2][2] = 1 - s * (q.x * q.x + q.y * q.y);
  return r;
}

void Bounds::add(Vec3d p) {
  lo = {std::min(lo.x, p.x), std::min(lo.y, p.y), std::min(lo.z, p.z)};
  hi = {std::max(hi.x, p.x), std::max(hi.y, p.y), std::max(hi.z, p.z)};
}

void Bounds::add(const Bounds& b) {
  if (b.empty()) return;
  add(b.lo);
  add(b.hi);
}

}  // namespace blysk
