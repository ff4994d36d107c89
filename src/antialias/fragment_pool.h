// antialias/fragment_pool.h - static-dynamic memory: each pixel has a few fragments of its own and a few
// addresses of slots in a pool that a tile's pixels share.
//
// A pixel's list is that of FragmentLists with N_main + N_extra fragments. Its first N_main fragments, the
// nearest, stand in its own places, the others in the pool, so that a list of n takes just
// max(0, n - N_main) slots. A list is edited in a copy (the paper's fragment cache) and written back whole.
// The pool is a tile's: who finds it full depends on nothing outside the tile.
#pragma once

#include <array>

#include "antialias/fragment_tile.h"

namespace blysk::antialias {

struct FragmentPoolOptions {
  const SamplePattern* pattern = &kGrid16;
  std::size_t main = 1;              ///< N_main, at least 1
  std::size_t extra = 2;             ///< N_extra; main + extra <= kMostPooled
  std::size_t pool = 0;              ///< N_pool, slots of this tile
  Overflow overflow = Overflow::m1;  ///< a merging one
  Tie tie = Tie::existing;
};

inline constexpr std::size_t kMostPooled = 32;

class FragmentPool final : public FragmentTile {
 public:
  explicit FragmentPool(const FragmentPoolOptions& options);

  void clear(std::size_t pixels) override;
  void insert(std::size_t pixel, const Fragment& fragment) override;
  [[nodiscard]] Composed compose(std::size_t pixel) override;
  [[nodiscard]] std::size_t live(std::size_t pixel) const override { return sizes_[pixel]; }
  [[nodiscard]] std::size_t bytes() const override;

  /// A copy of a pixel's list, in ascending z.
  [[nodiscard]] std::vector<Fragment> fragments(std::size_t pixel) const;
  [[nodiscard]] std::size_t slots_owned(std::size_t pixel) const { return owned(sizes_[pixel]); }
  [[nodiscard]] std::size_t slots_free() const { return free_count_; }
  /// That every slot is free or belongs to one pixel, and that all counts agree.
  [[nodiscard]] bool sound() const;

 private:
  using Copy = std::array<Fragment, kMostPooled + 1>;

  [[nodiscard]] std::size_t owned(std::size_t size) const {
    return size > options_.main ? size - options_.main : 0;
  }
  [[nodiscard]] std::size_t read(std::size_t pixel, Fragment* to) const;
  void write(std::size_t pixel, const FragmentList& list);
  [[nodiscard]] bool fits(std::size_t pixel, std::size_t size) const {
    return size <= options_.main + options_.extra && owned(size) <= slots_owned(pixel) + free_count_;
  }

  FragmentPoolOptions options_;
  Resolver resolver_;
  std::vector<Fragment> main_;            ///< options_.main a pixel
  std::vector<std::uint32_t> addresses_;  ///< options_.extra a pixel
  std::vector<std::uint8_t> sizes_;
  std::vector<Fragment> slots_;  ///< free ones are linked by their ids, the last freed first
  std::uint32_t first_free_ = 0;
  std::size_t free_count_ = 0;
};

}  // namespace blysk::antialias
