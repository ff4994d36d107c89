// study/operations.h - what each method does for the average triangle, counted and timed.
#pragma once

#include <span>
#include <string_view>

#include "shading/quadratic_reference.h"
#include "study/walk.h"

namespace blysk::study {

using reference::QuadraticForm;

/// One method's program for a triangle, in every number type that it is run with.
struct Walk {
  std::string_view name;
  std::string_view method;  ///< of the registry
  std::string_view title;
  void (*count)(const WalkTriangle<Counted>&, CountedPixels&);
  void (*run)(const WalkTriangle<float>&, Pixels<float>&);
  void (*run_exactly)(const WalkTriangle<double>&, Pixels<double>&);
};

/// Phong shading first.
[[nodiscard]] std::span<const Walk> walks();
[[nodiscard]] const Walk& find_walk(std::string_view name);  ///< must exist

/// The average triangle with corner normals up to 20 degrees apart; `turn` 0..1 tilts it.
template <class T>
[[nodiscard]] WalkTriangle<T> average_triangle(double turn = 0);

[[nodiscard]] StepCounts count_operations(const Walk& walk);
/// The pixel loop alone: two pixels in the middle of a row.
[[nodiscard]] Operations count_two_pixels(const Walk& walk);

/// A row of n pixels.
[[nodiscard]] Operations count_row(QuadraticForm form, std::size_t pixels);

/// One vector made unit: by the root, and by the paper's polynomial from its squared length, which is found
/// anew or known from the pixel before.
enum class Normalisation { root, three_divisions, polynomial, recurrence };
[[nodiscard]] Operations count_normalisation(Normalisation way);

/// The unit vectors of two pixels of a row: each interpolated and divided by its length, or one by the
/// polynomial and one half the sum of its neighbours.
enum class UnitVectors { classical, combined };
[[nodiscard]] Operations count_unit_vectors(UnitVectors way);

/// The specular lobe at a cosine, shininess 50.
enum class CountedLobe { power, schlick, w16 };
[[nodiscard]] Operations count_lobe(CountedLobe lobe);

}  // namespace blysk::study
