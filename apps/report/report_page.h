#pragma once

#include <optional>
#include <string>

namespace lineservo::apps {

/// The page that shows a report, built from apps/report/web. None when the build could not make it.
std::optional<std::string> find_report_page();

/// The page with the data of a flight or a comparison (JSON) in it: one file that needs no other. Throws
/// std::logic_error when the page has no place for it.
std::string filled_page(const std::string& page, const std::string& title, const std::string& data);

}  // namespace lineservo::apps
