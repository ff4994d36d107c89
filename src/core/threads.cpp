#include "core/threads.h"

#include <sched.h>

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace blysk {

int processor_count() {
  cpu_set_t set;
  if (sched_getaffinity(0, sizeof set, &set) == 0) return std::max(1, CPU_COUNT(&set));
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

struct ThreadPool::State {
  std::vector<std::thread> helpers;
  std::mutex mutex;
  std::condition_variable wake;
  const void* work = nullptr;  // with call and items: guarded by generation
  Call call = nullptr;
  std::size_t items = 0;
  std::atomic<std::size_t> next{0};
  std::atomic<int> busy{0};
  std::atomic<std::uint64_t> generation{0};
  std::atomic<bool> stop{false};
  std::exception_ptr thrown;  // the first of a loop, guarded by mutex
  int spins = 0;

  void drain(int worker) {
    for (;;) {
      const std::size_t item = next.fetch_add(1, std::memory_order_relaxed);
      if (item >= items) return;
      try {
        call(work, worker, item);
      } catch (...) {
        const std::lock_guard lock(mutex);
        if (!thrown) thrown = std::current_exception();
      }
    }
  }

  // A frame is a few loops of a millisecond: waking a sleeper between them would cost more than looking
  // for a while, as long as there is a processor to look with.
  void help(int worker) {
    std::uint64_t seen = 0;
    for (;;) {
      for (int i = 0; i < spins && generation.load(std::memory_order_acquire) == seen && !stop; ++i) {
        pause();
      }
      if (generation.load(std::memory_order_acquire) == seen) {
        std::unique_lock lock(mutex);
        wake.wait(lock, [&] { return stop || generation.load(std::memory_order_acquire) != seen; });
      }
      if (stop) return;
      seen = generation.load(std::memory_order_acquire);
      drain(worker);
      busy.fetch_sub(1, std::memory_order_release);
    }
  }

  static void pause();
};

void ThreadPool::State::pause() {
#if defined(__x86_64__)
  __builtin_ia32_pause();
#else
  std::this_thread::yield();
#endif
}

ThreadPool::ThreadPool(int threads) : state_(std::make_unique<State>()) {
  const int count = threads > 0 ? threads : processor_count();
  state_->spins = count <= processor_count() ? 2000 : 0;
  for (int worker = 1; worker < count; ++worker) {
    state_->helpers.emplace_back([s = state_.get(), worker] { s->help(worker); });
  }
}

ThreadPool::~ThreadPool() {
  {
    std::lock_guard lock(state_->mutex);
    state_->stop = true;
  }
  state_->wake.notify_all();
  for (std::thread& t : state_->helpers) t.join();
}

int ThreadPool::size() const { return static_cast<int>(state_->helpers.size()) + 1; }

void ThreadPool::run(std::size_t items, const void* work, Call call) {
  State& s = *state_;
  if (s.helpers.empty() || items <= 1) {
    for (std::size_t i = 0; i < items; ++i) call(work, 0, i);
    return;
  }
  s.work = work;
  s.call = call;
  s.items = items;
  s.next.store(0, std::memory_order_relaxed);
  s.busy.store(static_cast<int>(s.helpers.size()), std::memory_order_relaxed);
  {
    std::lock_guard lock(s.mutex);
    s.generation.fetch_add(1, std::memory_order_release);
  }
  s.wake.notify_all();
  s.drain(0);
  while (s.busy.load(std::memory_order_acquire) != 0) std::this_thread::yield();
  if (s.thrown) std::rethrow_exception(std::exchange(s.thrown, nullptr));
}

}  // namespace blysk
