#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "apps/evaluate/line_evaluation.h"

namespace lineservo::apps {

/// evaluation.json of `evaluate lines`: settings, one object a row, and the published figures beside.
nlohmann::ordered_json lines_json(const LineEvaluationOptions& options,
                                  const std::vector<LineEvaluationRow>& rows);
/// evaluation.csv: one line a row, units in the header.
std::string lines_csv(const std::vector<LineEvaluationRow>& rows);
/// The table to read, published figures beside.
std::string lines_table(const std::vector<LineEvaluationRow>& rows);

}  // namespace lineservo::apps
