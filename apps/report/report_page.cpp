#include "apps/report/report_page.h"

#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string_view>

#include "apps/config/program_files.h"

namespace lineservo::apps {
namespace {

constexpr std::string_view kTitlePlace = "@REPORT_TITLE@", kDataPlace = "@REPORT_DATA@";

std::string html_text(std::string_view text) {
  std::string html;
  for (const char c : text) {
    if (c == '&')
      html += "&amp;";
    else if (c == '<')
      html += "&lt;";
    else
      html += c;
  }
  return html;
}

/// JSON in which no browser sees the end of the script or a comment: '<' stands in its strings alone.
std::string script_json(std::string_view json) {
  std::string safe;
  safe.reserve(json.size());
  for (const char c : json) {
    if (c == '<')
      safe += "\\u003c";
    else
      safe += c;
  }
  return safe;
}

std::size_t place_of(const std::string& page, std::string_view place) {
  const std::size_t at = page.find(place);
  if (at == std::string::npos) throw std::logic_error("the report page has no " + std::string(place));
  return at;
}

}  // namespace

std::optional<std::string> find_report_page() {
  const auto page = find_program_file({"share/lineservo/report/page.html", "report/page.html"});
  if (!page) return std::nullopt;
  std::ifstream file(*page, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(file), {});
}

std::string filled_page(const std::string& page, const std::string& title, const std::string& data) {
  const std::size_t title_at = place_of(page, kTitlePlace), data_at = place_of(page, kDataPlace);
  const std::size_t after_title = title_at + kTitlePlace.size();
  return page.substr(0, title_at) + html_text(title) + page.substr(after_title, data_at - after_title) +
         script_json(data) + page.substr(data_at + kDataPlace.size());
}

}  // namespace lineservo::apps
