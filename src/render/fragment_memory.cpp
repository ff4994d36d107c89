#include "render/fragment_memory.h"

#include <algorithm>

#include "antialias/carpenter.h"
#include "antialias/memory_bits.h"
#include "antialias/sample_tile.h"
#include "geometry/bins.h"

namespace blysk {
namespace {

using antialias::Fragment;

// Where every pixel has room for as many.
FragmentMemory fixed_memory(const ListPlan& plan, std::uint64_t pixels, std::uint64_t most) {
  FragmentMemory m;
  m.paper_main_bits = antialias::fixed_bits({.pixels = pixels, .main = most, .samples = plan.pattern->count});
  m.main_bytes = pixels * most * sizeof(Fragment);
  return m;
}

// An address leads into the pool of the pixel's own tile. Ours has 32 bits, and a length of 8 is kept.
FragmentMemory pool_memory(const ListPlan& plan, std::uint64_t pixels, std::uint64_t pools) {
  FragmentMemory m;
  const std::uint64_t fragment = antialias::fragment_bits(plan.pattern->count);
  m.paper_main_bits = pixels * (plan.main * fragment + plan.extra * antialias::address_bits(plan.pool));
  m.paper_common_bits = pools * plan.pool * fragment;
  m.main_bytes = pixels * (plan.main * sizeof(Fragment) + plan.extra * sizeof(std::uint32_t) + 1);
  m.common_bytes = pools * plan.pool * sizeof(Fragment);
  m.pools = pools;
  m.pool_slots = plan.pool;
  return m;
}

}  // namespace

FragmentMemory fragment_memory(const ListPlan& plan, PictureSize size, const antialias::ListStatistics& lists,
                               std::uint64_t fullest_pool) {
  const auto tiles = [](int side) { return static_cast<std::uint64_t>((side + kTileSize - 1) / kTileSize); };
  const std::uint64_t pixels =
      static_cast<std::uint64_t>(size.width) * static_cast<std::uint64_t>(size.height);
  const std::uint64_t fullest = std::max<std::uint64_t>(lists.most_live, 1);
  FragmentMemory m;
  switch (plan.kind) {
    case ListPlan::Kind::none:
      break;
    case ListPlan::Kind::lists:
      return fixed_memory(plan, pixels, plan.most != 0 ? plan.most : fullest);
    case ListPlan::Kind::carpenter:
      m.main_bytes = pixels * fullest * sizeof(antialias::CarpenterFragment);
      break;
    case ListPlan::Kind::pool:
      // With 32 samples a tile holds half as many pixels (render/list_tile.h).
      m = pool_memory(
          plan, pixels,
          tiles(size.width * static_cast<int>(plan.pattern->count) / kSamples) * tiles(size.height));
      m.pool_peak = lists.pool_peak;
      m.fullest_pool_peak = fullest_pool;
      break;
  }
  return m;
}

}  // namespace blysk
