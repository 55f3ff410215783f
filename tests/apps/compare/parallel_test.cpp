#include "apps/compare/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <numeric>
#include <stdexcept>
#include <thread>
#include <vector>

namespace lineservo::apps {
namespace {

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

TEST(DefaultJobs, IsAtLeastOne) {
  EXPECT_GE(default_jobs(), 1);
}

}  // namespace
}  // namespace lineservo::apps
