#pragma once

#include <functional>
#include <string>

#include "apps/output/result_folder.h"

namespace lineservo::apps {

inline constexpr const char* kReportFile = "report.html";

/// Writes report.html aside. Where the program has no page for it, says so on stderr in one line and returns
/// false; an earlier report goes when the folder is published.
bool write_report(ResultFolder& folder, const std::string& title, const std::function<std::string()>& data);

}  // namespace lineservo::apps
