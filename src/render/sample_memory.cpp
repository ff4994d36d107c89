#include "render/sample_memory.h"

#include <algorithm>

#include "render/tile_entries.h"

namespace blysk {
void SampleMemory::prepare(bool glass) {
  counts_ = {};
  // Not cleared: most of it may never be touched.
  if (!buffers_) {
    buffers_ = std::make_unique_for_overwrite<SampleBuffers>();
    take_fragments(SampleBuffers::kMostFragments);
  }
  if (glass && !glass_) {
    glass_ = std::make_unique_for_overwrite<GlassBuffers>();
    take_fragments(SampleBuffers::kMostFragments + kMostGlass + kTilePixels * kMostParts);
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

void SampleMemory::gather_glass(const FramePlan& plan, const TileJob& job) {
  constexpr Stream kGlass[] = {Stream::glass_small, Stream::glass_large};
  gather_entries(plan, job, kGlass, entries_);
}

int SampleMemory::rasterize(const Kernels& table, const FramePlan& plan, const TileJob& job) {
  const Vec4f& b = plan.linear_background;
  SampleJob samples{job, buffers_.get(), nullptr, nullptr, 0, {b.x, b.y, b.z, b.w}, plan.want_nearness};
  if (plan.glass) gather_glass(plan, job);
  has_glass_ = plan.glass && !entries_.empty();
  if (has_glass_) {
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

void SampleMemory::count(const TileBuffers& pixels, TileCounts& counts) const {
  count_centers(pixels, counts);  // right where one surface has the pixel
  for (int i = 0; i < buffers_->pixels; ++i) {
    const int at = buffers_->pixel[i];
    const PixelSamples& samples = buffers_->open[SampleBuffers::place_of(at)];
    std::uint32_t covered = 0;
    for (int s = 0; s < kSamples; ++s) covered |= (samples.id[s] != kNoSurface ? 1u : 0u) << s;
    for (std::int32_t l = has_glass_ ? glass_->first[at] : -1; l >= 0; l = glass_->layer[l].next) {
      covered |= glass_->layer[l].mask;
    }
    counts.covered[at] = covered;
    counts.live[at] = 0;
  }
  for (int i = 0; i < buffers_->fragments; ++i) {
    ++counts.live[buffers_->fragment_place[i] & (kTilePixels - 1)];
  }
}

std::size_t SampleMemory::bytes() const {
  return (buffers_ ? sizeof *buffers_ : 0) + (glass_ ? sizeof *glass_ : 0) +
         fragment_words_ * sizeof(std::uint32_t) + entries_.capacity() * sizeof(GlassEntry);
}

}  // namespace blysk
