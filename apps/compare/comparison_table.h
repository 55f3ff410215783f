#pragma once

#include <string>

#include "apps/compare/comparison_report.h"

namespace lineservo::apps {

/// The comparison for the terminal: a table for each group with the published figures in it, the paired
/// differences, the adaptations, and how to fly again what failed.
std::string comparison_table(const ComparisonResult& result);

/// How the errors of each row are distributed, a bar for each 5 cm.
std::string error_histogram(const ComparisonResult& result);

}  // namespace lineservo::apps
