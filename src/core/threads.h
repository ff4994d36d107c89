// core/threads.h - one small pool: the caller and its helpers take the items of a loop in order.
#pragma once

#include <cstddef>
#include <functional>
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
  void for_each(std::size_t items, const std::function<void(int worker, std::size_t item)>& work);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace blysk
