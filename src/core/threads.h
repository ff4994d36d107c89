// core/threads.h - one small pool: the caller and its helpers take the items of a loop in order.
#pragma once

#include <cstddef>
#include <memory>

namespace blysk {

/// Number of processors this process may run on, at least 1.
int processor_count();

/// Threads that wait for loops. A pool of one runs everything in the caller. Not for concurrent use.
class ThreadPool {
 public:
  explicit ThreadPool(int threads);  ///< 0: processor_count()
  ~ThreadPool();
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;

  [[nodiscard]] int size() const;

  /// Calls work(worker, item) for every item in 0..items-1, worker in 0..size()-1. Each worker sees its
  /// items in ascending order. Returns when all are done; then throws the first exception that `work` threw.
  template <class Work>
  void for_each(std::size_t items, const Work& work) {
    // By address: a std::function of a large lambda would allocate in every loop of every frame.
    run(items, &work,
        [](const void* w, int worker, std::size_t item) { (*static_cast<const Work*>(w))(worker, item); });
  }

 private:
  using Call = void (*)(const void* work, int worker, std::size_t item);
  void run(std::size_t items, const void* work, Call call);

  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace blysk
