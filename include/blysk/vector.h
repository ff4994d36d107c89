// blysk/vector.h - small vectors, matrices and boxes of the public API.
//
// Column vectors; matrices multiply from the left; right-handed, +Y up (docs/conventions).
#pragma once

#include <cmath>

namespace blysk {

template <class T>
struct Vec2 {
  T x{}, y{};
  friend constexpr bool operator==(const Vec2&, const Vec2&) = default;
};

template <class T>
struct Vec3 {
  T x{}, y{}, z{};

  friend constexpr Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend constexpr Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend constexpr Vec3 operator-(Vec3 a) { return {-a.x, -a.y, -a.z}; }
  friend constexpr Vec3 operator*(Vec3 a, T s) { return {a.x * s, a.y * s, a.z * s}; }
  friend constexpr Vec3 operator*(T s, Vec3 a) { return a * s; }
  friend constexpr bool operator==(const Vec3&, const Vec3&) = default;
};

template <class T>
struct Vec4 {
  T x{}, y{}, z{}, w{};
  friend constexpr bool operator==(const Vec4&, const Vec4&) = default;
};

using Vec2f = Vec2<float>;
using Vec3f = Vec3<float>;
using Vec4f = Vec4<float>;
using Vec3d = Vec3<double>;
using Vec4d = Vec4<double>;

template <class T>
constexpr T dot(Vec3<T> a, Vec3<T> b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class T>
constexpr Vec3<T> cross(Vec3<T> a, Vec3<T> b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class T>
T length(Vec3<T> a) {
  using std::sqrt;
  return sqrt(dot(a, a));
}

/// Unit vector along `a`; `fallback` where `a` is zero or not finite.
template <class T>
Vec3<T> normalize(Vec3<T> a, Vec3<T> fallback = {0, 0, 1}) {
  const T l = length(a);
  return l > T(0) && l <= T(1e30) ? a * (T(1) / l) : fallback;
}

inline Vec3d to_double(Vec3f a) {
  return {static_cast<double>(a.x), static_cast<double>(a.y), static_cast<double>(a.z)};
}
inline Vec3f to_float(Vec3d a) {
  return {static_cast<float>(a.x), static_cast<float>(a.y), static_cast<float>(a.z)};
}

/// 4x4 matrix, `m[row][column]`, acting on column vectors.
struct Mat4 {
  double m[4][4] = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};

  friend Mat4 operator*(const Mat4& a, const Mat4& b);
  friend bool operator==(const Mat4&, const Mat4&) = default;
};

[[nodiscard]] Vec4d transform(const Mat4& m, Vec4d v);
[[nodiscard]] Vec3d transform_point(const Mat4& m, Vec3d p);      ///< w = 1, no division
[[nodiscard]] Vec3d transform_direction(const Mat4& m, Vec3d d);  ///< w = 0
[[nodiscard]] double determinant3(const Mat4& m);                 ///< of the upper left 3x3
[[nodiscard]] Mat4 normal_matrix(
    const Mat4& m);  ///< cofactors of the upper left 3x3: carries normals, not scaled

[[nodiscard]] Mat4 translation(Vec3d by);
[[nodiscard]] Mat4 scaling(Vec3d by);
[[nodiscard]] Mat4 rotation(Vec3d axis, double radians);  ///< right-handed about a unit axis
[[nodiscard]] Mat4 rotation_from_quaternion(Vec4d xyzw);  ///< normalised first; identity if zero

/// Axis-aligned box; empty while lo > hi.
struct Bounds {
  Vec3d lo{1e300, 1e300, 1e300};
  Vec3d hi{-1e300, -1e300, -1e300};

  [[nodiscard]] bool empty() const { return lo.x > hi.x; }
  void add(Vec3d p);
  void add(const Bounds& b);
  [[nodiscard]] Vec3d center() const { return (lo + hi) * 0.5; }
  [[nodiscard]] double radius() const { return length(hi - lo) * 0.5; }  ///< of the sphere around the box
};

}  // namespace blysk
