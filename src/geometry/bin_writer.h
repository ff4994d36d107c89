// geometry/bin_writer.h - appending to a list, inlined into each instruction set's kernels.
#pragma once

#include "geometry/bins.h"
#include "simd/lanes.h"

namespace blysk::BLYSK_ISA {

template <class Entry>
BLYSK_INLINE void append(ThreadBins& bins, Bin& bin, const Entry& entry) {
  if (__builtin_expect(static_cast<std::size_t>(bin.end - bin.cursor) < sizeof(Entry), 0))
    grow_bin(bins, bin);
  *reinterpret_cast<Entry*>(bin.cursor) = entry;  // an array of bytes makes its objects by itself
  bin.cursor += sizeof(Entry);
}

/// Calls visit(entry) for every entry of a list.
template <class Entry, class Visit>
BLYSK_INLINE void for_each_entry(const Bin& bin, Visit visit) {
  for (const BinBlock* block = bin.first; block != nullptr; block = block->next) {
    // Blocks lie apart: what fetches ahead by itself does not see the next one coming.
    const BinBlock* next = block->next != nullptr ? block->next : block;
    const std::ptrdiff_t ahead =
        reinterpret_cast<const std::byte*>(next) - reinterpret_cast<const std::byte*>(block);
    const std::byte* end = block == bin.last ? bin.cursor : block->entries + block->used;
    for (const std::byte* at = block->entries; at != end; at += sizeof(Entry)) {
      __builtin_prefetch(at + ahead);
      visit(*reinterpret_cast<const Entry*>(at));
    }
  }
}

}  // namespace blysk::BLYSK_ISA
