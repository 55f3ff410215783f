#pragma once

#include <string>

#include "apps/compare/comparison_report.h"

namespace lineservo::apps {

/// What the report of a comparison shows, as JSON: comparison.json, how the errors of each row are
/// distributed, floors, and of the first run of each row and instruction the path, the error and the codes.
std::string comparison_data(const ComparisonResult& result);

}  // namespace lineservo::apps
