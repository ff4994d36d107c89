// study/flat_raster.h - flat-coloured triangles on the screen, drawn with any variant of the A-buffer: the
// simulation program that the variants are compared in.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "antialias/fragment_tile.h"
#include "antialias/sample_patterns.h"
#include "blysk/vector.h"
#include "core/threads.h"

namespace blysk::study {

/// Corners in pixels, x right and y down, z 0 near to 1 far; within 2^15 pixels of the picture's corner.
struct FlatTriangle {
  std::array<Vec3d, 3> corners;
  Vec3f rgb;  ///< 0..255
  float alpha = 1;
  std::uint32_t object = 0;
};

enum class Order {
  given,
  random,  ///< a permutation drawn with a seed
  front_to_back,
  back_to_front  ///< both by the mean depth of the corners, equal ones as given
};
[[nodiscard]] std::string_view order_name(Order order);

/// Indices of triangles in the order in which they are submitted.
[[nodiscard]] std::vector<std::uint32_t> submission_order(std::span<const FlatTriangle> triangles,
                                                          Order order, std::uint64_t seed);

/// A rectangle of pixels.
struct Region {
  int left = 0, top = 0, width = 0, height = 0;
  [[nodiscard]] std::size_t pixels() const {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  }
};

/// Everything that triangles contribute to a region, in submission order.
struct FragmentStream {
  std::vector<antialias::Fragment> fragments;  ///< with the place in the order as id
  std::vector<std::uint32_t> pixels;           ///< of each fragment, counted by rows of the region

  void clear() {
    fragments.clear();
    pixels.clear();
  }
  /// Brings all fragments of a pixel together, each pixel's in submission order.
  void sort_by_pixel(std::size_t pixel_count);
  void insert_into(antialias::FragmentTile& tile) const;
};

/// Appends the fragments of triangles, taken in this order.
void rasterise(std::span<const FlatTriangle> triangles, std::span<const std::uint32_t> order,
               const Region& region, const antialias::SamplePattern& pattern, FragmentStream& stream);

struct Variant {
  enum class Kind { lists, pool, carpenter, zbuffer };
  Kind kind = Kind::lists;
  antialias::Overflow overflow = antialias::Overflow::unlimited;
  std::size_t most = 8;             ///< of lists
  std::size_t main = 1, extra = 2;  ///< of a pool
  std::size_t pool = 0;             ///< slots for the whole picture; tiles have their share
  antialias::Tie tie = antialias::Tie::existing;
};

/// The samples that a variant works with where the others work with `pattern`.
[[nodiscard]] const antialias::SamplePattern& samples_of(const Variant& variant,
                                                         const antialias::SamplePattern& pattern);

[[nodiscard]] std::unique_ptr<antialias::FragmentTile> make_tile(const Variant& variant,
                                                                 const antialias::SamplePattern& pattern,
                                                                 std::size_t tile_pixels,
                                                                 std::size_t picture_pixels);

struct DrawOptions {
  int width = 128, height = 128;
  int tile = 64;  ///< pixels a side
  const antialias::SamplePattern* pattern = &antialias::kGrid16;
  Variant variant;
  Order order = Order::given;
  std::uint64_t seed = 1;
  Vec3d background = {32, 32, 64};
};

struct Drawing {
  std::vector<Vec3d> pixels;  ///< not rounded
  std::vector<std::uint32_t> live;
  antialias::ListStatistics statistics;
};

/// Each tile is the work of one thread: the picture and its statistics do not depend on their number.
[[nodiscard]] Drawing draw(std::span<const FlatTriangle> triangles, const DrawOptions& options,
                           ThreadPool& threads);

}  // namespace blysk::study
