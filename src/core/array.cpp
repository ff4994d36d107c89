#include "blysk/array.h"

#include <sys/mman.h>

#include <cstdlib>

namespace blysk {
namespace {
constexpr std::size_t kHugePage = std::size_t{2} << 20;
constexpr std::size_t kSmallAlignment = 64;
// Kernels fetch three floats as four.
constexpr std::size_t kReadPast = 16;
}  // namespace

void* allocate_bytes(std::size_t bytes) {
  const std::size_t alignment = bytes >= kHugePage ? kHugePage : kSmallAlignment;
  const std::size_t rounded = (bytes + kReadPast + alignment - 1) / alignment * alignment;
  if (rounded < bytes) throw std::bad_alloc();
  void* memory = std::aligned_alloc(alignment, rounded);
  if (memory == nullptr) throw std::bad_alloc();
  // A fault a 4 KB page costs several times what the page's use does.
  if (alignment == kHugePage) madvise(memory, rounded, MADV_HUGEPAGE);
  return memory;
}

void free_bytes(void* memory, std::size_t) noexcept { std::free(memory); }

}  // namespace blysk
