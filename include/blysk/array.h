// blysk/array.h - std::vector for large plain data: resizing leaves new elements unwritten.
//
// First touch of memory is the slowest thing a loader does, so large blocks are aligned for huge
// pages and are not filled before they are filled.
#pragma once

#include <cstddef>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace blysk {

/// Memory for `bytes` bytes, aligned to 64; throws std::bad_alloc. Large blocks ask for huge pages.
void* allocate_bytes(std::size_t bytes);
void free_bytes(void* memory, std::size_t bytes) noexcept;

template <class T>
struct PlainAllocator {
  using value_type = T;
  PlainAllocator() = default;
  template <class U>
  PlainAllocator(const PlainAllocator<U>&) noexcept {}  // NOLINT(google-explicit-constructor)

  T* allocate(std::size_t count) { return static_cast<T*>(allocate_bytes(count * sizeof(T))); }
  void deallocate(T* memory, std::size_t count) noexcept { free_bytes(memory, count * sizeof(T)); }

  template <class U>
  void construct(U*) noexcept {
    static_assert(std::is_trivially_copyable_v<U>);
  }
  template <class U, class... Args>
  void construct(U* at, Args&&... args) {
    ::new (static_cast<void*>(at)) U(std::forward<Args>(args)...);
  }
  friend bool operator==(const PlainAllocator&, const PlainAllocator&) { return true; }
};

/// `resize(n)` leaves new elements indeterminate; `resize(n, value)` and `assign` fill them.
template <class T>
using Array = std::vector<T, PlainAllocator<T>>;

}  // namespace blysk
