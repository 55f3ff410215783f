#include "apps/report/json_columns.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

namespace lineservo::apps {

void append_number(std::string& json, double value, int decimals) {
  if (!std::isfinite(value)) {
    json += "null";
    return;
  }
  const std::size_t begin = json.size();
  fmt::format_to(std::back_inserter(json), "{:.{}f}", value, decimals);
  if (decimals > 0) json.erase(json.find_last_not_of('0') + 1);
  if (json.back() == '.') json.pop_back();
  if (std::string_view(json).substr(begin) == "-0") json.replace(begin, 2, "0");
}

}  // namespace lineservo::apps
