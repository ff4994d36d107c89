#include "geometry/bins.h"

#include <new>

namespace blysk {

void ThreadBins::reset(std::size_t tiles, std::size_t max_bytes) {
  bins_.assign(tiles * kStreams, Bin{});
  used_blocks_ = 0;
  max_blocks_ = max_bytes / sizeof(BinBlock);
}

Bin* ThreadBins::bins() { return bins_.data(); }

void ThreadBins::grow(Bin& bin) {
  if (used_blocks_ >= max_blocks_) throw std::bad_alloc();
  const std::size_t chunk = used_blocks_ / kChunkBlocks;
  if (chunk == chunks_.size()) chunks_.push_back(std::make_unique_for_overwrite<BinBlock[]>(kChunkBlocks));
  BinBlock* block = &chunks_[chunk][used_blocks_ % kChunkBlocks];
  ++used_blocks_;
  block->next = nullptr;
  if (bin.last != nullptr) {
    bin.last->used = static_cast<std::size_t>(bin.cursor - bin.last->entries);
    bin.last->next = block;
  } else {
    bin.first = block;
  }
  bin.last = block;
  bin.cursor = block->entries;
  bin.end = block->entries + sizeof block->entries;
}

std::size_t ThreadBins::memory() const {
  return bins_.capacity() * sizeof(Bin) + chunks_.size() * kChunkBlocks * sizeof(BinBlock);
}

void grow_bin(ThreadBins& bins, Bin& bin) { bins.grow(bin); }

}  // namespace blysk
