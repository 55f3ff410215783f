#pragma once

#include <string>
#include <string_view>

namespace lineservo::apps {

/// A number as the tables write it: that many decimals at most, no trailing zeros; null when it is not
/// finite.
void append_number(std::string& json, double value, int decimals);

/// "name":[…] of all rows, each a number that `value` takes from it.
template <class Rows, class Value>
void append_column(std::string& json, std::string_view name, const Rows& rows, int decimals, Value value) {
  json.append("\"").append(name).append("\":[");
  const char* separator = "";
  for (const auto& row : rows) {
    json += separator;
    append_number(json, value(row), decimals);
    separator = ",";
  }
  json += "]";
}

}  // namespace lineservo::apps
