#include "apps/compare/parallel.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <new>
#include <opencv2/core.hpp>
#include <thread>
#include <vector>

#include "apps/config/input_error.h"

namespace lineservo::apps {
namespace {

constexpr const char* kNoMemory = "the memory does not suffice for so many at a time";
constexpr auto kWatchPeriod = std::chrono::milliseconds(100);

/// The indices that are left, what is done, and the first failure.
class Queue {
 public:
  explicit Queue(std::size_t count) : count_(count), failures_(count) {}

  /// Waits until the work is begun.
  void work_off(const std::function<void(std::size_t)>& work) {
    begun_.wait(false);
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

  std::size_t count() const { return count_; }
  void begin() {
    begun_ = true;
    begun_.notify_all();
  }
  void stop() { stopped_ = true; }

  bool finish() const {
    for (const std::exception_ptr& failure : failures_) {
      if (failure) std::rethrow_exception(failure);
    }
    return done_ == count_;
  }

 private:
  const std::size_t count_;
  std::atomic<std::size_t> next_ = 0;
  std::atomic<bool> begun_ = false, stopped_ = false;
  std::vector<std::exception_ptr> failures_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::size_t done_ = 0;
  int workers_ = 0;  ///< below zero while some have ended before the watch began
};

[[noreturn]] void refuse_jobs(int jobs, const std::string& why) {
  throw InputError(fmt::format("--jobs {}: {}; fewer are allowed", jobs, why));
}

/// No more than there is work. None begins before all are made: the memory that the last ones lack would be
/// lacking in the midst of a flight.
std::vector<std::jthread> make_threads(int jobs, Queue& queue, const std::function<void(std::size_t)>& work) {
  const std::size_t wanted = std::min(queue.count(), static_cast<std::size_t>(jobs));
  std::vector<std::jthread> threads;
  try {
    while (threads.size() < wanted) threads.emplace_back([&] { queue.work_off(work); });
  } catch (const std::exception&) {  // std::system_error, or std::bad_alloc
    queue.stop();
    queue.begin();
    refuse_jobs(jobs, fmt::format("only {} threads can be made here", threads.size()));
  }
  queue.begin();
  return threads;
}

bool finish(const Queue& queue, int jobs) try { return queue.finish(); } catch (const std::bad_alloc&) {
  refuse_jobs(jobs, kNoMemory);
} catch (const cv::Exception& fault) {
  if (fault.code == cv::Error::StsNoMem) refuse_jobs(jobs, kNoMemory);
  throw;
}

}  // namespace

bool for_each_index(std::size_t count, int jobs, const std::function<void(std::size_t)>& work,
                    const std::function<bool(std::size_t)>& watch) {
  Queue queue(count);
  {
    const std::vector<std::jthread> threads = make_threads(jobs, queue, work);
    queue.watch_over(static_cast<int>(threads.size()), watch);
  }
  return finish(queue, jobs);
}

int default_jobs() {
  return std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, kMostJobs);
}

}  // namespace lineservo::apps
