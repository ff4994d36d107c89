#include "render/sample_memory.h"

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

void SampleMemory::prepare(bool glass) {
  counts_ = {};
  // Not cleared: most of it may never be touched.
  if (!buffers_) {
    buffers_ = std::make_unique_for_overwrite<SampleBuffers>();
    take_fragments(SampleBuffers::kMostFragments);
  }
  if (glass && !glass_) {
    glass_ = std::make_unique_for_overwrite<GlassBuffers>();
    take_fragments(SampleBuffers::kMostFragments + kMostGlass);
  }
}

void SampleMemory::take_fragments(std::size_t most) {
  const std::size_t room = most + SampleBuffers::kPadding;
  fragment_words_ = 4 * room;
  fragments_ = std::make_unique_for_overwrite<std::uint32_t[]>(fragment_words_);
  buffers_->fragment_id = reinterpret_cast<std::int32_t*>(fragments_.get());
  buffers_->fragment_place = reinterpret_cast<std::int32_t*>(fragments_.get() + room);
  buffers_->fragment_nearness = reinterpret_cast<float*>(fragments_.get() + 2 * room);
  buffers_->fragment_weight = reinterpret_cast<float*>(fragments_.get() + 3 * room);
}

// In ascending order of ids, whichever thread has which.
void SampleMemory::gather_glass(const FramePlan& plan, const TileJob& job) {
  entries_.clear();
  for (int i = 0; i < job.bins_count; ++i) {
    const Bin* bins = job.bins[i];
    for_each<SmallEntry>(bins[bin_index(job.tile, Stream::glass_small)], [&](const SmallEntry& e) {
      entries_.push_back({large_entry(e, job.vertices), 0});
    });
    for_each<LargeEntry>(bins[bin_index(job.tile, Stream::glass_large)], [&](const LargeEntry& e) {
      entries_.push_back({e, 0});
    });
  }
  std::sort(entries_.begin(), entries_.end(),
            [](const GlassEntry& a, const GlassEntry& b) { return order_of(a) < order_of(b); });
  std::size_t draw = 0;
  for (GlassEntry& e : entries_) {
    while (e.triangle.id - plan.draws[draw].draw.id_base >= plan.draws[draw].draw.id_count) ++draw;
    e.opacity = plan.draws[draw].opacity;
  }
}

int SampleMemory::rasterize(const Kernels& table, const FramePlan& plan, const TileJob& job) {
  const Vec4f& b = plan.linear_background;
  SampleJob samples{job, buffers_.get(), nullptr, nullptr, 0, {b.x, b.y, b.z, b.w}, plan.want_nearness};
  if (plan.glass) gather_glass(plan, job);
  if (plan.glass && !entries_.empty()) {
    samples.glass = glass_.get();
    samples.glass_entries = entries_.data();
    samples.glass_count = entries_.size();
  }
  const int covered = table.rasterize_samples(samples);
  counts_.fragments += static_cast<std::uint64_t>(buffers_->fragments);
  counts_.shared_pixels += static_cast<std::uint64_t>(buffers_->pixels);
  if (samples.glass != nullptr) {
    counts_.layers += glass_->generated;
    counts_.merged_layers += glass_->merges;
    counts_.merged_pixels +=
        static_cast<std::uint64_t>(std::count(std::begin(glass_->merged), std::end(glass_->merged), 1));
  }
  return covered;
}

void SampleMemory::show_nearest(TileBuffers& pixels) const {
  for (int i = 0; i < buffers_->pixels; ++i) {
    const int at = buffers_->pixel[i];
    const auto& [nearness, id] = buffers_->open[SampleBuffers::place_of(at)];
    int best = 0;
    for (int s = 1; s < kSamples; ++s) {
      if (nearness[s] > nearness[best] || (nearness[s] == nearness[best] && id[s] < id[best])) best = s;
    }
    pixels.nearness[at] = std::clamp(nearness[best], 0.0f, 1.0f);
    pixels.id[at] = id[best] == kNoSurface ? kNoTriangle : static_cast<std::uint32_t>(id[best]);
  }
}

std::size_t SampleMemory::bytes() const {
  return (buffers_ ? sizeof *buffers_ : 0) + (glass_ ? sizeof *glass_ : 0) +
         fragment_words_ * sizeof(std::uint32_t) + entries_.capacity() * sizeof(GlassEntry);
}

}  // namespace blysk
