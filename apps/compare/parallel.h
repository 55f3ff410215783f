#pragma once

#include <cstddef>
#include <functional>

namespace lineservo::apps {

/// Calls work(0) … work(count − 1), each once, on up to `jobs` threads of their own; work(i) must touch
/// nothing that another touches. `watch` is called now and then on this thread with how many are done; false
/// stops: what has begun is finished, no more is begun. Returns whether all were done. The first exception of
/// `work`, by index, is thrown on. Throws InputError when the threads cannot be made or memory runs out.
bool for_each_index(std::size_t count, int jobs, const std::function<void(std::size_t)>& work,
                    const std::function<bool(std::size_t done)>& watch);

/// More than any machine has cores for, and few enough for one to have the memory.
inline constexpr int kMostJobs = 256;

/// As many as the processor has cores, at least 1.
int default_jobs();

}  // namespace lineservo::apps
