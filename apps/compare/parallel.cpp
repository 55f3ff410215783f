#include "apps/compare/parallel.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace lineservo::apps {
namespace {

constexpr auto kWatchPeriod = std::chrono::milliseconds(100);

/// The indices that are left, what is done, and the first failure.
class Queue {
 public:
  explicit Queue(std::size_t count) : count_(count), failures_(count) {}

  void work_off(const std::function<void(std::size_t)>& work) {
    for (std::size_t i = next_++; i < count_ && !stopped_; i = next_++) {
      try {
        work(i);
      } catch (...) {
        failures_[i] = std::current_exception();
        stopped_ = true;
      }
      const std::lock_guard lock(mutex_);
      ++done_;
      changed_.notify_one();
    }
    const std::lock_guard lock(mutex_);
    --workers_;
    changed_.notify_one();
  }

  void watch_over(int workers, const std::function<bool(std::size_t)>& watch) {
    std::unique_lock lock(mutex_);
    workers_ += workers;
    while (workers_ > 0) {
      const std::size_t done = done_;
      lock.unlock();
      if (!watch(done)) stopped_ = true;
      lock.lock();
      if (workers_ > 0 && done_ == done) changed_.wait_for(lock, kWatchPeriod);
    }
  }

  bool finish() const {
    for (const std::exception_ptr& failure : failures_) {
      if (failure) std::rethrow_exception(failure);
    }
    return done_ == count_;
  }

 private:
  const std::size_t count_;
  std::atomic<std::size_t> next_ = 0;
  std::atomic<bool> stopped_ = false;
  std::vector<std::exception_ptr> failures_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::size_t done_ = 0;
  int workers_ = 0;  ///< below zero while some have ended before the watch began
};

}  // namespace

bool for_each_index(std::size_t count, int jobs, const std::function<void(std::size_t)>& work,
                    const std::function<bool(std::size_t)>& watch) {
  Queue queue(count);
  {
    std::vector<std::jthread> threads;
    for (int k = 0; k < jobs; ++k) threads.emplace_back([&] { queue.work_off(work); });
    queue.watch_over(jobs, watch);
  }
  return queue.finish();
}

int default_jobs() {
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

}  // namespace lineservo::apps
