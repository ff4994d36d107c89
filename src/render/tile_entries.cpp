#include "render/tile_entries.h"

#include <algorithm>
#include <tuple>

#include "geometry/bins.h"

namespace blysk {
namespace {

template <class Entry, class Visit>
void for_each(const Bin& bin, Visit visit) {
  for (const BinBlock* block = bin.first; block != nullptr; block = block->next) {
    const std::byte* end = block == bin.last ? bin.cursor : block->entries + block->used;
    for (const std::byte* at = block->entries; at != end; at += sizeof(Entry)) {
      visit(*reinterpret_cast<const Entry*>(at));
    }
  }
}

LargeEntry large_entry(const SmallEntry& small, const ScreenVertex* vertices) {
  LargeEntry e{small.id, {}, {}, {}};
  for (int k = 0; k < 3; ++k) {
    const ScreenVertex& v = vertices[small.vertex[k]];
    e.x[k] = v.x;
    e.y[k] = v.y;
    e.nearness[k] = v.nearness;
  }
  return e;
}

// Pieces of one clipped triangle have one id.
auto order_of(const GlassEntry& e) {
  const LargeEntry& t = e.triangle;
  return std::make_tuple(t.id, t.x[0], t.y[0], t.x[1], t.y[1], t.x[2], t.y[2]);
}

}  // namespace

void gather_entries(const FramePlan& plan, const TileJob& job, std::span<const Stream> streams,
                    std::vector<GlassEntry>& to) {
  to.clear();
  for (int i = 0; i < job.bins_count; ++i) {
    for (const Stream stream : streams) {
      const Bin& bin = job.bins[i][bin_index(job.tile, stream)];
      if (stream == Stream::large || stream == Stream::glass_large) {
        for_each<LargeEntry>(bin, [&](const LargeEntry& e) { to.push_back({e, 0, nullptr}); });
      } else {
        for_each<SmallEntry>(bin, [&](const SmallEntry& e) {
          to.push_back({large_entry(e, job.vertices), 0, nullptr});
        });
      }
    }
  }
  std::sort(to.begin(), to.end(),
            [](const GlassEntry& a, const GlassEntry& b) { return order_of(a) < order_of(b); });
  std::size_t draw = 0;
  for (GlassEntry& e : to) {
    while (e.triangle.id - plan.draws[draw].draw.id_base >= plan.draws[draw].draw.id_count) ++draw;
    e.opacity = plan.draws[draw].opacity;
    e.varying = plan.draws[draw].varies ? &plan.draws[draw].varying : nullptr;
  }
}

void count_dots(const TileJob& job, std::uint32_t* counts) {
  for (int i = 0; i < job.bins_count; ++i) {
    for_each<DotEntry>(job.bins[i][bin_index(job.tile, Stream::dot)],
                       [&](const DotEntry& e) { ++counts[e.at]; });
  }
}

}  // namespace blysk
