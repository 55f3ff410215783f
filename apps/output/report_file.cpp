#include "apps/output/report_file.h"

#include <fmt/format.h>

#include "apps/report/report_page.h"

namespace lineservo::apps {

bool write_report(ResultFolder& folder, const std::string& title, const std::function<std::string()>& data) {
  if (const auto page = find_report_page()) {
    folder.write(kReportFile, filled_page(*page, title, data()));
    return true;
  }
  folder.leave_out(kReportFile);
  fmt::print(stderr,
             "lineservo: report.html is not written: its page was not built, which needs npm; "
             "cmake --build build/release --target report_page tells more\n");
  return false;
}

}  // namespace lineservo::apps
