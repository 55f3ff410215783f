#pragma once

#include <cstddef>
#include <functional>

namespace lineservo::apps {

/// Calls work(0) … work(count − 1), each once, on `jobs` threads of their own; work(i) must touch nothing
/// that another touches. `watch` is called now and then on this thread with how many are done; false stops:
/// what has begun is finished, no more is begun. Returns whether all were done. The first exception of
/// `work`, by index, is thrown on.
bool for_each_index(std::size_t count, int jobs, const std::function<void(std::size_t)>& work,
                    const std::function<bool(std::size_t done)>& watch);

/// As many as the processor has cores, at least 1.
int default_jobs();

}  // namespace lineservo::apps
