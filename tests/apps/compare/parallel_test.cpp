#include "apps/compare/parallel.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <pthread.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <latch>
#include <limits>
#include <mutex>
#include <new>
#include <numeric>
#include <opencv2/core.hpp>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

#include "tests/apps/test_files.h"

namespace lineservo::apps {
namespace {

using ::testing::AllOf;
using testing::complaint;
using ::testing::HasSubstr;

bool go_on(std::size_t) {
  return true;
}

TEST(ForEachIndex, CallsEveryIndexOnceWhateverTheThreads) {
  for (const int jobs : {1, 2, 7, 40}) {
    std::vector<int> calls(20, 0);
    EXPECT_TRUE(for_each_index(
        calls.size(), jobs, [&](std::size_t i) { ++calls[i]; }, go_on));
    EXPECT_EQ(calls, std::vector<int>(20, 1)) << jobs;
  }
}

TEST(ForEachIndex, NothingToDoIsDone) {
  EXPECT_TRUE(for_each_index(
      0, 2, [](std::size_t) { FAIL(); }, go_on));
}

TEST(ForEachIndex, StopsWhenTheWatchSaysSo) {
  std::atomic<int> calls = 0;
  const auto work = [&](std::size_t) {
    ++calls;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  };
  EXPECT_FALSE(for_each_index(100000, 2, work, [&](std::size_t) { return calls < 5; }));
  EXPECT_GE(calls, 5);
  EXPECT_LT(calls, 100000);
}

TEST(ForEachIndex, ThrowsOnTheFirstFailure) {
  const auto work = [](std::size_t i) {
    if (i >= 3) throw std::runtime_error(std::to_string(i));
  };
  try {
    for_each_index(10, 1, work, go_on);
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "3");
  }
}

/// Threads that are made as long as it lives ask for a stack that no machine has.
class NoMoreThreads {
 public:
  NoMoreThreads() {
    ::pthread_attr_init(&before_);
    ::pthread_getattr_default_np(&before_);
    pthread_attr_t huge;
    ::pthread_attr_init(&huge);
    ::pthread_attr_setstacksize(&huge, std::size_t{1} << 47);
    ::pthread_setattr_default_np(&huge);
    ::pthread_attr_destroy(&huge);
  }
  ~NoMoreThreads() {
    ::pthread_setattr_default_np(&before_);
    ::pthread_attr_destroy(&before_);
  }
  NoMoreThreads(const NoMoreThreads&) = delete;
  NoMoreThreads& operator=(const NoMoreThreads&) = delete;

 private:
  pthread_attr_t before_;
};

TEST(ForEachIndex, ThreadsThatCannotBeMadeAreBadInputAndNothingIsBegun) {
  const NoMoreThreads none;
  EXPECT_THAT(complaint([] {
                for_each_index(
                    5, 4, [](std::size_t) { FAIL(); }, go_on);
              }),
              AllOf(HasSubstr("--jobs 4"), HasSubstr("only 0")));
}

TEST(ForEachIndex, MakesNoMoreThreadsThanThereIsWork) {
  std::mutex mutex;
  std::set<std::thread::id> threads;
  std::latch all_here(3);
  const auto work = [&](std::size_t) {
    all_here.arrive_and_wait();
    const std::lock_guard lock(mutex);
    threads.insert(std::this_thread::get_id());
  };
  EXPECT_TRUE(for_each_index(3, std::numeric_limits<int>::max(), work, go_on));
  EXPECT_EQ(threads.size(), 3u);
}

TEST(ForEachIndex, MemoryThatDoesNotSufficeIsBadInput) {
  const auto no_memory = [](std::size_t) { throw std::bad_alloc(); };
  const auto no_image = [](std::size_t) { CV_Error(cv::Error::StsNoMem, "Failed to allocate"); };
  for (const std::function<void(std::size_t)>& work :
       {std::function<void(std::size_t)>(no_memory), {no_image}})
    EXPECT_THAT(complaint([&] { for_each_index(5, 2, work, go_on); }),
                AllOf(HasSubstr("--jobs 2"), HasSubstr("memory")));
}

TEST(DefaultJobs, IsAtLeastOne) {
  EXPECT_GE(default_jobs(), 1);
}

}  // namespace
}  // namespace lineservo::apps
