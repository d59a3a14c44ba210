// A fixed number of threads that work off tasks.
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <future>
#include <mutex>
#include <thread>
#include <vector>

namespace adit::tools {

class WorkerPool {
 public:
  explicit WorkerPool(int workers);
  /// Tasks that have not begun are dropped.
  ~WorkerPool();
  WorkerPool(const WorkerPool&) = delete;
  WorkerPool& operator=(const WorkerPool&) = delete;

  /// @param task  gets the number of the worker that runs it, 0 to workers - 1. What it throws comes out of the
  ///              future.
  std::future<void> submit(std::function<void(int)> task);

 private:
  void work(int worker);

  std::mutex mutex_;
  std::condition_variable wake_;
  std::deque<std::packaged_task<void(int)>> tasks_;
  bool ending_ = false;
  std::vector<std::thread> threads_;
};

}  // namespace adit::tools
