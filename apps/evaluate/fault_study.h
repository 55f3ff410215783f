#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "apps/evaluate/fault_cases.h"
#include "apps/scoring/safety.h"

namespace lineservo::apps {

/// Which faults are flown, by whom and how often.
struct FaultStudyOptions {
  std::vector<std::string> instructions = {"a03", "a13", "a53", "b02", "b03", "c03", "c05", "d00"};
  std::vector<std::string> faults;  ///< names of the cases; none: all
  std::string controller = "ibvs";
  std::string conditions = "paper";
  std::vector<std::string> overrides;  ///< KEY=VALUE, for every flight
  int runs = 20;                       ///< flights of each fault
  std::uint64_t seed = 1;              ///< of the first
};

/// One flight in which something went wrong.
struct FaultFlight {
  std::string instruction;
  std::uint64_t seed = 0;
  std::string command;  ///< flies it again
  std::string outcome;
  Safety safety;
};

/// A fault and the flights that had it.
struct FaultRow {
  std::string name;
  std::vector<FaultFlight> flights;
};

/// Flies every fault so many times, each flight with an instruction, a time and a place of its own, on so
/// many threads. None when `watch`, told how many flights are done of how many, returned false. Throws
/// InputError or std::invalid_argument.
std::optional<std::vector<FaultRow>> study_faults(
    const FaultStudyOptions& options, int jobs,
    const std::function<bool(std::size_t done, std::size_t all)>& watch);

}  // namespace lineservo::apps
