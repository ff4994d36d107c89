// geometry/bin_writer.h - appending to a list, inlined into each instruction set's kernels.
#pragma once

#include <cstring>

#include "geometry/bins.h"
#include "simd/lanes.h"

namespace blysk::BLYSK_ISA {

template <class Entry>
BLYSK_INLINE void append(ThreadBins& bins, Bin& bin, const Entry& entry) {
  if (__builtin_expect(static_cast<std::size_t>(bin.end - bin.cursor) < sizeof(Entry), 0)) grow_bin(bins, bin);
  std::memcpy(bin.cursor, &entry, sizeof(Entry));
  bin.cursor += sizeof(Entry);
}

/// Calls visit(entry) for every entry of a list.
template <class Entry, class Visit>
BLYSK_INLINE void for_each_entry(const Bin& bin, Visit visit) {
  for (const BinBlock* block = bin.first; block != nullptr; block = block->next) {
    const std::byte* end = block == bin.last ? bin.cursor : block->entries + block->used;
    for (const std::byte* at = block->entries; at != end; at += sizeof(Entry)) {
      Entry entry;
      std::memcpy(&entry, at, sizeof(Entry));
      visit(entry);
    }
  }
}

}  // namespace blysk::BLYSK_ISA
