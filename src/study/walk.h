// study/walk.h - a triangle walked row by row and pixel by pixel, as the papers' programs do it.
//
// A walk is what a method does for one triangle from its corners to the diffuse and specular terms of every
// pixel: with Counted numbers it tells the operations, with float it can be timed.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "lighting/lobe_reference.h"
#include "shading/normals_reference.h"
#include "study/counted.h"

namespace blysk::study {

struct PixelRow {
  int y, left, right;  ///< both ends belong to the row

  [[nodiscard]] int steps() const { return right - left; }
};

/// The thesis' average triangle (section 10.1 of the specification): A, B, C from top to bottom, 100 points.
inline constexpr std::array<PixelRow, 13> kAverageRows = {{{0, 0, 0},
                                                           {1, -1, 1},
                                                           {2, -2, 2},
                                                           {3, -3, 2},
                                                           {4, -3, 3},
                                                           {5, -4, 4},
                                                           {6, -5, 5},
                                                           {7, -6, 5},
                                                           {8, -7, 6},
                                                           {9, -5, 7},
                                                           {10, -1, 8},
                                                           {11, 3, 8},
                                                           {12, 7, 9}}};
inline constexpr int kAverageCorners[3][2] = {{0, 0}, {-7, 8}, {9, 12}};
inline constexpr int kAveragePixels = 100;

/// Light and viewer at infinity, so that L and H are constants of the frame.
template <class T>
struct WalkTriangle {
  Vec2<T> corner[3];  ///< from top to bottom
  Vec3<T> normal[3];  ///< unit
  Vec3<T> light, halfway;
  std::span<const PixelRow> rows;
};

inline constexpr int kWalkShininess = 256;  ///< of glossy surfaces in the thesis: eight multiplications

/// The two terms of a pixel, before they are multiplied with colours.
template <class T>
struct Terms {
  T diffuse{}, specular{};

  friend Terms operator+(const Terms& a, const Terms& b) {
    return {a.diffuse + b.diffuse, a.specular + b.specular};
  }
  Terms& operator+=(const Terms& b) { return *this = *this + b; }
};

enum class Step { triangle, row, pixel };

/// Takes the pixels of a walk; begin() says what is done next.
template <class T>
class Pixels {
 public:
  explicit Pixels(std::span<const PixelRow> rows) {
    std::size_t size = 0;
    for (const PixelRow& row : rows) {
      start_.push_back(size);
      size += static_cast<std::size_t>(row.steps()) + 1;
    }
    terms_.resize(size);
  }

  void begin(Step) {}
  /// Pixel `x` of the row's own, from 0.
  void put(std::size_t row, int x, const Terms<T>& terms) {
    terms_[start_[row] + static_cast<std::size_t>(x)] = terms;
  }
  [[nodiscard]] const Terms<T>& at(std::size_t row, int x) const {
    return terms_[start_[row] + static_cast<std::size_t>(x)];
  }
  [[nodiscard]] std::span<const Terms<T>> all() const { return terms_; }

 private:
  std::vector<std::size_t> start_;
  std::vector<Terms<T>> terms_;
};

/// Operations of a walk by step.
struct StepCounts {
  Operations triangle, row, pixel;

  [[nodiscard]] Operations total() const {
    Operations sum = triangle;
    sum += row;
    sum += pixel;
    return sum;
  }
};

class CountedPixels : public Pixels<Counted> {
 public:
  using Pixels::Pixels;

  void begin(Step step) {
    finish();
    step_ = step;
  }
  [[nodiscard]] const StepCounts& counts() {
    finish();
    return counts_;
  }

 private:
  void finish() {
    Operations& sum = step_ == Step::triangle ? counts_.triangle
                      : step_ == Step::row    ? counts_.row
                                              : counts_.pixel;
    sum += operations_so_far() - before_;
    before_ = operations_so_far();
  }

  Step step_ = Step::triangle;
  Operations before_ = operations_so_far();
  StepCounts counts_;
};

/// Light on a surface of unit normal; the diffuse term keeps its sign, so that what is interpolated stays
/// smooth where the light ends (section 4.6 of the specification).
template <class T>
Terms<T> light_unit(const WalkTriangle<T>& t, const Vec3<T>& normal) {
  return {dot(normal, t.light),
          reference::fixed_power<kWalkShininess>(std::max(T(0), dot(normal, t.halfway)))};
}

enum class Lit { diffuse, both };

/// The same of a normal whose length is off by `inverse_length`; what a pixel shows.
template <Lit kLit = Lit::both, class T>
Terms<T> light_scaled(const WalkTriangle<T>& t, const Vec3<T>& normal, const T& inverse_length) {
  if constexpr (kLit == Lit::diffuse) return {std::max(T(0), dot(normal, t.light) * inverse_length), T(0)};
  return {std::max(T(0), dot(normal, t.light) * inverse_length),
          reference::fixed_power<kWalkShininess>(std::max(T(0), dot(normal, t.halfway) * inverse_length))};
}

template <class T>
Terms<T> clamped(const Terms<T>& terms) {
  return {std::max(T(0), terms.diffuse), std::max(T(0), terms.specular)};
}

template <class T>
T row_number(int value) {
  return input<T>(value);
}

/// Every row in turn: what `walk` does before it begins its pixels is the row's.
template <class T, class Out, class Walk>
void each_row(const WalkTriangle<T>& t, Out& out, const Walk& walk) {
  for (std::size_t r = 0; r < t.rows.size(); ++r) {
    out.begin(Step::row);
    walk(r, t.rows[r]);
  }
}

/// What is linear on the screen, at a row's first and last pixel.
template <class T>
Vec3<T> at_left(const reference::LinearNormalsOf<T>& n, const PixelRow& row) {
  return n.at(row_number<T>(row.left), row_number<T>(row.y));
}
template <class T>
Vec3<T> at_right(const reference::LinearNormalsOf<T>& n, const PixelRow& row) {
  return n.at(row_number<T>(row.right), row_number<T>(row.y));
}

}  // namespace blysk::study
