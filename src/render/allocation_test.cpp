// A steady frame allocates nothing. This file counts the whole test program's calls of operator new.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "blysk/shapes.h"
#include "render/testing.h"

namespace {

std::atomic<long> allocations{0};

void* counted(std::size_t bytes, std::size_t alignment) {
  allocations.fetch_add(1, std::memory_order_relaxed);
  void* memory = alignment == 0
                     ? std::malloc(bytes)
                     : std::aligned_alloc(alignment, (bytes + alignment - 1) / alignment * alignment);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

// Not inlined: compilers warn of memory from new that they see freed.
__attribute__((noinline)) void release(void* memory) { std::free(memory); }

}  // namespace

void* operator new(std::size_t bytes) { return counted(bytes, 0); }
void* operator new(std::size_t bytes, std::align_val_t alignment) {
  return counted(bytes, static_cast<std::size_t>(alignment));
}
void operator delete(void* memory) noexcept { release(memory); }
void operator delete(void* memory, std::size_t) noexcept { release(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { release(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { release(memory); }

namespace blysk {
namespace {

TEST(renderer, a_steady_frame_allocates_nothing) {
  Scene scene = std::move(*make_shape("teapot"));
  scene.append(std::move(*make_shape("terrain?detail=60")));
  // One thread: which of several gets which triangles differs from frame to frame, and with it how far their
  // lists grow.
  constexpr int kThreads = 1;
  for (const char* shading : {"phong", "gouraud", "flat"}) {
    RenderOptions o;
    o.width = 320;
    o.height = 200;
    o.shading = shading;
    o.want_depth = o.want_normal = o.want_id = true;
    o.camera.emplace();
    o.camera->eye = {1, 2, 3};
    Renderer renderer({.threads = kThreads});
    Frame frame;
    for (int i = 0; i < 3; ++i) ASSERT_TRUE(renderer.render(scene, o, frame));
    const auto* pixels = frame.image.pixels.data();
    const auto* depths = frame.depth.values.data();
    const auto* normals = frame.normal.values.data();
    const auto* ids = frame.id.data();
    const std::uint64_t held = frame.statistics.memory_bytes;
    const long before = allocations.load();
    for (int i = 0; i < 5; ++i) {
      if (!renderer.render(scene, o, frame)) std::abort();
    }
    EXPECT_EQ(allocations.load() - before, 0) << shading;
    EXPECT_EQ(frame.image.pixels.data(), pixels);
    EXPECT_EQ(frame.depth.values.data(), depths);
    EXPECT_EQ(frame.normal.values.data(), normals);
    EXPECT_EQ(frame.id.data(), ids);
    EXPECT_EQ(frame.statistics.memory_bytes, held);
  }
}

}  // namespace
}  // namespace blysk
