#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "apps/evaluate/fault_study.h"

namespace lineservo::apps {

/// How many of the flights ended safely.
long safe_endings(const FaultRow& row);
bool all_safe(const std::vector<FaultRow>& rows);

/// A table for the terminal, with the commands of flights that did not end safely.
std::string fault_table(const std::vector<FaultRow>& rows);
nlohmann::ordered_json fault_json(const FaultStudyOptions& options, const std::vector<FaultRow>& rows);
std::string fault_csv(const std::vector<FaultRow>& rows);

}  // namespace lineservo::apps
