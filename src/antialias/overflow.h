// antialias/overflow.h - what happens to a list of fragments that has grown too long.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "antialias/fragment.h"
#include "antialias/merge.h"
#include "blysk/vector.h"

namespace blysk::antialias {

enum class Overflow : std::uint8_t {
  unlimited,  ///< lists grow; opaque ones stop at the number of samples by themselves
  d1,         ///< drop the farthest
  d2,         ///< drop the one with the fewest samples
  d3,         ///< as d1; the pixel shows all that there was at its last insertion, before the drop
  d4,         ///< as d2, shown as d3
  d5,         ///< as d1; what is left counts as the whole pixel
  m0,         ///< merge the two farthest, by the paper's formulas as printed
  m1,         ///< the same, corrected
  m2,         ///< the two farthest, least-squares plane
  m3,         ///< neighbours in depth, slopes of the larger (as Z3)
  m4,         ///< neighbours in depth, least-squares plane
  m5          ///< the pair that loses least depth (Ward), least-squares plane
};

inline constexpr Overflow kOverflows[] = {Overflow::unlimited, Overflow::d1, Overflow::d2, Overflow::d3,
                                          Overflow::d4,        Overflow::d5, Overflow::m0, Overflow::m1,
                                          Overflow::m2,        Overflow::m3, Overflow::m4, Overflow::m5};

[[nodiscard]] std::string_view overflow_name(Overflow overflow);  ///< "unlimited", "d1", ...
[[nodiscard]] std::optional<Overflow> overflow_of(std::string_view name);

[[nodiscard]] constexpr bool discards(Overflow o) { return o >= Overflow::d1 && o <= Overflow::d5; }
[[nodiscard]] constexpr bool merges(Overflow o) { return o >= Overflow::m0; }

/// A list under edit: fragments in ascending z. The memory behind it has room for one more.
struct FragmentList {
  Fragment* at;
  std::size_t size;

  void erase(std::size_t i);
  /// After all that are at the same depth or nearer.
  void place(const Fragment& f);
};

/// Gives colours late: to fragments that are merged or shown, and to no others.
class Colours {
 public:
  virtual ~Colours() = default;
  [[nodiscard]] virtual Vec3f colour(std::size_t pixel, const Fragment& fragment) = 0;

  void light(std::size_t pixel, Fragment& fragment) {
    if (!fragment.lit) fragment.rgb = colour(pixel, fragment);
    fragment.lit = true;
  }
};

/// The entry that a discarding policy drops.
[[nodiscard]] std::size_t victim(const FragmentList& list, Overflow policy);

/// The pair i < j that a merging policy makes one of. Pairs of two opaque or two transparent fragments go
/// first in m3 to m5: a mixed one would no longer hide what comes later.
struct Pair {
  std::size_t near, far;
};
[[nodiscard]] Pair pair_to_merge(const FragmentList& list, Overflow policy, const SamplePattern& pattern);

/// Replaces that pair by one fragment. `colours` may be null where all are lit.
void merge_two(FragmentList& list, Overflow policy, const SamplePattern& pattern, std::size_t pixel,
               Colours* colours);

}  // namespace blysk::antialias
