#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "apps/compare/comparison.h"

namespace lineservo::apps {

/// What a comparison found, in every form that it is handed on in.
struct ComparisonResult {
  ComparisonOptions options;
  std::string preset;  ///< empty: none
  std::vector<Contestant> contestants;
};

/// comparison.json: numbers, or null where not applicable.
nlohmann::ordered_json comparison_json(const ComparisonResult& result);
/// comparison.csv: a line for each row of the table.
std::string comparison_csv(const ComparisonResult& result);
/// distribution.csv: a line for each bin of 5 cm of each row.
std::string distribution_csv(const ComparisonResult& result);

}  // namespace lineservo::apps
